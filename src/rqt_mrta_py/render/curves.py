"""Small charts of an architecture's inner life."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, Sequence, Tuple

import numpy as np

from rqt_mrta_py.hooks import Curve, CurveGroup, CurvePanel, MonitorView
from rqt_mrta_py.render.canvas import Box, Canvas
from rqt_mrta_py.render.layout import CURVES, PLAIN, SMALL, TITLE, inside
from rqt_mrta_py.render.page import Page
from rqt_mrta_py.render.palette import FAINT, GRID, INK, MUTED, RED, WHITE
from rqt_mrta_py.render.text import Style, shorten, text_width
from rqt_mrta_py.render.times import Axis, TimeAxis, number

if TYPE_CHECKING:
    from numpy.typing import NDArray

__all__ = ["cells", "curve_titles", "curves_boxes", "draw_curves", "share_out", "time_window", "value_labels"]

_MOST_PANELS = 2
_MOST_GROUPS = 12
_SHORTEST = 10.0
_GAP = 10.0
_NAME = Style(12, bold=True)
_THICK_FROM = 60.0
_KEY, _BETWEEN_KEYS, _LEAST_KEY = 17.0, 13.0, 76.0


def curve_titles(panels: Sequence[CurvePanel]) -> Tuple[str, ...]:
    """Give the titles of the panels that are shown, with the unit of their values.

    Args:
        panels: of a view.

    Returns:
        One title or two.
    """
    if not panels:
        return ("Curves",)
    return tuple(p.title if p.unit in ("", "1") else f"{p.title} [{p.unit}]" for p in panels[:_MOST_PANELS])


def curves_boxes(count: int) -> Tuple[Box, ...]:
    """Give the places of so many panels, side by side."""
    width = (CURVES.width - _GAP * (count - 1)) / count
    lefts = [round(CURVES.left + index * (width + _GAP)) for index in range(count)]
    return tuple(Box(left, CURVES.top, left + int(width), CURVES.bottom) for left in lefts)


def cells(box: Box, count: int) -> Tuple[int, int]:
    """Arrange small charts.

    Args:
        box: that they share.
        count: of charts, one or more.

    Returns:
        Columns and rows, such that a chart is large and rather wider than high.
    """

    def size(columns: int) -> float:
        return min(box.width / columns / 1.5, box.height / math.ceil(count / columns))

    columns = max(range(1, count + 1), key=lambda columns: (round(size(columns), 3), -columns))
    return columns, math.ceil(count / columns)


def share_out(widths: Sequence[float], room: float) -> float:
    """Give the width to which the widest of some things must shrink so that all find room side by side.

    Args:
        widths: of the things.
        room: for all of them together.

    Returns:
        The most that one of them may take; the widest's own width if all fit.
    """
    left = room
    for done, width in enumerate(sorted(widths)):
        most = left / (len(widths) - done)
        if width > most:
            return most
        left -= width
    return max(widths, default=room)


def value_labels(curves: CurvePanel) -> Tuple[float, ...]:
    """Give the values to be written on an axis: 0 and its top, or the reference if that is close to the top.

    Args:
        curves: the panel.
    """
    reference = curves.reference
    return 0.0, reference if reference is not None and 0.8 * curves.top <= reference <= curves.top else curves.top


def time_window(view: MonitorView, curves: CurvePanel) -> TimeAxis:
    """Give the times that curves are drawn over: from their first point on, ten seconds or more, none before the start.

    Args:
        view: the moment and the mission's start.
        curves: the panel.

    Returns:
        An axis from 0 to 1.
    """
    zero = view.now if view.record.start is None else view.record.start
    first = min((curve.times[0] for group in curves.groups for curve in group.curves if curve.times), default=view.now)
    low = max(min(first, view.now - _SHORTEST), zero)
    return TimeAxis(low, max(view.now, low + _SHORTEST), 0.0, 1.0, zero)


def draw_curves(page: Page) -> None:
    """Draw the panels side by side, each a grid of small charts.

    Args:
        page: drawn upon; frames and titles are there.
    """
    if not page.view.panels:
        box = inside(CURVES)
        page.canvas.text(box.left, box.top + 14, "this architecture tells no curves", PLAIN, MUTED, WHITE)
        return
    titles = curve_titles(page.view.panels)
    for box, title, curves in zip(curves_boxes(len(titles)), titles, page.view.panels):
        _draw_legend(page, box.inset(24.0 + text_width(title, TITLE), 0, 12, 0), curves)
        _draw_panel(page, box, curves)


def _draw_panel(page: Page, box: Box, curves: CurvePanel) -> None:
    canvas = page.canvas
    room = inside(box).inset(24, 0, 0, 16)
    groups = curves.groups[:_MOST_GROUPS]
    if not groups:
        canvas.text(box.left + 12, room.top + 14, "nothing heard yet", PLAIN, MUTED, WHITE)
        return
    columns, lines = cells(room, len(groups))
    axis = time_window(page.view, curves)
    width, height = room.width / columns, room.height / lines
    for index, group in enumerate(groups):
        column, line = index % columns, index // columns
        left, top = room.left + column * width, room.top + line * height
        cell = Box(round(left) + 2, round(top) + 17, round(left + width) - 6, round(top + height) - 4)
        _draw_axes(canvas, cell, curves, axis, first=column == 0, last=index + columns >= len(groups))
        canvas.text(cell.left, cell.top - 9, shorten(group.label, _NAME, cell.width), _NAME, INK, WHITE)
        _draw_group(page, cell, group, curves, axis)
    canvas.text(box.left + 10, room.bottom + 8, f"t [{axis.unit}]", SMALL, MUTED, WHITE)
    if len(curves.groups) > len(groups):
        words = f"+{len(curves.groups) - len(groups)} more"
        canvas.text(room.right, box.top + 37, words, SMALL, MUTED, WHITE, anchor=1.0)


def _draw_legend(page: Page, box: Box, curves: CurvePanel) -> None:
    """Name the colours from right to left; names are shortened, and then left out, where room is short."""
    canvas = page.canvas
    labels = list(dict.fromkeys(curve.label for group in curves.groups for curve in group.curves))
    y, x = box.top + 15.0, box.right
    if curves.reference is not None:
        x -= canvas.text(x, y, f"reference {number(curves.reference)}", SMALL, INK, WHITE, anchor=1.0) + 4.0
        canvas.dashes(x - _KEY, x, y, RED, 3)
        x -= _KEY + _BETWEEN_KEYS
    room = x - box.left - len(labels) * (_KEY + 4.0 + _BETWEEN_KEYS)
    widest = share_out([text_width(label, SMALL) for label in labels], room)
    for done, label in enumerate(reversed(labels)):
        words = shorten(label, SMALL, max(widest, _LEAST_KEY))
        room_for_rest = 0.0 if done == len(labels) - 1 else 30.0
        if x - text_width(words, SMALL) - _KEY - 4.0 - room_for_rest < box.left:
            canvas.text(x, y, f"+{len(labels) - done}", SMALL, MUTED, WHITE, anchor=1.0)
            return
        x -= canvas.text(x, y, words, SMALL, INK, WHITE, anchor=1.0) + 4.0
        canvas.fill(Box(x - _KEY, y - 1, x, y + 2), page.colours[label])
        x -= _KEY + _BETWEEN_KEYS


def _draw_axes(canvas: Canvas, box: Box, curves: CurvePanel, axis: TimeAxis, *, first: bool, last: bool) -> None:
    """Draw ground, grid and labels; values on the first of a line only, times on the last of a column only."""
    canvas.fill(box, FAINT)
    across = _across(axis, box)
    for time, label in across.ticks(max(2, min(int(box.width / 40.0), 7))):
        column = across(time)
        canvas.fill(Box(round(column), box.top, round(column) + 1, box.bottom), GRID)
        if last:
            # A label at the end of one chart must not run into one at the beginning of the next.
            half = text_width(label, SMALL) / 2.0
            middle = min(max(column, box.left + half), box.right - half)
            canvas.text(middle, box.bottom + 10, label, SMALL, MUTED, WHITE, anchor=0.5)
    canvas.frame(box, GRID)
    up = Axis(0.0, curves.top, box.bottom - 1.0, box.top)
    if first:
        for value in value_labels(curves):
            canvas.text(box.left - 5, up(value), number(value), SMALL, MUTED, WHITE, anchor=1.0)


def _draw_group(page: Page, box: Box, group: CurveGroup, curves: CurvePanel, axis: TimeAxis) -> None:
    across = _across(axis, Box(0, 0, box.width, box.height))
    up = Axis(0.0, curves.top, box.height - 1.0, 0.0)
    inner = page.canvas.part(box)
    width = 2 if box.height >= _THICK_FROM else 1
    for curve in group.curves:
        inner.broken_line(_points(curve, across, up), page.colours[curve.label], width)
    if curves.reference is not None:
        inner.dashes(0.0, box.width, up(curves.reference), RED)


def _across(axis: TimeAxis, box: Box) -> TimeAxis:
    return TimeAxis(axis.low, axis.high, box.left, box.right - 1.0, axis.zero)


def _points(curve: Curve, across: TimeAxis, up: Axis) -> NDArray[np.float64]:
    """Give the places of a curve's points; values beyond the axis lie on its ends, NaN stays NaN."""
    points: NDArray[np.float64] = np.array((curve.times, curve.values), dtype=np.float64).T
    points[:, 0] -= across.low
    points[:, 0] *= (across.last - across.first) / (across.high - across.low)
    points[:, 0] += across.first
    if up.high > 0.0:
        points[:, 1] /= up.high
    points[:, 1] = up.first + points[:, 1].clip(0.0, 1.0) * (up.last - up.first)
    return points
