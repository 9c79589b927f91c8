"""Who held which task when, over the whole planned mission, with the robots' states and the incidents."""

from __future__ import annotations

import math
from typing import Dict, List, NamedTuple, Sequence, Tuple

from rqt_mrta_py.model import Allocation, Outcome, RobotRecord, RobotState, Severity
from rqt_mrta_py.render.canvas import Box, Canvas
from rqt_mrta_py.render.foremost import foremost_robots
from rqt_mrta_py.render.layout import PLAIN, SMALL, TIMELINE, inside
from rqt_mrta_py.render.marks import Mark, draw_marks, mark_of
from rqt_mrta_py.render.page import Page, Part, by_robot
from rqt_mrta_py.render.palette import (
    FAINT,
    GRID,
    INK,
    MUTED,
    RED,
    SEVERITY_COLOURS,
    STATE_COLOURS,
    WHITE,
    Colour,
    readable_on,
)
from rqt_mrta_py.render.signs import OUTCOME_SIGNS, warning
from rqt_mrta_py.render.text import Style, shorten, text_width
from rqt_mrta_py.render.times import TimeAxis, mission_span

__all__ = ["draw_outcome_legend", "lanes", "moment_parts", "timeline_part"]

_BAR_TEXT = Style(12)
_SIGN = Style(12, bold=True)
_NAME = Style(12, bold=True)
_TALLEST, _LOWEST = 36.0, 13.0
_INCIDENTS = 20.0
_AXIS = 18.0
_NAMES = 92.0
_BETWEEN_SIGNS = 5.0
_STEP = 16
_BAD = (Outcome.LOST, Outcome.FAILED)
_LEAST_FOR_SIGN, _LEAST_FOR_TEXT, _LEAST_FOR_WORDS = 9.0, 11.0, 24.0


def draw_outcome_legend(canvas: Canvas) -> None:
    """Write what the signs at the ends of bars mean, beside the panel's title.

    Args:
        canvas: drawn upon.
    """
    x, y = TIMELINE.right - 12.0, TIMELINE.top + 15.0
    for outcome in reversed([outcome for outcome in Outcome if OUTCOME_SIGNS[outcome]]):
        x -= canvas.text(x, y, outcome.value.replace("_", " "), SMALL, MUTED, WHITE, anchor=1.0) + 2.0
        x -= canvas.text(x, y, OUTCOME_SIGNS[outcome], _SIGN, INK, WHITE, anchor=1.0) + 10.0


class _Bar(NamedTuple):
    """One allocation: its lane, from where to where [pixels], of which task, how it ended."""

    lane: int
    left: int
    right: int
    task: str
    colour: Colour
    outcome: Outcome


class _Row(NamedTuple):
    """One robot: bars of its allocations, strips of its states, marks of what a scenario did to it."""

    robot: str
    bars: Tuple[_Bar, ...]
    strips: Tuple[Tuple[int, int, RobotState], ...]
    marks: Tuple[Mark, ...]


class _Timeline(NamedTuple):
    """What the panel says; incidents are (left, right, severity), labels of the axis (column, words), in pixels."""

    axis: TimeAxis
    height: float
    rows: Tuple[_Row, ...]
    robots: int
    incidents: Tuple[Tuple[int, int, Severity], ...]
    marks: Tuple[Mark, ...]


def timeline_part(page: Page) -> Part:
    """Say what the panel of allocations shows: one row per robot, the foremost if there are many.

    A row has bars of allocations above a strip of states. Above the rows are incidents, and what a scenario made happen
    that belongs in no row.

    Args:
        page: the mission.
    """
    view = page.view
    room = _room()
    height, shown = _rows(room, len(view.record.robots))
    start, end = mission_span(view)
    axis = TimeAxis(start, end, room.left + _NAMES, room.right - 8.0, start)
    robots = foremost_robots(view, shown, page.troubled)
    given = by_robot(view.record.allocations, [robot.id for robot in robots])
    marks: Dict[str, List[Mark]] = {}
    for label in view.scene.labels:
        marks.setdefault(label.robot if label.robot in given else "", []).append(
            mark_of(label, round(axis(label.time)), page.colours)
        )
    content = _Timeline(
        axis,
        height,
        tuple([_row(page, axis, robot, given[robot.id], tuple(marks.get(robot.id, ()))) for robot in robots]),
        len(view.record.robots),
        _incidents(page, axis),
        tuple(marks.get("", ())),
    )
    return Part(TIMELINE, content, _draw_timeline)


