"""Small charts of an architecture's inner life."""

from __future__ import annotations

from array import array
from bisect import bisect_left
from itertools import accumulate
from typing import TYPE_CHECKING, Dict, Iterator, List, NamedTuple, Optional, Sequence, Tuple

import numpy as np

from rqt_mrta_py.hooks import Curve, CurvePanel
from rqt_mrta_py.render.canvas import Box, Canvas
from rqt_mrta_py.render.curve_axes import (
    MOST_GROUPS,
    cells,
    curve_titles,
    curves_boxes,
    share_out,
    time_window,
    value_axis,
    value_labels,
)
from rqt_mrta_py.render.layout import CURVES, PLAIN, SMALL, TITLE, inside
from rqt_mrta_py.render.page import Page, Part
from rqt_mrta_py.render.palette import FAINT, GRID, INK, MUTED, RED, WHITE, Colour
from rqt_mrta_py.render.text import Style, shorten, text_width
from rqt_mrta_py.render.times import Axis, TimeAxis, number

if TYPE_CHECKING:
    from numpy.typing import NDArray

__all__ = ["curves_part", "fresh_curves_parts"]

_NAME = Style(12, bold=True)
_THICK_FROM = 60.0
_TIME_FROM = 10.0
_KEY, _BETWEEN_KEYS, _LEAST_KEY = 17.0, 13.0, 76.0


class _Line(NamedTuple):
    """Points of one curve: in which chart, in which colour, times and values as doubles.

    As bytes they compare quickly, and NaN equals NaN.
    """

    chart: int
    colour: Colour
    times: bytes
    values: bytes


class _Panel(NamedTuple):
    """One panel up to the last whole second: its place, title and colours' names, its charts, and what they share."""

    box: Box
    title: str
    legend: Tuple[Tuple[str, Colour], ...]
    charts: Tuple[str, ...]
    groups: int
    axis: TimeAxis
    top: float
    reference: Optional[float]
    lines: Tuple[_Line, ...]

    @property
    def room(self) -> Box:
        """Give what the charts share."""
        return inside(self.box).inset(24, 0, 0, 16)

    def places(self) -> List[Box]:
        """Give the place of each chart."""
        if not self.charts:
            return []
        room = self.room
        columns, lines = cells(room, len(self.charts))
        width, height = room.width / columns, room.height / lines
        places = []
        for index in range(len(self.charts)):
            left, top = room.left + index % columns * width, room.top + index // columns * height
            places.append(Box(round(left) + 2, round(top) + 17, round(left + width) - 6, round(top + height) - 4))
        return places

    def up(self, cell: Box) -> Axis:
        """Give the scale of values in a chart."""
        return Axis(0.0, self.top, cell.bottom - 1.0, cell.top)


def curves_part(page: Page) -> Part:
    """Say what the panels look like, side by side, each a grid of small charts; curves up to the last whole second.

    Args:
        page: the mission.
    """
    return Part(CURVES, _panels(page), _draw_panels)


def fresh_curves_parts(page: Page, part: Part) -> Tuple[Part, ...]:
    """Say what ``curves_part`` leaves out: the ends of curves after the last whole second, if there are any.

    Args:
        page: the mission.
        part: the panels, which lie below.
    """
    panels: Tuple[_Panel, ...] = part.content
    fresh: List[Tuple[_Panel, Tuple[_Line, ...]]] = []
    for panel, curves in zip(panels, page.view.panels):
        ends = []
        for chart, curve in _curves(curves):
            first, last = _settled(page, curve)
            if last < len(curve.times):
                ends.append(_line(page, chart, curve, max(last - 1, first), len(curve.times)))
        if ends:
            fresh.append((panel, tuple(ends)))
    return (Part(CURVES, tuple(fresh), _draw_ends),) if fresh else ()


def _curves(curves: CurvePanel) -> List[Tuple[int, Curve]]:
    """List the curves that are shown, each with the number of its chart."""
    groups = enumerate(curves.groups[:MOST_GROUPS])
    return [(chart, curve) for chart, group in groups for curve in group.curves if curve.times]


