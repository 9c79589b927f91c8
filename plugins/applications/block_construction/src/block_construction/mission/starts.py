"""Where robots begin a build."""

from __future__ import annotations

import math
from typing import Iterator, List, Sequence, Tuple

from block_construction.errors import ConstructionError
from block_construction.execution.arena import Point
from block_construction.execution.problem import BuildProblem
from block_construction.mission.fetching import Ready
from rqt_mrta_py.model import Pose

__all__ = ["start_point", "start_poses"]

_FROM_WALL = 0.3
_APART = 0.45
"""From other robots and from the middle of what lies ready [m]."""


def start_point(side: float) -> Tuple[float, float]:
    """Give where the first robot begins where nothing else is said: before the middle of the lower wall.

    Args:
        side: of the arena [m].

    Returns:
        x, y [m].
    """
    return (side / 2.0, _FROM_WALL)


def start_poses(problem: BuildProblem, ready: Sequence[Ready], robots: int) -> Tuple[Pose, ...]:
    """Give where robots begin: before the middles of the walls, then between those, facing the arena's middle.

    Args:
        problem: what is built, and where; the first robot begins where its arena says.
        ready: what lies ready.
        robots: how many there are.

    Raises:
        ConstructionError: there is no room for so many.
    """
    arena, site = problem.arena, problem.site
    chosen: List[Point] = [Point(*arena.start)]
    for place in _along_walls(arena.side):
        if len(chosen) == robots:
            break
        others = [*chosen, *(Point(each.x, each.y) for each in ready)]
        near = min(math.hypot(place.x - other.x, place.y - other.y) for other in others)
        if near >= _APART and site.distance(place) >= arena.robot_radius:
            chosen.append(place)
    if len(chosen) < robots:
        raise ConstructionError(
            f"{problem.diagram.structure.name}: {robots} robots have no room to begin beside the site, the supply and "
            f"each other; {len(chosen)} have"
        )
    middle = arena.middle
    return tuple(Pose(x, y, math.atan2(middle.y - y, middle.x - x)) for x, y in chosen)


def _along_walls(side: float) -> Iterator[Point]:
    near, far = _FROM_WALL, side - _FROM_WALL
    for share in (0.5, 0.25, 0.75):
        along = side * share
        yield Point(along, near)
        yield Point(along, far)
        yield Point(near, along)
        yield Point(far, along)