def moment_parts(page: Page, part: Part) -> Tuple[Part, ...]:
    """Say what goes on since the last whole second, and how far the mission has come; nothing before its start.

    Args:
        page: the mission.
        part: the panel, which lies below.
    """
    if page.view.record.start is None:
        return ()
    timeline: _Timeline = part.content
    room, now = _room(), round(timeline.axis(page.view.now))
    fills: List[Tuple[Box, Colour]] = []
    for index, row in enumerate(timeline.rows):
        shape = _Shape.of(row, room.top + index * timeline.height, timeline.height)
        if row.strips:
            _, since, state = row.strips[-1]
            fills.append((Box(since, shape.strip, now, shape.bottom), STATE_COLOURS[state]))
        fills += [
            (Box(bar.right, shape.top_of(bar.lane), now, shape.top_of(bar.lane + 1)), bar.colour)
            for bar in row.bars
            if bar.outcome is Outcome.OPEN
        ]
    line = Box(now, room.top - _INCIDENTS + 2, now + 1, room.bottom + 3)
    fills.append((line, INK))
    first = min(box.left for box, _ in fills)
    # In few different places, so that a layer has few to look after.
    left, right = first - first % _STEP, line.right + -line.right % _STEP
    return (Part(Box(left, line.top, right, line.bottom), tuple(fills), _draw_fills),)


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


def _room() -> Box:
    """Give where the rows are: names and chart."""
    return inside(TIMELINE).inset(0, _INCIDENTS, 0, _AXIS)


def _rows(room: Box, robots: int) -> Tuple[float, int]:
    """Give the height of a row [pixels] and how many of so many robots are shown."""
    height = min(_TALLEST, max(room.height / max(robots, 1), _LOWEST))
    return height, robots if height * robots <= room.height + 0.5 else int(room.height / height) - 1


class _Shape(NamedTuple):
    """Where things are in a row: top of its bars, height of a lane, top and bottom of the strip, all in pixels."""

    top: int
    lane: float
    strip: int
    bottom: int

    @classmethod
    def of(cls, row: _Row, top: float, height: float) -> _Shape:
        roomy = height >= 20.0
        bottom = round(top + height) - (2 if roomy else 1)
        strip = bottom - (4 if roomy else 2)
        first = round(top) + (2 if roomy else 1)
        lanes_ = max((bar.lane for bar in row.bars), default=0) + 1
        return cls(first, (strip - 1 - first) / lanes_, strip, bottom)

    def top_of(self, lane: int) -> int:
        """Give where a lane begins."""
        return round(self.top + lane * self.lane)


def _row(page: Page, axis: TimeAxis, robot: RobotRecord, given: Sequence[Allocation], marks: Tuple[Mark, ...]) -> _Row:
    """Say what a row shows up to the last whole second; what still goes on ends there."""
    now = page.view.now
    settled = axis(page.settled)
    strips = []
    for each in robot.states:
        left = round(axis(each.start))
        strips.append((left, max(left, round(settled if each.end >= now else axis(each.end))), each.state))
    bars = []
    for allocation, lane in lanes(given):
        left = round(axis(allocation.start))
        right = round(settled if allocation.outcome is Outcome.OPEN else axis(allocation.end))
        colour = page.colours[allocation.task]
        bars.append(_Bar(lane, left, max(right, left + 1), allocation.task, colour, allocation.outcome))
    return _Row(robot.id, tuple(bars), tuple(strips), marks)


def _incidents(page: Page, axis: TimeAxis) -> Tuple[Tuple[int, int, Severity], ...]:
    """List the incidents, the worst last; of those that begin in one column and are equally bad, the longest."""
    longest: Dict[Tuple[int, int], Tuple[int, int, Severity]] = {}
    for incident in page.view.record.incidents:
        left = round(axis(incident.start))
        end = page.settled if incident.end >= page.view.now else incident.end
        right = max(round(axis(end)), left + 2)
        key = (incident.severity.rank, left)
        if key not in longest or longest[key][1] < right:
            longest[key] = (left, right, incident.severity)
    return tuple(incident for _, incident in sorted(longest.items(), key=lambda item: item[0]))


def _draw_fills(canvas: Canvas, fills: Sequence[Tuple[Box, Colour]]) -> None:
    for box, colour in fills:
        canvas.fill(box, colour)