def _settled(page: Page, curve: Curve) -> Tuple[int, int]:
    """Give the first point of a curve, and the one after the last, that stay there until the next whole second."""
    first = bisect_left(curve.times, page.minute_ago)
    return first, max(bisect_left(curve.times, page.settled), first)


def _panels(page: Page) -> Tuple[_Panel, ...]:
    view = page.view
    if not view.panels:
        return ()
    titles = curve_titles(view.panels)
    panels = []
    for box, title, curves in zip(curves_boxes(len(titles)), titles, view.panels):
        shown = curves.groups[:MOST_GROUPS]
        # Colours recur where tasks are many: a name without its curve would pass for that of another one.
        labels = dict.fromkeys(curve.label for _, curve in _curves(curves) if curve.times[-1] >= page.minute_ago)
        panels.append(
            _Panel(
                box,
                title,
                tuple((label, page.colours[label]) for label in labels),
                tuple(group.label for group in shown),
                len(curves.groups),
                time_window(page, curves),
                *value_axis(curves),
                tuple(_settled_lines(page, curves)),
            )
        )
    return tuple(panels)


def _settled_lines(page: Page, curves: CurvePanel) -> Iterator[_Line]:
    for chart, curve in _curves(curves):
        first, last = _settled(page, curve)
        if last > first:
            yield _line(page, chart, curve, first, last)


def _line(page: Page, chart: int, curve: Curve, first: int, last: int) -> _Line:
    times, values = array("d", curve.times[first:last]), array("d", curve.values[first:last])
    return _Line(chart, page.colours[curve.label], times.tobytes(), values.tobytes())


def _draw_ends(canvas: Canvas, fresh: Sequence[Tuple[_Panel, Sequence[_Line]]]) -> None:
    for panel, lines in fresh:
        _draw_lines(canvas, panel, lines)


def _draw_panels(canvas: Canvas, panels: Tuple[_Panel, ...]) -> None:
    if not panels:
        box = inside(CURVES)
        canvas.text(box.left, box.top + 14, "this architecture tells no curves", PLAIN, MUTED, WHITE)
    for panel in panels:
        _draw_legend(canvas, panel)
        _draw_charts(canvas, panel)


def _draw_charts(canvas: Canvas, panel: _Panel) -> None:
    room = panel.room
    if not panel.charts:
        canvas.text(panel.box.left + 12, room.top + 14, "nothing heard yet", PLAIN, MUTED, WHITE)
        return
    columns, _ = cells(room, len(panel.charts))
    for index, (label, cell) in enumerate(zip(panel.charts, panel.places())):
        last = index + columns >= len(panel.charts)
        _draw_axes(canvas, cell, panel, first=index % columns == 0, last=last)
        canvas.text(cell.left, cell.top - 9, shorten(label, _NAME, cell.width), _NAME, INK, WHITE)
        if panel.reference is not None:
            canvas.dashes(cell.left, cell.right, panel.up(cell)(panel.reference), RED)
    _draw_lines(canvas, panel, panel.lines)
    canvas.text(panel.box.left + _TIME_FROM, room.bottom + 8, _time_name(panel), SMALL, MUTED, WHITE)
    if panel.groups > len(panel.charts):
        words = f"+{panel.groups - len(panel.charts)} more"
        canvas.text(room.right, panel.box.top + 37, words, SMALL, MUTED, WHITE, anchor=1.0)


def _time_name(panel: _Panel) -> str:
    return f"t [{panel.axis.unit}]"


