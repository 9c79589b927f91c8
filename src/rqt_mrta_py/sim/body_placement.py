"""Whether loose bodies can lie where a scenario puts them; asked before anything is built."""

from __future__ import annotations

import math
from typing import Iterator, Sequence, Tuple

from rqt_mrta_py.hooks import PlacedRobot
from rqt_mrta_py.model import Arena, LooseBody, Obstacle, Pose
from rqt_mrta_py.sim.placement import distance_to
from rqt_mrta_py.sim.world_checks import WALL

__all__ = ["body_problems"]

_TOUCH = 1e-9
"""Overlaps smaller than this are rounding [m]."""

_Point = Tuple[float, float]


def body_problems(
    bodies: Sequence[LooseBody], arena: Arena, obstacles: Sequence[Obstacle], robots: Sequence[PlacedRobot]
) -> Iterator[str]:
    """Find bodies that are none, whose ids are taken, or that lie outside the arena, in an obstacle or in a robot.

    A body lies in an obstacle if its centre or one of its corners does, or the obstacle's centre lies in the body.
    Robots count as the circle around them. Bodies may touch one another.

    Args:
        bodies: where they lie at the start.
        arena: floor and walls; sound.
        obstacles: fixed bodies; sound.
        robots: where they start; sound.

    Yields:
        One line for each problem, in the order of bodies.
    """
    taken = {WALL, *(obstacle.id for obstacle in obstacles), *(robot.id for robot in robots)}
    for body in bodies:
        if body.id in taken:
            yield f"body {body.id}: the id is taken by a wall, an obstacle, a robot or another body; give it its own"
        taken.add(body.id)
        numbers = (body.pose.x, body.pose.y, body.pose.yaw, *body.size, body.mass)
        if not all(map(math.isfinite, numbers)) or min(*body.size, body.mass) <= 0.0:
            yield f"body {body.id}: size and mass must be above 0, everything finite (got {body})"
            continue
        yield from _misplaced(body, arena, obstacles, robots)


def _misplaced(
    body: LooseBody, arena: Arena, obstacles: Sequence[Obstacle], robots: Sequence[PlacedRobot]
) -> Iterator[str]:
    where = f"body {body.id}: place ({body.pose.x:g}, {body.pose.y:g}, {body.pose.yaw:g})"
    corners = _corners(body)
    beyond = max(max(arena.min_x - x, x - arena.max_x, arena.min_y - y, y - arena.max_y) for x, y in corners)
    if beyond > _TOUCH:
        yield (
            f"{where} reaches {beyond:.3g} m beyond the arena (x {arena.min_x:g} to {arena.max_x:g}, "
            f"y {arena.min_y:g} to {arena.max_y:g})"
        )
    footprint = Obstacle(body.id, body.pose, body.size)
    for obstacle in obstacles:
        points = ((body.pose.x, body.pose.y), *corners)
        depth = -min(
            *(distance_to(Pose(x, y), obstacle) for x, y in points),
            distance_to(obstacle.pose, footprint),
        )
        if depth > _TOUCH:
            yield f"{where} lies {depth:.3g} m inside obstacle {obstacle.id}; move one of them"
    for robot in robots:
        depth = robot.model.radius - distance_to(robot.start, footprint)
        if depth > _TOUCH:
            yield f"{where} overlaps robot {robot.id} by {depth:.3g} m; keep them apart"


def _corners(body: LooseBody) -> Sequence[_Point]:
    cos, sin = math.cos(body.pose.yaw), math.sin(body.pose.yaw)
    length, width, _ = body.size
    return [
        (body.pose.x + cos * dx - sin * dy, body.pose.y + sin * dx + cos * dy)
        for dx, dy in (
            (length / 2, width / 2),
            (-length / 2, width / 2),
            (-length / 2, -width / 2),
            (length / 2, -width / 2),
        )
    ]
