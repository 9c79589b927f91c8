"""Configurations of rqt_multiplot, in the form in which that program saves them.

The form is that of Qt's settings: an element for each group and for each value in it, no attributes. What is read, and
the numbers of its enumerations, is defined by the ``load`` functions of rqt_multiplot's ``*Config`` classes.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any, Dict, Mapping, Optional, Sequence, Tuple
from xml.etree import ElementTree

from mrta_alliance.xml_text import document, plain

__all__ = ["PlotCurve", "RowPlot", "multiplot_file"]

_Group = Mapping[str, Any]
"""Texts by name, or groups by name again."""

_AUTO, _ABSOLUTE, _RELATIVE = "0", "1", "2"  # CurveAxisScaleConfig::Type
_MESSAGE_DATA = "0"  # CurveAxisConfig::FieldType
_CUSTOM_TITLE = "1"  # PlotAxisConfig::TitleType
_CUSTOM_COLOUR = "1"  # CurveColorConfig::Type
_VECTOR = "0"  # CurveDataConfig::Type
_LINES = "0"  # CurveStyleConfig::Type
_SOLID, _DASHED = "1", "2"  # Qt::PenStyle
_VERTICAL = "2"  # Qt::Orientation
_SHOWN_SECONDS = "-100"


@dataclass(frozen=True)
class PlotCurve:
    """One curve over the stamps of its messages.

    Attributes:
        title: as in the legend.
        field: of the message.
        colour: ``#rrggbb``.
        dashed: whether its line is.
        limits: of its values' axis; None: as the values want it.
    """

    title: str
    field: str
    colour: str = "#0000ff"
    dashed: bool = False
    limits: Optional[Tuple[str, str]] = None


@dataclass(frozen=True)
class RowPlot:
    """One plot, as wide as the window; plots stand below one another.

    Attributes:
        title: above it.
        y_title: of its vertical axis.
        topic: of all its curves.
        type: of their messages.
        curves: of the plot.
        named: whether legend and titles of axes are shown.
    """

    title: str
    y_title: str
    topic: str
    type: str
    curves: Tuple[PlotCurve, ...]
    named: bool = True


def multiplot_file(plots: Sequence[RowPlot]) -> bytes:
    """Write a configuration.

    Args:
        plots: from top to bottom.

    Returns:
        The content of a file that rqt_multiplot opens.
    """
    # Rows are read in the order of their names as texts, not of their numbers.
    digits = len(str(max(len(plots) - 1, 0)))
    rows = {f"row_{number:0{digits}}": {"column_0": _plot(plot)} for number, plot in enumerate(plots)}
    table = {
        "background_color": "#ffffff",
        "foreground_color": "#000000",
        "link_cursor": "false",
        "link_scale": "false",
        "plots": rows,
        "track_points": "false",
    }
    root = ElementTree.Element("rqt_multiplot")
    _fill(root, {"table": table})
    return document(root)


def _plot(plot: RowPlot) -> _Group:
    shown = "true" if plot.named else "false"

    def titled(words: str) -> _Group:
        return {"custom_title": words, "title_type": _CUSTOM_TITLE, "title_visible": shown}

    return {
        "axes": {"axes": {"x_axis": titled("Timestamp"), "y_axis": titled(plot.y_title)}},
        "curves": {f"curve_{number}": _curve(plot, curve) for number, curve in enumerate(plot.curves)},
        "legend": {"visible": shown},
        "plot_rate": "30",
        "title": plot.title,
    }


def _curve(plot: RowPlot, curve: PlotCurve) -> _Group:
    low, high = curve.limits or ("0", "1000")
    times = _axis(plot, "header/stamp", _scale(_RELATIVE, "0", "1000", _SHOWN_SECONDS))
    values = _axis(plot, curve.field, _scale(_ABSOLUTE if curve.limits else _AUTO, low, high, "-1000"))
    return {
        "axes": {"x_axis": times, "y_axis": values},
        "color": {"custom_color": curve.colour, "type": _CUSTOM_COLOUR},
        "data": {"circular_buffer_capacity": "1000", "time_frame_length": "10", "type": _VECTOR},
        "style": {
            "lines_interpolate": "false",
            "pen_style": _DASHED if curve.dashed else _SOLID,
            "pen_width": "2",
            "render_antialias": "false",
            "steps_invert": "false",
            "sticks_baseline": "0",
            "sticks_orientation": _VERTICAL,
            "type": _LINES,
        },
        "subscriber_queue_size": "100",
        "title": curve.title,
    }


def _axis(plot: RowPlot, field: str, scale: _Group) -> _Group:
    return {"field": field, "field_type": _MESSAGE_DATA, "scale": scale, "topic": plot.topic, "type": plot.type}


def _scale(kind: str, low: str, high: str, back: str) -> Dict[str, str]:
    return {
        "absolute_maximum": high,
        "absolute_minimum": low,
        "relative_maximum": "0",
        "relative_minimum": back,
        "type": kind,
    }


def _fill(parent: ElementTree.Element, group: _Group) -> None:
    for name, value in group.items():
        element = ElementTree.SubElement(parent, name)
        if isinstance(value, str):
            element.text = plain(value)
        else:
            _fill(element, value)
