"""The team: light and name of each robot, what it does and since when."""

from __future__ import annotations

from typing import List

from rqt_mrta_py.hooks import MonitorView
from rqt_mrta_py.model import Allocation, Outcome, RobotRecord, RobotState
from rqt_mrta_py.render.canvas import Box, Canvas
from rqt_mrta_py.render.layout import BOLD, PLAIN, TEAM, inside, more, rows
from rqt_mrta_py.render.palette import GRID, INK, MUTED, WHITE, TaskColours
from rqt_mrta_py.render.signs import diamond, light
from rqt_mrta_py.render.text import fit
from rqt_mrta_py.render.times import elapsed, seconds

__all__ = ["LIGHT_OFFSET", "draw_team", "light_radius"]

LIGHT_OFFSET = 16.0
"""From the left of a row to the middle of its light [pixels]."""

_TALLEST, _LOWEST = 68.0, 24.0
_TWO_LINES = 40.0


def draw_team(canvas: Canvas, view: MonitorView, colours: TaskColours) -> None:
    """Draw one row per robot.

    Args:
        canvas: drawn upon.
        view: the mission.
        colours: of its tasks.
    """
    box = inside(TEAM)
    robots = view.record.robots
    if not robots:
        canvas.text(box.left, box.top + 14, "no robot seen yet", PLAIN, MUTED, WHITE)
    height, shown = rows(box, len(robots), _TALLEST, _LOWEST)
    for index, robot in enumerate(robots[:shown]):
        row = Box(box.left, box.top + index * height, box.right, box.top + (index + 1) * height)
        if index:
            canvas.fill(Box(row.left, round(row.top), row.right, round(row.top) + 1), GRID)
        held = [a for a in view.record.allocations if a.robot == robot.id and a.outcome is Outcome.OPEN]
        _draw_row(canvas, row, view, robot, held, colours)
    more(canvas, box, box.top + shown * height, height, len(robots) - shown)


def light_radius(height: float) -> float:
    """Give the radius of a light in a row of some height, both [pixels]."""
    return min(11.0, 0.5 * height - 5.0)


def _draw_row(
    canvas: Canvas, row: Box, view: MonitorView, robot: RobotRecord, held: List[Allocation], colours: TaskColours
) -> None:
    middle = row.centre[1]
    light(canvas, (row.left + LIGHT_OFFSET, middle), light_radius(row.height), robot.state)
    left = row.left + 38.0
    if row.height < _TWO_LINES:
        name = fit(robot.id, BOLD, 0.45 * (row.right - left))
        canvas.text(left, middle, name, BOLD, INK, WHITE)
        _draw_duty(canvas, left + 0.48 * (row.right - left), row.right, middle, view, robot, held, colours)
        return
    spread = min(11.0, row.height / 4.0)
    upper, lower = middle - spread, middle + spread
    state = canvas.text(row.right, upper, robot.state.value, PLAIN, MUTED, WHITE, anchor=1.0)
    canvas.text(left, upper, fit(robot.id, BOLD, row.right - left - state - 8.0), BOLD, INK, WHITE)
    _draw_duty(canvas, left, row.right, lower, view, robot, held, colours)


def _draw_duty(
    canvas: Canvas,
    left: float,
    right: float,
    y: float,
    view: MonitorView,
    robot: RobotRecord,
    held: List[Allocation],
    colours: TaskColours,
) -> None:
    """Write what a robot does and since when."""
    if not held:
        since = robot.states[-1].start if robot.states else None
        words = "silent" if robot.state is RobotState.OFFLINE else "no task"
        if since is not None:
            taken = canvas.text(right, y, f"since {seconds(elapsed(view, since))}", PLAIN, MUTED, WHITE, anchor=1.0)
            right -= taken + 8.0
        canvas.text(left, y, fit(words, PLAIN, right - left), PLAIN, MUTED, WHITE)
        return
    newest = held[-1]
    since_words = f"since {seconds(elapsed(view, newest.start))}"
    right -= canvas.text(right, y, since_words, PLAIN, MUTED, WHITE, anchor=1.0) + 8.0
    if len(held) > 1:
        right -= canvas.text(right, y, f"+{len(held) - 1}", PLAIN, INK, WHITE, anchor=1.0) + 6.0
    diamond(canvas, (left + 6.0, y), 5.0, colours[newest.task])
    canvas.text(left + 17.0, y, fit(newest.task, PLAIN, right - left - 17.0), PLAIN, INK, WHITE)
