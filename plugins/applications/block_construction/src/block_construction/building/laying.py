"""Where a builder lays a block that it holds and has no use for."""

from __future__ import annotations

import math
from typing import Iterator, List, Optional, Tuple

from block_construction.building.routes import stand_off
from block_construction.building.seams import Traffic
from block_construction.building.site_map import SiteMap
from rqt_mrta_py.model import Pose

__all__ = ["places_along_walls", "spare_place"]

_FROM_WALL = 0.12
_APART = 0.1
"""Places that come into question: so far from a wall, and from each other [m]."""
_CLEAR = 0.35
"""So far is such a place from where robots stand, blocks wait and others lie [m]."""


def places_along_walls(arena: float) -> Iterator[Pose]:
    """List places along the walls, each faced by a robot that faces the wall, in a fixed order.

    Args:
        arena: side of the square [m].
    """
    count = math.floor((arena - 2.0 * _CLEAR) / _APART)
    for number in range(count + 1):
        along = _CLEAR + number * _APART
        yield Pose(along, _FROM_WALL, -math.pi / 2.0)
        yield Pose(along, arena - _FROM_WALL, math.pi / 2.0)
        yield Pose(_FROM_WALL, along, math.pi)
        yield Pose(arena - _FROM_WALL, along, 0.0)


def spare_place(site: SiteMap, traffic: Traffic, robot: Pose, arena: float) -> Optional[Pose]:
    """Find the place with the shortest way where a block lies in nobody's way.

    Args:
        site: what is known of blocks, slots and supply places.
        traffic: knows ways.
        robot: where it is.
        arena: side of the square [m].

    Returns:
        Where to lay it, faced by the robot; None if there is no such place.
    """
    taken: List[Tuple[float, float]] = [(seen.x, seen.y) for seen in site.loose.values()]
    for fetch in site.supply:
        stand = stand_off(fetch.facing)
        taken += [(fetch.x, fetch.y), (stand.x, stand.y)]
    for slot in site.slots.values():
        stand = stand_off(slot.facing)
        taken += [(slot.x, slot.y), (stand.x, stand.y)]
    found: List[Tuple[float, int, Pose]] = []
    for number, place in enumerate(places_along_walls(arena)):
        if any(math.dist((place.x, place.y), other) < _CLEAR for other in taken):
            continue
        stand = stand_off(place)
        length = traffic.length((robot.x, robot.y), (stand.x, stand.y), site.covered)
        if length is not None:
            found.append((length, number, place))
    return min(found, default=(0.0, 0, None), key=lambda each: each[:2])[2]
