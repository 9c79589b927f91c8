"""A layout of PlotJuggler: which curves of a bag to show where."""

from __future__ import annotations

from typing import NamedTuple, Sequence, Tuple
from xml.etree import ElementTree

from mrta_alliance.xml_text import document, plain

__all__ = ["LayoutCurve", "LayoutPlot", "LayoutTab", "layout_file"]

_VERSION = "2.3.8"
"""PlotJuggler 3 asks before it opens a layout of another version."""


class LayoutCurve(NamedTuple):
    """One curve: its name, which is topic and field joined by ``/``, and its colour ``#rrggbb``."""

    name: str
    colour: str


class LayoutPlot(NamedTuple):
    """One plot: its title and curves."""

    title: str
    curves: Tuple[LayoutCurve, ...]


class LayoutTab(NamedTuple):
    """One tab: its name, and plots from top to bottom, one at the least."""

    name: str
    plots: Tuple[LayoutPlot, ...]


def layout_file(tabs: Sequence[LayoutTab]) -> bytes:
    """Write a layout.

    Args:
        tabs: one at the least.

    Returns:
        The content of a file that PlotJuggler opens once the bag's topics are loaded.
    """
    root = ElementTree.Element("root", version=_VERSION)
    window = ElementTree.SubElement(root, "tabbed_widget", {"name": "Main Window", "parent": "main_window"})
    for tab in tabs:
        _add_tab(window, tab)
    ElementTree.SubElement(window, "currentTabIndex", index="0")
    ElementTree.SubElement(root, "use_relative_time_offset", enabled="1")
    return document(root)


def _add_tab(window: ElementTree.Element, tab: LayoutTab) -> None:
    page = ElementTree.SubElement(window, "Tab", tab_name=plain(tab.name), containers="1")
    count = len(tab.plots)
    sizes = ";".join([f"{1.0 / count:.6f}"] * count)
    container = ElementTree.SubElement(page, "Container")
    column = ElementTree.SubElement(container, "DockSplitter", orientation="-", count=str(count), sizes=sizes)
    for plot in tab.plots:
        area = ElementTree.SubElement(column, "DockArea", name=plain(plot.title))
        inner = ElementTree.SubElement(area, "plot", mode="TimeSeries", style="Lines", flip_x="false", flip_y="false")
        ElementTree.SubElement(inner, "limitY")
        for curve in plot.curves:
            ElementTree.SubElement(inner, "curve", name=plain(curve.name), color=curve.colour)
