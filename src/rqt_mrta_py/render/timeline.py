"""Who held which task when, over the whole planned mission, with the robots' states and the incidents."""

from __future__ import annotations

from typing import Dict, List, Sequence, Tuple

from rqt_mrta_py.model import Allocation, Outcome, RobotRecord
from rqt_mrta_py.render.canvas import Box, Canvas
from rqt_mrta_py.render.layout import PLAIN, SMALL, TIMELINE, inside
from rqt_mrta_py.render.page import Page
from rqt_mrta_py.render.palette import (
    FAINT,
    GRID,
    INK,
    MUTED,
    RED,
    SEVERITY_COLOURS,
    STATE_COLOURS,
    WHITE,
    readable_on,
)
from rqt_mrta_py.render.signs import OUTCOME_SIGNS, warning
from rqt_mrta_py.render.text import Style, shorten, text_width
from rqt_mrta_py.render.times import TimeAxis, mission_span

__all__ = ["draw_outcome_legend", "draw_timeline", "lanes"]

_BAR_TEXT = Style(12)
_SIGN = Style(12, bold=True)
_NAME = Style(12, bold=True)
_TALLEST, _LOWEST = 36.0, 13.0
_INCIDENTS = 20.0
_AXIS = 18.0
_NAMES = 92.0
_BAD = (Outcome.LOST, Outcome.FAILED)
_LEAST_FOR_SIGN, _LEAST_FOR_TEXT = 9.0, 11.0


def draw_outcome_legend(canvas: Canvas) -> None:
    """Write what the signs at the ends of bars mean, beside the panel's title.

    Args:
        canvas: drawn upon.
    """
    x, y = TIMELINE.right - 12.0, TIMELINE.top + 15.0
    for outcome in reversed([outcome for outcome in Outcome if OUTCOME_SIGNS[outcome]]):
        x -= canvas.text(x, y, outcome.value.replace("_", " "), SMALL, MUTED, WHITE, anchor=1.0) + 2.0
        x -= canvas.text(x, y, OUTCOME_SIGNS[outcome], _SIGN, INK, WHITE, anchor=1.0) + 10.0


def draw_timeline(page: Page) -> None:
    """Draw one row per robot: bars of its allocations above a strip of its states; incidents on top.

    Args:
        page: drawn upon; frame, title and legend are there.
    """
    canvas, box = page.canvas, inside(TIMELINE)
    robots = page.view.record.robots
    room = box.inset(0, _INCIDENTS, 0, _AXIS)
    height = min(_TALLEST, max(room.height / max(len(robots), 1), _LOWEST))
    shown = len(robots) if height * len(robots) <= room.height + 0.5 else int(room.height / height) - 1
    chart = Box(box.left + _NAMES, room.top, box.right - 8.0, room.bottom)
    start, end = mission_span(page.view)
    axis = TimeAxis(start, end, chart.left, chart.right, start)
    _draw_axis(canvas, chart, axis)
    if not robots:
        canvas.text(box.left, room.top + 14, "no robot yet", PLAIN, MUTED, WHITE)
    for index, robot in enumerate(robots[:shown]):
        row = Box(chart.left, chart.top + index * height, chart.right, chart.top + (index + 1) * height)
        canvas.text(box.left, row.centre[1] - 1.0, shorten(robot.id, _NAME, _NAMES - 8.0), _NAME, INK, WHITE)
        _draw_row(page, row, axis, robot)
    if shown < len(robots):
        canvas.text(box.left, chart.top + (shown + 0.5) * height, f"+{len(robots) - shown} more", SMALL, MUTED, WHITE)
    _draw_incidents(page, Box(box.left, box.top, chart.right, chart.top), axis)
    if page.view.record.start is not None:
        now = round(axis(page.view.now))
        canvas.fill(Box(now, box.top + 2, now + 1, chart.bottom + 3), INK)


