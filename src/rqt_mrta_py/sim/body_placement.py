"""Whether loose bodies can lie where a scenario puts them; asked before anything is built."""

from __future__ import annotations

import math
from typing import Iterator, Sequence, Tuple

from rqt_mrta_py.hooks import PlacedRobot
from rqt_mrta_py.model import Arena, Dispenser, LooseBody, Obstacle, Pose
from rqt_mrta_py.sim.body_footprints import footprints_overlap
from rqt_mrta_py.sim.placement import distance_to
from rqt_mrta_py.sim.world_checks import WALL

__all__ = ["body_problems"]

_TOUCH = 1e-9
"""Overlaps smaller than this are rounding [m]."""

_NO_BODY = "size and mass must be above 0, friction at least 0, everything finite"

_Point = Tuple[float, float]


def body_problems(
    bodies: Sequence[LooseBody],
    arena: Arena,
    obstacles: Sequence[Obstacle],
    robots: Sequence[PlacedRobot],
    dispensers: Sequence[Dispenser] = (),
) -> Iterator[str]:
    """Find bodies that are none, whose ids are taken, or that lie outside the arena, in an obstacle or in a robot.

    A body lies in an obstacle if its centre or one of its corners does, or the obstacle's centre lies in the body.
    Robots count as the circle around them. Bodies may touch one another; where a dispenser puts them nothing else lies.

    Args:
        bodies: where they lie at the start.
        arena: floor and walls; sound.
        obstacles: fixed bodies; sound.
        robots: where they start; sound.
        dispensers: where further bodies come from.

    Yields:
        One line for each problem, in the order of bodies, then of dispensers.
    """
    taken = {WALL, *(obstacle.id for obstacle in obstacles), *(robot.id for robot in robots)}
    for body in bodies:
        if body.id in taken:
            yield f"body {body.id}: the id is taken by a wall, an obstacle, a robot or another body; give it its own"
        taken.add(body.id)
        if _is_none(body):
            yield f"body {body.id}: {_NO_BODY} (got {body})"
        else:
            yield from _misplaced(f"body {body.id}", body, arena, obstacles, robots)
    there = [body for body in bodies if not _is_none(body)]
    for dispenser in dispensers:
        name, first = f"dispenser {dispenser.id}", dispenser.body(1)
        clashes = sorted(other for other in taken if dispenser.gives(other))
        if dispenser.id in taken or any(before.gives(dispenser.id) for before in dispensers):
            yield f"{name}: the id is taken by a wall, an obstacle, a robot, a body or a dispenser; give it its own"
        elif clashes:
            yield f"{name}: the id is that of {clashes[0]} too, whose name its bodies have; give it another"
        taken.add(dispenser.id)
        if dispenser.stock is not None and dispenser.stock < 1:
            yield f"{name}: stock must be at least 1 (got {dispenser.stock!r})"
        if _is_none(first):
            yield f"{name}: {_NO_BODY} (got {dispenser})"
            continue
        yield from _misplaced(name, first, arena, obstacles, robots)
        for other in there:
            if footprints_overlap(first.pose, first.size, other.pose, other.size):
                yield f"{name}: where its bodies appear lies {other.id} too; keep them apart"
        there.append(first)


def _is_none(body: LooseBody) -> bool:
    numbers = (body.pose.x, body.pose.y, body.pose.yaw, *body.size, body.mass, body.friction)
    return not all(map(math.isfinite, numbers)) or min(*body.size, body.mass) <= 0.0 or body.friction < 0.0


def _misplaced(
    name: str, body: LooseBody, arena: Arena, obstacles: Sequence[Obstacle], robots: Sequence[PlacedRobot]
) -> Iterator[str]:
    where = f"{name}: place ({body.pose.x:g}, {body.pose.y:g}, {body.pose.yaw:g})"
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