def _draw_timeline(canvas: Canvas, timeline: _Timeline) -> None:
    room, height = _room(), timeline.height
    chart = Box(room.left + _NAMES, room.top, room.right - 8.0, room.bottom)
    _draw_axis(canvas, chart, timeline.axis)
    if not timeline.rows:
        canvas.text(room.left, room.top + 14, "no robot yet", PLAIN, MUTED, WHITE)
    for index, row in enumerate(timeline.rows):
        place = Box(chart.left, chart.top + index * height, chart.right, chart.top + (index + 1) * height)
        canvas.text(room.left, place.centre[1] - 1.0, shorten(row.robot, _NAME, _NAMES - 8.0), _NAME, INK, WHITE)
        _draw_row(canvas, place, row)
    left_out, below = timeline.robots - len(timeline.rows), chart.top + (len(timeline.rows) + 0.5) * height
    if left_out:
        canvas.text(room.left, below, f"+{left_out} more", SMALL, MUTED, WHITE)
    above = Box(room.left, room.top - _INCIDENTS, chart.right, room.top)
    draw_marks(canvas, above.inset(_NAMES, 0, 0, 0), timeline.marks)
    _draw_incidents(canvas, above, timeline.incidents)


def _draw_axis(canvas: Canvas, chart: Box, axis: TimeAxis) -> None:
    canvas.fill(chart, FAINT)
    for time, label in axis.ticks(11):
        column = round(axis(time))
        canvas.fill(Box(column, chart.top - _INCIDENTS + 2, column + 1, chart.bottom + 3), GRID)
        canvas.text(column, chart.bottom + 12, label, SMALL, MUTED, WHITE, anchor=0.5)
    canvas.text(chart.left - 18, chart.bottom + 12, f"t [{axis.unit}]", SMALL, MUTED, WHITE, anchor=1.0)


def _draw_row(canvas: Canvas, place: Box, row: _Row) -> None:
    shape = _Shape.of(row, place.top, place.height)
    for left, right, state in row.strips:
        canvas.fill(Box(left, shape.strip, right, shape.bottom), STATE_COLOURS[state])
    for bar in row.bars:
        _draw_bar(canvas, Box(bar.left, shape.top_of(bar.lane), bar.right, shape.top_of(bar.lane + 1)), bar)
    draw_marks(canvas, place, row.marks)


def _draw_bar(whole: Canvas, place: Box, bar: _Bar) -> None:
    colour, sign = bar.colour, OUTCOME_SIGNS[bar.outcome]
    canvas = whole.part(place)
    ink, middle = readable_on(colour), place.height / 2.0 - 0.5
    canvas.fill(Box(0, 0, place.width, place.height), colour)
    room = place.width - 1.0
    if sign:
        ground = RED if bar.outcome in _BAD else colour
        needed = text_width(sign, _SIGN) + 4.0 if place.height >= _LEAST_FOR_SIGN else 4.0
        fits = room >= needed
        if ground is RED:
            canvas.fill(Box(max(room - needed, 0.0), 0, place.width, place.height), RED)
        if fits and place.height >= _LEAST_FOR_SIGN:
            canvas.text(room - 2.0, middle, sign, _SIGN, readable_on(ground), ground, anchor=1.0)
        room -= needed
        # Two allocations of one task that follow one another stay two.
        canvas.fill(Box(place.width - 1, 0, place.width, place.height), WHITE)
    if place.height >= _LEAST_FOR_TEXT and room > _LEAST_FOR_WORDS:
        words = shorten(bar.task, _BAR_TEXT, room - 6.0)
        # Of a longer name, three letters and a sign of omission say nothing.
        if words == bar.task or len(words) > 4:
            canvas.text(4.0, middle, words, _BAR_TEXT, ink, colour)


def _draw_incidents(canvas: Canvas, lane: Box, incidents: Sequence[Tuple[int, int, Severity]]) -> None:
    y = lane.centre[1]
    if incidents:
        canvas.text(lane.left, y, "incidents", SMALL, MUTED, WHITE)
    for left, right, severity in incidents:
        canvas.fill(Box(left, y + 4, right, y + 7), SEVERITY_COLOURS[severity])
    before: Dict[Severity, float] = {}
    for left, _, severity in incidents:
        # Where signs would cover one another, the first of a kind stands for those close to it.
        if left - before.get(severity, -math.inf) >= _BETWEEN_SIGNS:
            warning(canvas, (left, y), 6.5, severity)
            before[severity] = left
