"""Whether robots can stand where a scenario puts them; asked before anything is built."""

from __future__ import annotations

import math
from typing import Iterator, List, Sequence

from rqt_mrta_py.hooks import PlacedRobot
from rqt_mrta_py.model import Arena, Obstacle, Pose

__all__ = ["distance_to", "placement_problems"]

_TOUCH = 1e-9
"""Overlaps smaller than this are rounding [m]."""

_FARTHEST = 1e6
"""Nothing lies farther from the origin, or is longer [m]; beyond, squares of distances lose what robots are made of."""


def placement_problems(arena: Arena, obstacles: Sequence[Obstacle], robots: Sequence[PlacedRobot]) -> Sequence[str]:
    """Find what is wrong with arena, obstacles and start poses.

    Robots count as the circle around them, ``RobotModel.radius``.

    Args:
        arena: floor and walls.
        obstacles: fixed bodies.
        robots: where they start.

    Returns:
        One line for each problem: arena, then obstacles, then robots in their order; empty if there is none.
    """
    problems = [*_arena_problems(arena), *_obstacle_problems(obstacles)]
    if problems:
        return problems
    for robot in robots:
        if _is_finite(robot.start):
            problems.extend(_overlaps_of(robot, arena, obstacles))
        else:
            problems.append(f"robot {robot.id}: start pose must be finite (got {_spell(robot.start)})")
    return [*problems, *_meetings([robot for robot in robots if _is_finite(robot.start)])]


def _arena_problems(arena: Arena) -> Iterator[str]:
    sides = (arena.min_x, arena.min_y, arena.max_x, arena.max_y)
    if not (all(map(math.isfinite, sides)) and arena.min_x < arena.max_x and arena.min_y < arena.max_y):
        yield f"arena: must reach from a lower to a higher finite x and y (got min_x, min_y, max_x, max_y = {sides})"
    elif max(map(abs, sides)) > _FARTHEST:
        yield f"arena: must lie within {_FARTHEST:g} m of the origin (got min_x, min_y, max_x, max_y = {sides})"
    if not (math.isfinite(arena.wall_height) and arena.wall_height > 0):
        yield f"arena: wall_height must be above 0 m (got {arena.wall_height!r})"


def _obstacle_problems(obstacles: Sequence[Obstacle]) -> Iterator[str]:
    for obstacle in obstacles:
        if not _is_finite(obstacle.pose):
            yield f"obstacle {obstacle.id}: pose must be finite (got {_spell(obstacle.pose)})"
        elif max(abs(obstacle.pose.x), abs(obstacle.pose.y)) > _FARTHEST:
            where = _spell(obstacle.pose)
            yield f"obstacle {obstacle.id}: must lie within {_FARTHEST:g} m of the origin (got pose {where})"
        if not all(0 < side <= _FARTHEST for side in obstacle.size):
            yield f"obstacle {obstacle.id}: size must be above 0 m, at most {_FARTHEST:g} m (got {obstacle.size})"
        if obstacle.shape not in ("box", "cylinder"):
            yield f"obstacle {obstacle.id}: no shape {obstacle.shape!r}; give box or cylinder"


def _overlaps_of(robot: PlacedRobot, arena: Arena, obstacles: Sequence[Obstacle]) -> Iterator[str]:
    start, radius = robot.start, robot.model.radius
    inside = min(start.x - arena.min_x, arena.max_x - start.x, start.y - arena.min_y, arena.max_y - start.y)
    where = f"robot {robot.id}: start pose {_spell(start)}"
    if inside < 0:
        yield (
            f"{where} lies outside the arena (x {arena.min_x:g} to {arena.max_x:g}, y {arena.min_y:g} to "
            f"{arena.max_y:g}); its radius is {radius:g} m"
        )
    elif inside < radius - _TOUCH:
        yield f"{where} overlaps the wall by {radius - inside:.3g} m; keep its radius of {radius:g} m away from it"
    for obstacle in obstacles:
        gap = distance_to(start, obstacle) - radius
        if gap < -_TOUCH:
            yield (
                f"{where} overlaps obstacle {obstacle.id} by {-gap:.3g} m; keep its radius of {radius:g} m away from it"
            )


def distance_to(point: Pose, obstacle: Obstacle) -> float:
    """Measure from a point to an obstacle's surface, seen from above; negative inside [m]."""
    dx, dy = point.x - obstacle.pose.x, point.y - obstacle.pose.y
    if obstacle.shape == "cylinder":
        return math.hypot(dx, dy) - obstacle.size[0] / 2
    cos, sin = math.cos(obstacle.pose.yaw), math.sin(obstacle.pose.yaw)
    beside_x = abs(cos * dx + sin * dy) - obstacle.size[0] / 2
    beside_y = abs(cos * dy - sin * dx) - obstacle.size[1] / 2
    return math.hypot(max(beside_x, 0.0), max(beside_y, 0.0)) + min(max(beside_x, beside_y), 0.0)


def _meetings(robots: Sequence[PlacedRobot]) -> Iterator[str]:
    """Find robots that overlap robots before them; a row of distances at a time, for there may be thousands."""
    import numpy as np

    places = np.array([(r.start.x, r.start.y) for r in robots]).reshape(-1, 2)
    radii = np.array([r.model.radius for r in robots])
    for index, robot in enumerate(robots):
        apart = np.hypot(places[:index, 0] - robot.start.x, places[:index, 1] - robot.start.y)
        overlap = radii[:index] + robot.model.radius - apart
        others: List[int] = np.flatnonzero(overlap > _TOUCH).tolist()
        if others:
            names = ", ".join(f"{robots[i].id} by {overlap[i]:.3g} m" for i in others[:3])
            more = f" and {len(others) - 3} more" if len(others) > 3 else ""
            yield f"robot {robot.id}: start pose {_spell(robot.start)} overlaps {names}{more}; keep them apart"


def _is_finite(pose: Pose) -> bool:
    return math.isfinite(pose.x) and math.isfinite(pose.y) and math.isfinite(pose.yaw)


def _spell(pose: Pose) -> str:
    return f"({pose.x:g}, {pose.y:g}, {pose.yaw:g})"
