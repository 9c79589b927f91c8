"""Who held which task when, over the whole planned mission, with the robots' states and the incidents."""

from __future__ import annotations

from typing import Dict, List, Sequence, Tuple

from rqt_mrta_py.hooks import MonitorView
from rqt_mrta_py.model import Allocation, Outcome, RobotRecord
from rqt_mrta_py.render.canvas import Box, Canvas
from rqt_mrta_py.render.layout import PLAIN, SMALL, TIMELINE, inside
from rqt_mrta_py.render.palette import (
    FAINT,
    GRID,
    INK,
    MUTED,
    SEVERITY_COLOURS,
    STATE_COLOURS,
    WHITE,
    TaskColours,
    mix,
    readable_on,
)
from rqt_mrta_py.render.signs import OUTCOME_SIGNS, warning
from rqt_mrta_py.render.text import Style, fit, text_width
from rqt_mrta_py.render.times import TimeAxis, mission_span

__all__ = ["draw_timeline"]

_BAR_TEXT = Style(11)
_BAR_SIGN = Style(11, bold=True)
_NAME = Style(12, bold=True)
_TALLEST, _LOWEST = 36.0, 13.0
_INCIDENTS = 20.0
_AXIS = 18.0
_NAMES = 92.0
_STATE = 4.0
_BAD = (Outcome.LOST, Outcome.FAILED)


def draw_timeline(canvas: Canvas, view: MonitorView, colours: TaskColours) -> None:
    """Draw one row per robot: bars of its allocations above a strip of its states; incidents on top.

    Args:
        canvas: drawn upon.
        view: the mission.
        colours: of its tasks.
    """
    _draw_legend(canvas)
    box = inside(TIMELINE)
    start, end = mission_span(view)
    robots = view.record.robots
    room = box.inset(0, _INCIDENTS, 0, _AXIS)
    height = min(_TALLEST, max(room.height / max(len(robots), 1), _LOWEST))
    shown = len(robots) if height * len(robots) <= room.height + 0.5 else int(room.height / height) - 1
    chart = Box(box.left + _NAMES, room.top, box.right - 8.0, room.bottom)
    axis = TimeAxis(start, end, chart.left, chart.right, start)
    _draw_axis(canvas, chart, axis, box.top)
    if not robots:
        canvas.text(box.left, room.top + 14, "no robot yet", PLAIN, MUTED, WHITE)
    for index, robot in enumerate(robots[:shown]):
        row = Box(chart.left, chart.top + index * height, chart.right, chart.top + (index + 1) * height)
        canvas.text(box.left, row.centre[1] - 1.0, fit(robot.id, _NAME, _NAMES - 8.0), _NAME, INK, WHITE)
        _draw_states(canvas, row, axis, robot)
        _draw_bars(canvas, row, axis, [a for a in view.record.allocations if a.robot == robot.id], colours)
    if shown < len(robots):
        canvas.text(box.left, chart.top + (shown + 0.5) * height, f"+{len(robots) - shown} more", SMALL, MUTED, WHITE)
    _draw_incidents(canvas, Box(chart.left, box.top, chart.right, chart.top), axis, view)
    if view.record.start is not None:
        now = round(axis(view.now))
        canvas.fill(Box(now, box.top + 2, now + 1, chart.bottom + 3), INK)


def _draw_axis(canvas: Canvas, chart: Box, axis: TimeAxis, top: float) -> None:
    canvas.fill(chart, FAINT)
    for time, label in axis.ticks(11):
        column = round(axis(time))
        canvas.fill(Box(column, top + 2, column + 1, chart.bottom + 3), GRID)
        canvas.text(column, chart.bottom + 12, label, SMALL, MUTED, WHITE, anchor=0.5)
    canvas.text(chart.left - 18, chart.bottom + 12, f"t [{axis.unit}]", SMALL, MUTED, WHITE, anchor=1.0)


