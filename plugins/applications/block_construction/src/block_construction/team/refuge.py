"""Places to go aside to, for robots that are in the way of one that has waited long."""

from __future__ import annotations

import math
from typing import Collection, List, Optional, Sequence, Tuple

from block_construction.team.peers import Peer, peer_ways, standing_places
from block_construction.team.timed_way import TimedPoint, TimedWay, is_apart
from block_construction.team.traffic import Traffic

__all__ = ["find_haven", "find_refuge", "is_off", "places_around", "wanted_way"]

_Place = Tuple[float, float]
_Covered = Collection[Tuple[int, int]]
_SPACING = 0.10
_MOST = 12
_ROOM = 0.045
"""Kept clear on both sides of a way beyond the clearance, for ways are found on a lattice, and hardly in a gap that is
just wide enough [m]."""


def wanted_way(traffic: Traffic, peer: Peer, covered: _Covered, peers: Sequence[Peer]) -> Tuple[_Place, ...]:
    """Give the corners of the shortest way of a robot that waits, around those who will not move, to ahead of its dock.

    Args:
        traffic: knows the ways.
        peer: that waits.
        covered: columns and rows of the structure that blocks lie on.
        peers: all teammates.

    Returns:
        Its ends included; empty if it waits for nothing, or those who will not move leave no way.
    """
    if peer.goal is None:
        return ()
    end = peer.way[-1]
    idle = standing_places([each for each in peers if each.idle])
    corners = traffic.corners((end.x, end.y), peer.goal.place, covered, idle)
    return () if corners is None else (*corners, peer.goal.ahead)


def is_off(traffic: Traffic, place: _Place, corners: Sequence[_Place]) -> bool:
    """Tell whether a robot at a place leaves a way clear, and room to find it.

    Where the way begins, and its robot stands already, the clearance is enough.
    """
    begin, room = math.dist(place, corners[0]), traffic.clearance + _ROOM
    if begin < traffic.clearance:
        return False
    return all(
        is_apart(TimedPoint(0.0, *one), TimedPoint(1.0, *other), (TimedPoint(0.0, *place),), min(room, begin))
        for one, other in zip(corners, corners[1:])
    )


def find_refuge(
    traffic: Traffic, start: TimedPoint, covered: _Covered, peers: Sequence[Peer], wanted: Sequence[Sequence[_Place]]
) -> Optional[TimedWay]:
    """Find the way to the nearest place off others' ways.

    Args:
        traffic: plans ways.
        start: where the robot is, and when it can leave.
        covered: columns and rows of the structure that blocks lie on.
        peers: all teammates.
        wanted: corners of the ways that are to be left clear.

    Returns:
        The way there; None if there is none.
    """
    here, ways, tried = (start.x, start.y), peer_ways(peers), 0
    standing = standing_places(peers)
    for place in places_around(traffic.side, here):
        if not (all(is_off(traffic, place, way) for way in wanted) and traffic.has_room(place, covered)):
            continue
        if traffic.length(here, place, covered, standing) is None:
            continue
        found = traffic.plan(here, place, start.time, covered, ways)
        tried += 1
        if found is not None or tried >= _MOST:
            return found
    return None


def find_haven(
    traffic: Traffic, here: _Place, covered: _Covered, fixed: Sequence[_Place], wanted: Sequence[Sequence[_Place]]
) -> Optional[_Place]:
    """Find the nearest place off others' ways that could be got to if those who can move made way.

    Args:
        traffic: knows ways.
        here: where the robot is [m].
        covered: columns and rows of the structure that blocks lie on.
        fixed: where those stand who cannot make way [m].
        wanted: corners of the ways that are to be left clear.

    Returns:
        The place [m]; None if there is none.
    """
    for place in places_around(traffic.side, here):
        is_clear = all(is_off(traffic, place, way) for way in wanted) and traffic.has_room(place, covered)
        if is_clear and traffic.length(here, place, covered, fixed) is not None:
            return place
    return None


def places_around(side: float, here: _Place) -> List[_Place]:
    """List places all over the arena, the nearest first [m]."""
    count = int(side / _SPACING)
    lines = [(number + 0.5) * side / count for number in range(count)]
    places = [(x, y) for x in lines for y in lines]
    return sorted(places, key=lambda place: (round(math.dist(place, here), 9), place))
