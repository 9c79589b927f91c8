"""The team: light and name of each robot, what it does and since when."""

from __future__ import annotations

from typing import NamedTuple, Optional, Sequence, Tuple

from rqt_mrta_py.model import Allocation, RobotRecord, RobotState
from rqt_mrta_py.render.canvas import Box, Canvas
from rqt_mrta_py.render.foremost import foremost_robots
from rqt_mrta_py.render.layout import BOLD, PLAIN, SMALL, TEAM, inside, more, rows
from rqt_mrta_py.render.page import Page, Part, by_robot
from rqt_mrta_py.render.palette import GRID, INK, MUTED, WHITE, Colour
from rqt_mrta_py.render.signs import diamond, light
from rqt_mrta_py.render.text import shorten, text_width
from rqt_mrta_py.render.times import elapsed, whole_seconds

__all__ = ["LIGHT_OFFSET", "light_radius", "team_part", "team_rows"]

LIGHT_OFFSET = 14.0
"""From the left of a row to the middle of its light [pixels]."""

_TALLEST, _LOWEST = 68.0, 24.0
_TWO_LINES = 40.0
_COUNTED = (RobotState.OFFLINE, RobotState.IDLE, RobotState.BUSY)


class _Row(NamedTuple):
    """What one robot's row says; ``task`` with its ``colour`` is None if it holds none, ``others`` counts further."""

    robot: str
    state: RobotState
    task: Optional[str]
    colour: Colour
    others: int
    since: str


class _Team(NamedTuple):
    """What the panel says: its rows, of how many robots, and how many of these are in which state."""

    rows: Tuple[_Row, ...]
    robots: int
    height: float
    counts: Tuple[int, ...]


def team_rows(robots: int) -> Tuple[float, int]:
    """Give the height of a row [pixels] and how many of so many robots are shown."""
    return rows(inside(TEAM), robots, _TALLEST, _LOWEST)


def team_part(page: Page) -> Part:
    """Say what the panel of the team shows: one row per robot, the foremost if there are many; above, counts.

    Args:
        page: the mission.
    """
    robots = page.view.record.robots
    height, shown = team_rows(len(robots))
    states = list(page.states.values())
    foremost = foremost_robots(page.view, shown, page.troubled)
    held = by_robot(page.held, [robot.id for robot in foremost])
    content = _Team(
        tuple([_row(page, robot, held[robot.id]) for robot in foremost]),
        len(robots),
        height,
        tuple(states.count(state) for state in _COUNTED),
    )
    return Part(TEAM, content, _draw_team)


def light_radius(height: float) -> float:
    """Give the radius of a light in a row of some height, both [pixels]."""
    return min(12.0, 0.5 * height - 5.0)


def _row(page: Page, robot: RobotRecord, held: Sequence[Allocation]) -> _Row:
    since = held[-1].start if held else robot.states[-1].start if robot.states else None
    words = "" if since is None else f"since {whole_seconds(elapsed(page.view, since))}"
    if not held:
        return _Row(robot.id, robot.state, None, MUTED, 0, words)
    return _Row(robot.id, robot.state, held[-1].task, page.colours[held[-1].task], len(held) - 1, words)


def _draw_team(canvas: Canvas, team: _Team) -> None:
    box = inside(TEAM)
    if not team.rows:
        canvas.text(box.left, box.top + 14, "no robot seen yet", PLAIN, MUTED, WHITE)
        return
    _draw_counts(canvas, team.counts)
    names = max(text_width(row.robot, BOLD) for row in team.rows)
    for index, row in enumerate(team.rows):
        place = Box(box.left, box.top + index * team.height, box.right, box.top + (index + 1) * team.height)
        if index:
            canvas.fill(Box(place.left, round(place.top), place.right, round(place.top) + 1), GRID)
        light(canvas, (place.left + LIGHT_OFFSET, place.centre[1]), light_radius(team.height), row.state)
        if team.height < _TWO_LINES:
            _draw_short_row(canvas, place.inset(32, 0, 0, 0), row, names)
        else:
            _draw_row(canvas, place.inset(38, 0, 0, 0), row)
    more(canvas, box, box.top + len(team.rows) * team.height, team.height, team.robots - len(team.rows))


def _draw_counts(canvas: Canvas, counts: Tuple[int, ...]) -> None:
    """Count the robots in each state, from right to left, beside the panel's title."""
    x, y = TEAM.right - 12.0, TEAM.top + 15.0
    for state, count in zip(_COUNTED, counts):
        if count:
            x -= canvas.text(x, y, f"{count} {state.value}", SMALL, MUTED, WHITE, anchor=1.0) + 9.0
            light(canvas, (x, y), 4.5, state)
            x -= 17.0


def _draw_row(canvas: Canvas, place: Box, row: _Row) -> None:
    middle = place.centre[1]
    spread = min(11.0, place.height / 4.0)
    state = canvas.text(place.right, middle - spread, row.state.value, PLAIN, MUTED, WHITE, anchor=1.0)
    canvas.text(place.left, middle - spread, shorten(row.robot, BOLD, place.width - state - 8.0), BOLD, INK, WHITE)
    _draw_duty(canvas, place, row, middle + spread)


def _draw_short_row(canvas: Canvas, place: Box, row: _Row, names: int) -> None:
    width = min(names, 0.42 * place.width)
    canvas.text(place.left, place.centre[1], shorten(row.robot, BOLD, width), BOLD, INK, WHITE)
    _draw_duty(canvas, place.inset(width + 12.0, 0, 0, 0), row, place.centre[1])


def _draw_duty(canvas: Canvas, place: Box, row: _Row, y: float) -> None:
    """Write what a robot does and since when."""
    right = place.right
    if row.since:
        right -= canvas.text(right, y, row.since, PLAIN, MUTED, WHITE, anchor=1.0) + 8.0
    if row.task is None:
        words = "silent" if row.state is RobotState.OFFLINE else "no task"
        canvas.text(place.left, y, shorten(words, PLAIN, right - place.left), PLAIN, MUTED, WHITE)
        return
    if row.others:
        right -= canvas.text(right, y, f"+{row.others}", PLAIN, INK, WHITE, anchor=1.0) + 6.0
    diamond(canvas, (place.left + 6.0, y), 5.0, row.colour)
    left = place.left + 17.0
    canvas.text(left, y, shorten(row.task, PLAIN, right - left), PLAIN, INK, WHITE)