def _draw_legend(canvas: Canvas) -> None:
    x, y = TIMELINE.right - 12.0, TIMELINE.top + 15.0
    for outcome in reversed([outcome for outcome in Outcome if OUTCOME_SIGNS[outcome]]):
        x -= canvas.text(x, y, outcome.value.replace("_", " "), SMALL, MUTED, WHITE, anchor=1.0) + 2.0
        x -= canvas.text(x, y, OUTCOME_SIGNS[outcome], Style(12, bold=True), INK, WHITE, anchor=1.0) + 10.0


def _draw_states(canvas: Canvas, row: Box, axis: TimeAxis, robot: RobotRecord) -> None:
    bottom = round(row.bottom) - 2
    for interval in robot.states:
        left, right = axis(interval.start), axis(interval.end)
        canvas.fill(Box(left, bottom - _strip(row), right, bottom), STATE_COLOURS[interval.state])


def _draw_bars(
    canvas: Canvas, row: Box, axis: TimeAxis, allocations: Sequence[Allocation], colours: TaskColours
) -> None:
    top, bottom = round(row.top) + 2.0, round(row.bottom) - 3.0 - _strip(row)
    lanes = _lanes(allocations)
    height = (bottom - top) / max(max((lane for _, lane in lanes), default=0) + 1, 1)
    for allocation, lane in lanes:
        left, right = axis(allocation.start), max(axis(allocation.end), axis(allocation.start) + 1.0)
        bar = Box(round(left), round(top + lane * height), round(right), round(top + (lane + 1) * height))
        _draw_bar(canvas, bar, allocation, colours)


def _draw_bar(canvas: Canvas, bar: Box, allocation: Allocation, colours: TaskColours) -> None:
    colour = colours[allocation.task]
    canvas.fill(bar, colour)
    canvas.fill(Box(bar.right - 1, bar.top, bar.right, bar.bottom), WHITE)
    ink, middle = readable_on(colour), bar.centre[1]
    room = bar.width - 6.0
    sign = OUTCOME_SIGNS[allocation.outcome]
    if sign and bar.height >= 7.0 and room >= text_width(sign, _BAR_SIGN):
        right = bar.right - 3.0
        if allocation.outcome in _BAD:
            taken = text_width(sign, _BAR_SIGN) + 4.0
            canvas.fill(Box(bar.right - taken - 2.0, bar.top, bar.right - 1, bar.bottom), (190, 26, 38))
            canvas.text(right, middle, sign, _BAR_SIGN, WHITE, (190, 26, 38), anchor=1.0)
            room -= taken
        else:
            room -= canvas.text(right, middle, sign, _BAR_SIGN, ink, colour, anchor=1.0)
    words = fit(allocation.task, _BAR_TEXT, room - 2.0)
    if bar.height >= 11.0 and len(words) > 3:
        canvas.text(bar.left + 4.0, middle, words, _BAR_TEXT, ink, colour)


def _draw_incidents(canvas: Canvas, lane: Box, axis: TimeAxis, view: MonitorView) -> None:
    if view.record.incidents:
        canvas.text(lane.left - _NAMES, lane.centre[1], "incidents", SMALL, MUTED, WHITE)
    y = lane.centre[1]
    for incident in view.record.incidents:
        left, right = axis(incident.start), axis(incident.end)
        canvas.fill(Box(left, y + 4, max(right, left + 2.0), y + 7), SEVERITY_COLOURS[incident.severity])
    for incident in sorted(view.record.incidents, key=lambda incident: incident.severity.rank):
        warning(canvas, (axis(incident.start), y), 6.5, incident.severity)


def _lanes(allocations: Sequence[Allocation]) -> List[Tuple[Allocation, int]]:
    """Give each of one robot's allocations the first lane that is free when it starts."""
    free_at: Dict[int, float] = {}
    lanes = []
    for allocation in allocations:
        lane = next((lane for lane in range(len(free_at)) if free_at[lane] <= allocation.start), len(free_at))
        free_at[lane] = allocation.end
        lanes.append((allocation, lane))
    return lanes


def _strip(row: Box) -> float:
    return _STATE if row.height >= 20.0 else 2.0