def lanes(allocations: Sequence[Allocation]) -> List[Tuple[Allocation, int]]:
    """Give each of one robot's allocations the first lane that is free when it starts.

    Args:
        allocations: by start.

    Returns:
        Each allocation with its lane, from 0.
    """
    free_at: Dict[int, float] = {}
    given = []
    for allocation in allocations:
        lane = next((lane for lane in range(len(free_at)) if free_at[lane] <= allocation.start), len(free_at))
        free_at[lane] = allocation.end
        given.append((allocation, lane))
    return given


def _draw_axis(canvas: Canvas, chart: Box, axis: TimeAxis) -> None:
    canvas.fill(chart, FAINT)
    for time, label in axis.ticks(11):
        column = round(axis(time))
        canvas.fill(Box(column, chart.top - _INCIDENTS + 2, column + 1, chart.bottom + 3), GRID)
        canvas.text(column, chart.bottom + 12, label, SMALL, MUTED, WHITE, anchor=0.5)
    canvas.text(chart.left - 18, chart.bottom + 12, f"t [{axis.unit}]", SMALL, MUTED, WHITE, anchor=1.0)


def _draw_row(page: Page, row: Box, axis: TimeAxis, robot: RobotRecord) -> None:
    roomy = row.height >= 20.0
    bottom = round(row.bottom) - (2 if roomy else 1)
    strip = bottom - (4 if roomy else 2)
    for interval in robot.states:
        page.canvas.fill(Box(axis(interval.start), strip, axis(interval.end), bottom), STATE_COLOURS[interval.state])
    given = lanes(page.by_robot.get(robot.id, ()))
    top = round(row.top) + (2 if roomy else 1)
    height = (strip - 1 - top) / (max((lane for _, lane in given), default=0) + 1)
    for allocation, lane in given:
        left = round(axis(allocation.start))
        right = max(round(axis(allocation.end)), left + 1)
        _draw_bar(page, Box(left, round(top + lane * height), right, round(top + (lane + 1) * height)), allocation)


def _draw_bar(page: Page, place: Box, allocation: Allocation) -> None:
    colour, sign = page.colours[allocation.task], OUTCOME_SIGNS[allocation.outcome]
    canvas = page.canvas.part(place)
    ink, middle = readable_on(colour), place.height / 2.0 - 0.5
    canvas.fill(Box(0, 0, place.width, place.height), colour)
    room = place.width - 1.0
    if sign:
        ground = RED if allocation.outcome in _BAD else colour
        needed = text_width(sign, _SIGN) + 4.0 if place.height >= _LEAST_FOR_SIGN else 4.0
        fits = room >= needed
        if ground is RED:
            canvas.fill(Box(max(room - needed, 0.0), 0, place.width, place.height), RED)
        if fits and place.height >= _LEAST_FOR_SIGN:
            canvas.text(room - 2.0, middle, sign, _SIGN, readable_on(ground), ground, anchor=1.0)
        room -= needed
        # Two allocations of one task that follow one another stay two.
        canvas.fill(Box(place.width - 1, 0, place.width, place.height), WHITE)
    words = shorten(allocation.task, _BAR_TEXT, room - 6.0)
    if place.height >= _LEAST_FOR_TEXT and len(words) > 4:
        canvas.text(4.0, middle, words, _BAR_TEXT, ink, colour)


def _draw_incidents(page: Page, lane: Box, axis: TimeAxis) -> None:
    incidents, y = page.view.record.incidents, lane.centre[1]
    if incidents:
        page.canvas.text(lane.left, y, "incidents", SMALL, MUTED, WHITE)
    for incident in incidents:
        left = axis(incident.start)
        right = max(axis(incident.end), left + 2.0)
        page.canvas.fill(Box(left, y + 4, right, y + 7), SEVERITY_COLOURS[incident.severity])
    for incident in sorted(incidents, key=lambda incident: incident.severity.rank):
        warning(page.canvas, (axis(incident.start), y), 6.5, incident.severity)
