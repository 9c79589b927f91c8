"""Small charts of an architecture's inner life."""

from __future__ import annotations

import math
from typing import List, Sequence, Tuple

import numpy as np

from rqt_mrta_py.hooks import Curve, CurveGroup, CurvePanel, MonitorView
from rqt_mrta_py.render.canvas import Box, Canvas, Point
from rqt_mrta_py.render.layout import CURVES, PLAIN, SMALL, TITLE, inside, panel
from rqt_mrta_py.render.palette import FAINT, GRID, INK, MUTED, WHITE, TaskColours, mix
from rqt_mrta_py.render.text import Style, fit, text_width
from rqt_mrta_py.render.times import Axis, TimeAxis, number

__all__ = ["cells", "draw_curves"]

_MOST_PANELS = 2
_MOST_GROUPS = 12
_SHORTEST = 10.0
_NAME = Style(12, bold=True)
_REFERENCE = (190, 26, 38)


def draw_curves(canvas: Canvas, view: MonitorView, colours: TaskColours) -> None:
    """Draw the panels side by side, each a grid of small charts.

    Args:
        canvas: drawn upon.
        view: the mission.
        colours: of its curves.
    """
    shown = view.panels[:_MOST_PANELS]
    if not shown:
        panel(canvas, CURVES, "Curves")
        box = inside(CURVES)
        canvas.text(box.left, box.top + 14, "this architecture tells no curves", PLAIN, MUTED, WHITE)
    gap = 10.0
    width = (CURVES.width - gap * (len(shown) - 1)) / max(len(shown), 1)
    for index, curves in enumerate(shown):
        left = round(CURVES.left + index * (width + gap))
        _draw_panel(canvas, Box(left, CURVES.top, left + int(width), CURVES.bottom), view, curves, colours)


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


def _draw_panel(canvas: Canvas, box: Box, view: MonitorView, curves: CurvePanel, colours: TaskColours) -> None:
    unit = "" if curves.unit in ("", "1") else f" [{curves.unit}]"
    title = fit(curves.title + unit, TITLE, 0.5 * box.width)
    panel(canvas, box, title)
    _draw_legend(canvas, box, 24.0 + text_width(title, TITLE), curves, colours)
    groups = curves.groups[:_MOST_GROUPS]
    room = inside(box).inset(26, 0, 0, 16)
    if not groups:
        canvas.text(box.left + 12, room.top + 14, "nothing heard yet", PLAIN, MUTED, WHITE)
        return
    columns, rows = cells(room, len(groups))
    axis = _window(view, curves)
    width, height = room.width / columns, room.height / rows
    for index, group in enumerate(groups):
        column, row = index % columns, index // columns
        left, top = room.left + column * width, room.top + row * height
        cell = Box(round(left) + 2, round(top) + 17, round(left + width) - 6, round(top + height) - 4)
        lowest = index + columns >= len(groups)
        _draw_group(canvas, cell, group, curves, axis, colours, (column == 0, lowest))
    if len(curves.groups) > len(groups):
        words = f"+{len(curves.groups) - len(groups)} more"
        canvas.text(room.right, box.bottom - 12, words, SMALL, MUTED, WHITE, anchor=1.0)


def _draw_legend(canvas: Canvas, box: Box, offset: float, curves: CurvePanel, colours: TaskColours) -> None:
    labels = list(dict.fromkeys(curve.label for group in curves.groups for curve in group.curves))
    y, x = box.top + 15.0, box.right - 12.0
    least = box.left + offset
    entries = [(label, False) for label in labels]
    if curves.reference is not None:
        entries.append((f"reference {number(curves.reference)}", True))
    for done, (label, dashed) in enumerate(reversed(entries)):
        words = fit(label, SMALL, 130.0)
        if x - text_width(words, SMALL) - 24.0 < least:
            canvas.text(x, y, f"+{len(entries) - done}", SMALL, MUTED, WHITE, anchor=1.0)
            return
        x -= canvas.text(x, y, words, SMALL, INK, WHITE, anchor=1.0) + 4.0
        if dashed:
            canvas.dashes((x - 17.0, y), (x, y), _REFERENCE, 1, 3.0)
        else:
            canvas.line([(x - 17.0, y), (x, y)], colours[label], 2)
        x -= 28.0


def _draw_group(
    canvas: Canvas,
    box: Box,
    group: CurveGroup,
    curves: CurvePanel,
    axis: TimeAxis,
    colours: TaskColours,
    labelled: Tuple[bool, bool],
) -> None:
    canvas.text(box.left, box.top - 9, fit(group.label, _NAME, box.width), _NAME, INK, WHITE)
    canvas.fill(box, FAINT)
    across = TimeAxis(axis.low, axis.high, box.left, box.right - 1.0, axis.zero)
    up = Axis(0.0, curves.top, box.bottom - 1.0, box.top)
    for time, label in across.ticks(max(2, min(int(box.width / 48.0), 7))):
        column = round(across(time))
        canvas.fill(Box(column, box.top, column + 1, box.bottom), GRID)
        if labelled[1]:
            canvas.text(column, box.bottom + 10, f"{label} {axis.unit}", SMALL, MUTED, WHITE, anchor=0.5)
    for value in (0.0, curves.top):
        if labelled[0]:
            canvas.text(box.left - 5, up(value), number(value), SMALL, MUTED, WHITE, anchor=1.0)
    canvas.frame(box, GRID)
    if curves.reference is not None:
        y = up(curves.reference)
        canvas.dashes((box.left, y), (box.right, y), _REFERENCE, 1, 4.0)
    inner = canvas.part(box)
    for curve in group.curves:
        strokes = _strokes(curve, across, up, box)
        inner.strokes(strokes, mix(colours[curve.label], INK, 0.05), 2)


def _window(view: MonitorView, curves: CurvePanel) -> TimeAxis:
    first = [curve.times[0] for group in curves.groups for curve in group.curves if curve.times]
    zero = view.now if view.record.start is None else view.record.start
    start = min(first, default=view.now)
    return TimeAxis(min(start, view.now - _SHORTEST), view.now, 0.0, 1.0, zero)


def _strokes(curve: Curve, across: TimeAxis, up: Axis, box: Box) -> List[Sequence[Point]]:
    """Turn a curve into strokes in the box's own pixels, two points a column at most, cut at NaN."""
    if not curve.times:
        return []
    times = np.array(curve.times, dtype=np.float64)
    values = np.array(curve.values, dtype=np.float64)
    x = (times - across.low) / (across.high - across.low) * (box.width - 1.0)
    y = (box.height - 1.0) * (1.0 - np.clip(values / up.high, 0.0, 1.0))
    points = np.stack((x, y), axis=1)
    gaps = np.flatnonzero(np.isnan(values))
    edges = [-1, *gaps.tolist(), len(values)]
    strokes = []
    for before, after in zip(edges, edges[1:]):
        stroke = points[before + 1 : after]
        step = max(len(stroke) // int(4.0 * box.width), 1)
        if len(stroke):
            strokes.append(stroke if step == 1 else np.concatenate((stroke[::step], stroke[-1:])))
    return strokes
