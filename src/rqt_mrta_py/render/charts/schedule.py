"""What happened when: incidents, who held which task, how far tasks came."""

from __future__ import annotations

from typing import Any, Sequence, Tuple

from rqt_mrta_py.model import Allocation, Outcome, RobotRecord, RobotState, Severity, TaskRecord, TaskState
from rqt_mrta_py.render.canvas import Box
from rqt_mrta_py.render.charts.sheet import Sheet, rgb, write
from rqt_mrta_py.render.palette import (
    INK,
    MUTED,
    RED,
    SEVERITY_COLOURS,
    STATE_COLOURS,
    TASK_STATE_COLOURS,
    Colour,
    readable_on,
)
from rqt_mrta_py.render.signs import OUTCOME_SIGNS, TASK_SIGNS
from rqt_mrta_py.render.text import Style, shorten, text_width
from rqt_mrta_py.render.timeline import lanes

__all__ = ["draw_allocations", "draw_incident_lane", "draw_schedule_legend", "draw_task_legend", "draw_task_states"]

_NAME = Style(13, bold=True)
_BAR = Style(12)
_SIGN = Style(12, bold=True)
_SMALL = Style(12)
_BAD = (Outcome.LOST, Outcome.FAILED)
_ABOVE_LEAST = 11.0


def draw_incident_lane(sheet: Sheet, box: Box) -> None:
    """Draw a sign where each incident begins and a bar as long as it lasts.

    Args:
        sheet: drawn upon.
        box: the chart's.
    """
    axes = sheet.time_axes(box)
    middle = box.height / 2.0
    for severity in sorted(Severity, key=lambda severity: severity.rank):
        incidents = [incident for incident in sheet.view.record.incidents if incident.severity is severity]
        starts, ends = [incident.start for incident in incidents], [incident.end for incident in incidents]
        colour, at = rgb(SEVERITY_COLOURS[severity]), [middle] * len(incidents)
        axes.hlines(at, starts, ends, color=colour, linewidth=3)
        axes.plot(starts, at, "^", color=colour, markersize=10, markeredgecolor="white", clip_on=False)
    sheet.text(box.left - 10.0, box.centre[1], "incidents", _NAME, MUTED, "right")


def draw_allocations(sheet: Sheet, box: Box, robots: Sequence[RobotRecord]) -> None:
    """Draw one row per robot: bars of its allocations above a strip of its states.

    Args:
        sheet: drawn upon.
        box: the chart's.
        robots: those shown.
    """
    axes = sheet.time_axes(box)
    height = box.height / max(len(robots), 1)
    for index, robot in enumerate(robots):
        top = index * height
        sheet.text(box.left - 10.0, box.top + top + height / 2.0, shorten(robot.id, _NAME, 146.0), _NAME, INK, "right")
        strip = min(5.0, 0.18 * height)
        for state in RobotState:
            spans = [(each.start, each.end - each.start) for each in robot.states if each.state is state]
            axes.broken_barh(spans, (top + height - strip - 1.5, strip), facecolors=rgb(STATE_COLOURS[state]))
        given = lanes(sheet.by_robot.get(robot.id, ()))
        room = height - strip - 5.0
        lane_height = room / (max((lane for _, lane in given), default=0) + 1)
        for allocation, lane in given:
            _bar(sheet, axes, allocation, (top + 2.0 + lane * lane_height, lane_height))


