"""An architecture's curves over the whole mission, one chart a group, all on the same time axis."""

from __future__ import annotations

from typing import List, Sequence, Tuple

from rqt_mrta_py.hooks import CurveGroup, CurvePanel
from rqt_mrta_py.render.canvas import Box
from rqt_mrta_py.render.charts.sheet import Sheet, rgb
from rqt_mrta_py.render.curve_axes import MOST_GROUPS, value_axis, value_labels
from rqt_mrta_py.render.palette import INK, MUTED, RED
from rqt_mrta_py.render.text import Style, shorten, text_width
from rqt_mrta_py.render.times import number

__all__ = ["draw_traces", "draw_traces_legend", "traced"]

_NAME = Style(13, bold=True)
_SMALL = Style(12)
_GAP = 8.0


def traced(panels: Sequence[CurvePanel], most: int) -> List[Tuple[CurvePanel, CurveGroup]]:
    """List the charts that are shown, each with its panel.

    Args:
        panels: of a view.
        most: charts at most.
    """
    return [(panel, group) for panel in panels for group in panel.groups][:most]


def draw_traces(sheet: Sheet, box: Box, charts: Sequence[Tuple[CurvePanel, CurveGroup]]) -> None:
    """Draw charts below one another.

    Args:
        sheet: drawn upon.
        box: that they share.
        charts: those shown, one or more.
    """
    height = (box.height + _GAP) / len(charts)
    for index, (panel, group) in enumerate(charts):
        top = box.top + index * height
        place = Box(box.left, top, box.right, top + height - _GAP)
        axes = sheet.time_axes(place)
        top_value, reference = value_axis(panel)
        axes.set_ylim(0.0, top_value)
        for curve in group.curves:
            axes.plot(curve.times, curve.values, color=rgb(sheet.colours[curve.label]), linewidth=1.2)
        if reference is not None:
            axes.axhline(reference, color=rgb(RED), linewidth=0.9, linestyle=(0, (4, 3)))
        sheet.text(box.left - 34.0, place.centre[1], shorten(group.label, _NAME, 96.0), _NAME, INK, "right")
        for value in value_labels(top_value, reference):
            y = place.bottom - place.height * value / top_value
            y = min(max(y, place.top + 5.0), place.bottom - 5.0)
            if value or place.height > 24.0:
                sheet.text(box.left - 6.0, y, number(value), _SMALL, MUTED, "right")


def draw_traces_legend(sheet: Sheet, y: float, left: float, right: float) -> None:
    """Name the curves' colours in one line.

    Args:
        sheet: drawn upon.
        y: middle of the line [pixels].
        left: where the line must not reach [pixels].
        right: end of the line [pixels].
    """
    panels = sheet.view.panels
    marked = [value_axis(panel)[1] for panel in panels[:1]]
    references = [f"reference {number(value)}" for value in marked if value is not None]
    labels = list(dict.fromkeys(c.label for p in panels for group in p.groups[:MOST_GROUPS] for c in group.curves))
    entries = [(label, "━", sheet.colours[label]) for label in labels] + [(words, "┅", RED) for words in references]
    x = right
    for done, (label, sign, colour) in enumerate(reversed(entries)):
        words = shorten(label, _SMALL, 140.0)
        if x - text_width(words, _SMALL) - 60.0 < left:
            sheet.text(x, y, f"+{len(entries) - done}", _SMALL, MUTED, "right")
            return
        sheet.text(x, y, words, _SMALL, INK, "right")
        x -= text_width(words, _SMALL) + 4.0
        sheet.text(x, y, sign * 2, _SMALL, colour, "right")
        x -= 30.0