def _draw_legend(canvas: Canvas, panel: _Panel) -> None:
    """Name reference and colours from right to left; names are shortened, and left out, where room is short."""
    box = panel.box.inset(24.0 + text_width(panel.title, TITLE), 0, 12, 0)
    y, x = box.top + 15.0, box.right
    if panel.reference is not None:
        words = f"reference {number(panel.reference)}"
        if x - text_width(words, SMALL) - _KEY - 4.0 >= box.left:
            x -= canvas.text(x, y, words, SMALL, INK, WHITE, anchor=1.0) + 4.0
            canvas.dashes(x - _KEY, x, y, RED, 3)
            x -= _KEY + _BETWEEN_KEYS
    room = x - box.left - len(panel.legend) * (_KEY + 4.0 + _BETWEEN_KEYS)
    widest = share_out([text_width(label, SMALL) for label, _ in panel.legend], room)
    for done, (label, colour) in enumerate(reversed(panel.legend)):
        words = shorten(label, SMALL, max(widest, _LEAST_KEY))
        room_for_rest = 0.0 if done == len(panel.legend) - 1 else 30.0
        if x - text_width(words, SMALL) - _KEY - 4.0 - room_for_rest < box.left:
            rest = f"+{len(panel.legend) - done}"
            if x - text_width(rest, SMALL) >= box.left:
                canvas.text(x, y, rest, SMALL, MUTED, WHITE, anchor=1.0)
            return
        x -= canvas.text(x, y, words, SMALL, INK, WHITE, anchor=1.0) + 4.0
        canvas.fill(Box(x - _KEY, y - 1, x, y + 2), colour)
        x -= _KEY + _BETWEEN_KEYS


def _draw_axes(canvas: Canvas, box: Box, panel: _Panel, *, first: bool, last: bool) -> None:
    """Draw ground, grid and labels; values on the first of a line only, times on the last of a column only."""
    canvas.fill(box, FAINT)
    axis = panel.axis
    across = TimeAxis(axis.low, axis.high, box.left, box.right - 1.0, axis.zero)
    ticks = [(across(time), label) for time, label in across.ticks(max(2, min(int(box.width / 40.0), 7)))]
    for column, _ in ticks:
        canvas.fill(Box(round(column), box.top, round(column) + 1, box.bottom), GRID)
    if last:
        # A label must run neither into one of the next chart nor into the name of the axis.
        name_end = panel.box.left + _TIME_FROM + text_width(_time_name(panel), SMALL) + 4.0
        room_to = box.right
        for column, label in reversed(ticks):
            half = text_width(label, SMALL) / 2.0
            middle = max(min(column, box.right - half), max(box.left, name_end) + half)
            if middle + half <= room_to:
                canvas.text(middle, box.bottom + 10, label, SMALL, MUTED, WHITE, anchor=0.5)
                room_to = middle - half - 2.0
    canvas.frame(box, GRID)
    up = panel.up(box)
    if first:
        for value in value_labels(panel.top, panel.reference):
            canvas.text(box.left - 5, up(value), number(value), SMALL, MUTED, WHITE, anchor=1.0)


def _draw_lines(canvas: Canvas, panel: _Panel, lines: Sequence[_Line]) -> None:
    """Draw lines in a panel's charts, which are of equal size; those of one colour together."""
    if not lines:
        return
    places = panel.places()
    lengths = [len(line.times) // 8 for line in lines]
    points = _points(panel, lines, places[0])
    corners = np.array([(places[line.chart].left, places[line.chart].top) for line in lines], dtype=np.float64)
    points += np.repeat(corners, lengths, axis=0)
    by_colour: Dict[Colour, List[Tuple[int, int]]] = {}
    for line, length, end in zip(lines, lengths, accumulate(lengths)):
        by_colour.setdefault(line.colour, []).append((end - length, end))
    canvas.broken_lines(points, by_colour, 2 if places[0].height >= _THICK_FROM else 1)


def _points(panel: _Panel, lines: Sequence[_Line], cell: Box) -> NDArray[np.float64]:
    """Give the points of lines, one after the other, in pixels from a chart's upper left corner.

    Args:
        panel: for its axes.
        lines: one or more.
        cell: a chart, for its size.

    Returns:
        Points (points, 2), none outside the chart; the second is NaN where a stroke ends.
    """
    across = np.frombuffer(b"".join([line.times for line in lines]), np.float64)
    up = np.frombuffer(b"".join([line.values for line in lines]), np.float64)
    axis = panel.axis
    points: NDArray[np.float64] = np.empty((len(across), 2), dtype=np.float64)
    points[:, 0] = ((across - axis.low) / (axis.high - axis.low)).clip(0.0, 1.0) * (cell.width - 1.0)
    points[:, 1] = (1.0 - (up / panel.top).clip(0.0, 1.0)) * (cell.height - 1.0)
    points[np.isnan(across), 1] = np.nan
    return points
