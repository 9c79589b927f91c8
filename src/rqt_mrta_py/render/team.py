"""The team: light and name of each robot, what it does and since when."""

from __future__ import annotations

from rqt_mrta_py.model import RobotRecord, RobotState
from rqt_mrta_py.render.canvas import Box
from rqt_mrta_py.render.layout import BOLD, PLAIN, TEAM, inside, more, rows
from rqt_mrta_py.render.page import Page
from rqt_mrta_py.render.palette import GRID, INK, MUTED, WHITE
from rqt_mrta_py.render.signs import diamond, light
from rqt_mrta_py.render.text import shorten, text_width
from rqt_mrta_py.render.times import elapsed, whole_seconds

__all__ = ["LIGHT_OFFSET", "draw_team", "light_radius"]

LIGHT_OFFSET = 14.0
"""From the left of a row to the middle of its light [pixels]."""

_TALLEST, _LOWEST = 68.0, 24.0
_TWO_LINES = 40.0


def draw_team(page: Page) -> None:
    """Draw one row per robot.

    Args:
        page: drawn upon; frame and title are there.
    """
    box, canvas = inside(TEAM), page.canvas
    robots = page.view.record.robots
    if not robots:
        canvas.text(box.left, box.top + 14, "no robot seen yet", PLAIN, MUTED, WHITE)
    height, shown = rows(box, len(robots), _TALLEST, _LOWEST)
    names = max((text_width(robot.id, BOLD) for robot in robots[:shown]), default=0)
    for index, robot in enumerate(robots[:shown]):
        row = Box(box.left, box.top + index * height, box.right, box.top + (index + 1) * height)
        if index:
            canvas.fill(Box(row.left, round(row.top), row.right, round(row.top) + 1), GRID)
        light(canvas, (row.left + LIGHT_OFFSET, row.centre[1]), light_radius(height), robot.state)
        if height < _TWO_LINES:
            _draw_short_row(page, row.inset(32, 0, 0, 0), robot, names)
        else:
            _draw_row(page, row.inset(38, 0, 0, 0), robot)
    more(canvas, box, box.top + shown * height, height, len(robots) - shown)


def light_radius(height: float) -> float:
    """Give the radius of a light in a row of some height, both [pixels]."""
    return min(12.0, 0.5 * height - 5.0)


def _draw_row(page: Page, row: Box, robot: RobotRecord) -> None:
    canvas, middle = page.canvas, row.centre[1]
    spread = min(11.0, row.height / 4.0)
    state = canvas.text(row.right, middle - spread, robot.state.value, PLAIN, MUTED, WHITE, anchor=1.0)
    canvas.text(row.left, middle - spread, shorten(robot.id, BOLD, row.width - state - 8.0), BOLD, INK, WHITE)
    _draw_duty(page, row, robot, middle + spread)


def _draw_short_row(page: Page, row: Box, robot: RobotRecord, names: int) -> None:
    width = min(names, 0.42 * row.width)
    page.canvas.text(row.left, row.centre[1], shorten(robot.id, BOLD, width), BOLD, INK, WHITE)
    _draw_duty(page, row.inset(width + 12.0, 0, 0, 0), robot, row.centre[1])


def _draw_duty(page: Page, row: Box, robot: RobotRecord, y: float) -> None:
    """Write what a robot does and since when."""
    canvas, right = page.canvas, row.right
    held = page.open_by_robot.get(robot.id, ())
    since = held[-1].start if held else robot.states[-1].start if robot.states else None
    if since is not None:
        words = f"since {whole_seconds(elapsed(page.view, since))}"
        right -= canvas.text(right, y, words, PLAIN, MUTED, WHITE, anchor=1.0) + 8.0
    if not held:
        words = "silent" if robot.state is RobotState.OFFLINE else "no task"
        canvas.text(row.left, y, shorten(words, PLAIN, right - row.left), PLAIN, MUTED, WHITE)
        return
    if len(held) > 1:
        right -= canvas.text(right, y, f"+{len(held) - 1}", PLAIN, INK, WHITE, anchor=1.0) + 6.0
    diamond(canvas, (row.left + 6.0, y), 5.0, page.colours[held[-1].task])
    left = row.left + 17.0
    canvas.text(left, y, shorten(held[-1].task, PLAIN, right - left), PLAIN, INK, WHITE)
