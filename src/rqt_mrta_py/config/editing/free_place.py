"""A place in an arena that is far from everything that stands there."""

from __future__ import annotations

import math
from typing import Iterator, Optional, Sequence, Tuple

from rqt_mrta_py.model import ScenarioSpec

__all__ = ["free_place"]

_STEP = 0.5
_MOST_STEPS = 40
_CLEARANCE = 0.5
"""So far must a robot's middle be from walls, obstacles and others [m]."""

Point = Tuple[float, float]


def free_place(scenario: ScenarioSpec, taken: Sequence[Point] = ()) -> Optional[Point]:
    """Find the place with the most room around it.

    Args:
        scenario: with arena, obstacles, loose bodies and the robots' starts.
        taken: further places to keep away from, in the frame ``map`` [m].

    Returns:
        Its position in the frame ``map`` [m], the first by rows where several have as much room; None if there is
        no room of half a metre anywhere.
    """
    starts = [*(robot.start for robot in scenario.robots), *(body.pose for body in scenario.first_bodies)]
    points = [*((start.x, start.y) for start in starts), *taken]
    best: Optional[Point] = None
    most = _CLEARANCE
    for x, y in _grid(scenario):
        room = _room(scenario, points, x, y, most)
        if room > most or (best is None and room >= most):
            best, most = (x, y), room
    return best


def _grid(scenario: ScenarioSpec) -> Iterator[Point]:
    arena = scenario.arena
    for y in _steps(arena.min_y, arena.max_y):
        for x in _steps(arena.min_x, arena.max_x):
            yield x, y


def _steps(low: float, high: float) -> Iterator[float]:
    count = min(_MOST_STEPS, int((high - low) / _STEP))
    for index in range(1, count):
        yield round(low + (high - low) * index / count, 2)


def _room(scenario: ScenarioSpec, points: Sequence[Point], x: float, y: float, enough: float) -> float:
    """Give the distance to whatever is nearest; any smaller value than ``enough`` if it is not reached."""
    arena = scenario.arena
    room = min(x - arena.min_x, arena.max_x - x, y - arena.min_y, arena.max_y - y)
    for obstacle in scenario.obstacles:
        if room < enough:
            return room
        length, width, _ = obstacle.size
        room = min(room, math.hypot(x - obstacle.pose.x, y - obstacle.pose.y) - math.hypot(length, width) / 2)
    for other_x, other_y in points:
        if room < enough:
            return room
        room = min(room, math.hypot(x - other_x, y - other_y))
    return room
