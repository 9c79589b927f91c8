"""Whether what lies ready is in anybody's way: of walls, of the structure, of each other, of robots that stand."""

from __future__ import annotations

import math
from itertools import combinations
from typing import Iterator, Sequence, Tuple

from block_construction.diagram.block_set import BODY_WIDTH, body_size
from block_construction.errors import ConstructionError
from block_construction.execution.arena import Point
from block_construction.execution.problem import BuildProblem
from block_construction.mission.fetching import Ready

__all__ = ["check_lying"]

_Corners = Sequence[Tuple[float, float]]
_SLACK = 1e-9


def check_lying(problem: BuildProblem, ready: Sequence[Ready]) -> None:
    """Make sure that blocks can lie ready where they shall, and that robots can stand beside them.

    Args:
        problem: what is built, and where.
        ready: what lies ready.

    Raises:
        ConstructionError: a block lies beyond a wall, within the site or in another one, or where a robot stands; names
            the supply place.
    """
    arena, site = problem.arena, problem.site
    corners = {each: _corners(each) for each in ready}
    floor = ((site.left, site.bottom), (site.right, site.bottom), (site.right, site.top), (site.left, site.top))
    for each, points in corners.items():
        if not all(-_SLACK <= value <= arena.side + _SLACK for point in points for value in point):
            raise ConstructionError(f"{_named(each)} reach beyond a wall of the arena, which measures {arena.side:g} m")
        if _overlap(points, floor):
            raise ConstructionError(
                f"{_named(each)} reach into the site, which reaches from ({site.left:g}, {site.bottom:g}) to "
                f"({site.right:g}, {site.top:g}) m"
            )
    for one, other in combinations(ready, 2):
        if _overlap(corners[one], corners[other]):
            raise ConstructionError(
                f"{_named(other)} lie where those of {one.units} units of place {one.place} do; keep them apart"
            )
    for point, why in _stands(problem, ready):
        for each in ready:
            gap = _distance(each, point)
            if gap < arena.robot_radius - _SLACK:
                raise ConstructionError(
                    f"{_named(each)} lie {gap:.3g} m from ({point.x:.3g}, {point.y:.3g}) m, where a robot {why}; at "
                    f"least {arena.robot_radius:g} m away is accepted"
                )


def _named(ready: Ready) -> str:
    return f"supply place {ready.place}: blocks of {ready.units} units"


def _stands(problem: BuildProblem, ready: Sequence[Ready]) -> Iterator[Tuple[Point, str]]:
    """List where robots stand, and what for."""
    yield Point(*problem.arena.start), "begins"
    for each in ready:
        yield each.stand(problem.arena.stand_off), f"fetches from place {each.place}"
    for block, approach in zip(problem.diagram.blocks, problem.approaches):
        yield approach.point, f"places block {block.number}"


def _corners(ready: Ready) -> _Corners:
    """Give the corners of a block that lies ready, in their order around it [m]."""
    half_length, half_width = body_size(ready.units).length / 2.0, BODY_WIDTH / 2.0
    cos, sin = math.cos(ready.yaw), math.sin(ready.yaw)
    return [
        (ready.x + cos * along - sin * across, ready.y + sin * along + cos * across)
        for along, across in (
            (half_length, half_width),
            (-half_length, half_width),
            (-half_length, -half_width),
            (half_length, -half_width),
        )
    ]


def _overlap(one: _Corners, other: _Corners) -> bool:
    """Tell whether two rectangles have more in common than an edge: no side of either has them on both its sides."""
    for corners in (one, other):
        for (x, y), (next_x, next_y) in zip(corners, (*corners[1:], corners[0])):
            across_x, across_y = next_y - y, x - next_x
            first, second = ([across_x * px + across_y * py for px, py in each] for each in (one, other))
            if max(first) <= min(second) + _SLACK or max(second) <= min(first) + _SLACK:
                return False
    return True


def _distance(ready: Ready, point: Point) -> float:
    """Tell how far a point is from a block that lies ready [m]; 0 within it."""
    cos, sin = math.cos(ready.yaw), math.sin(ready.yaw)
    dx, dy = point.x - ready.x, point.y - ready.y
    beside = abs(cos * dx + sin * dy) - body_size(ready.units).length / 2.0
    before = abs(cos * dy - sin * dx) - BODY_WIDTH / 2.0
    return math.hypot(max(beside, 0.0), max(before, 0.0))