def draw_task_states(sheet: Sheet, box: Box, tasks: Sequence[TaskRecord]) -> None:
    """Draw one row per task, in the colours of its states.

    Args:
        sheet: drawn upon.
        box: the chart's.
        tasks: those shown.
    """
    axes = sheet.time_axes(box)
    height = box.height / max(len(tasks), 1)
    for index, task in enumerate(tasks):
        top = index * height
        middle = box.top + top + height / 2.0
        name = shorten(task.id, _NAME, 136.0)
        sheet.text(box.left - 10.0, middle, name, _NAME, INK, "right")
        sheet.text(box.left - 18.0 - text_width(name, _NAME), middle, "◆", _NAME, sheet.colours[task.id], "right")
        for state in TaskState:
            spans = [(each.start, each.end - each.start) for each in task.history if each.state is state]
            axes.broken_barh(
                spans,
                (top + 2.0, height - 4.0),
                facecolors=rgb(TASK_STATE_COLOURS[state]),
                edgecolors="white",
                linewidth=0.5,
            )
        for interval in task.history:
            words = f"{TASK_SIGNS[interval.state]} {interval.state.value}"
            if height >= 14.0 and _pixels(sheet, interval.start, interval.end) > text_width(words, _SMALL) + 6:
                ink = readable_on(TASK_STATE_COLOURS[interval.state])
                centre = (interval.start + interval.end) / 2.0
                write(axes, centre, top + height / 2.0, words, _SMALL, ha="center", color=rgb(ink))


def draw_task_legend(sheet: Sheet, y: float, right: float) -> None:
    """Explain the colours of tasks' states in one line.

    Args:
        sheet: drawn upon.
        y: middle of the line [pixels].
        right: end of the line [pixels].
    """
    _legend(sheet, y, right, [("■", state.value, TASK_STATE_COLOURS[state]) for state in TaskState])


def draw_schedule_legend(sheet: Sheet, y: float, right: float) -> None:
    """Explain the colours of robots' states and the signs of outcomes and incidents in one line.

    Args:
        sheet: drawn upon.
        y: middle of the line [pixels].
        right: end of the line [pixels].
    """
    entries = [("■", f"robot {state.value}", STATE_COLOURS[state]) for state in RobotState]
    entries += [(sign, outcome.value.replace("_", " "), INK) for outcome, sign in OUTCOME_SIGNS.items() if sign]
    entries += [("▲", severity.value, SEVERITY_COLOURS[severity]) for severity in Severity]
    _legend(sheet, y, right, entries)


def _legend(sheet: Sheet, y: float, right: float, entries: Sequence[Tuple[str, str, Colour]]) -> None:
    for sign, words, colour in reversed(entries):
        sheet.text(right, y, words, _SMALL, MUTED, "right")
        right -= text_width(words, _SMALL) + 3.0
        sheet.text(right, y, sign, _NAME, colour, "right")
        right -= text_width(sign, _NAME) + 12.0


def _bar(sheet: Sheet, axes: Any, allocation: Allocation, place: Tuple[float, float]) -> None:
    top, height = place
    colour, sign = sheet.colours[allocation.task], OUTCOME_SIGNS[allocation.outcome]
    length = max(allocation.end - allocation.start, 1e-9)
    axes.broken_barh([(allocation.start, length)], place, facecolors=rgb(colour), edgecolors="white", linewidth=0.6)
    room = _pixels(sheet, allocation.start, allocation.end)
    per_pixel = (sheet.time.high - sheet.time.low) / (sheet.time.last - sheet.time.first)
    middle, right = top + height / 2.0, allocation.end
    needed = text_width(sign, _SIGN) + 6.0
    if sign and height >= _ABOVE_LEAST and room >= needed:
        width = needed * per_pixel
        ground = RED if allocation.outcome in _BAD else colour
        if ground is RED:
            axes.broken_barh([(right - width, width)], place, facecolors=rgb(RED), edgecolors="white", linewidth=0.6)
        write(axes, right - width / 2.0, middle, sign, _SIGN, ha="center", color=rgb(readable_on(ground)))
        room -= needed
    words = shorten(allocation.task, _BAR, room - 10.0)
    # Of a long name so little is left that it says nothing.
    if height >= _ABOVE_LEAST and (words == allocation.task or len(words) > 4):
        left = allocation.start + 5.0 * per_pixel
        write(axes, left, middle, words, _BAR, ha="left", color=rgb(readable_on(colour)))


def _pixels(sheet: Sheet, start: float, end: float) -> float:
    return sheet.time(end) - sheet.time(start)
