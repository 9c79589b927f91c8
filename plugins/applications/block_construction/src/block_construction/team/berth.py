"""Where a robot with nothing to do leaves room for everybody who has."""

from __future__ import annotations

import math
from typing import Collection, List, Optional, Sequence, Tuple

from block_construction.team.peers import Peer, standing_places
from block_construction.team.traffic import Traffic

__all__ = ["find_berth"]

_Place = Tuple[float, float]
_INSET = 0.38
"""From both walls of a corner to a berth: beside the supply place there, off the docks of the structure [m]."""
_TAKEN = 3.0
"""What it counts that the way is not free yet [m]."""


def find_berth(
    traffic: Traffic, here: _Place, covered: Collection[Tuple[int, int]], peers: Sequence[Peer]
) -> Optional[_Place]:
    """Choose the nearest corner that no teammate makes for, and that closes nobody's way.

    Who stands in a corner keeps nobody from the docks on both sides of it, and is where the next block is fetched.

    Args:
        traffic: knows ways.
        here: where the robot is [m].
        covered: columns and rows of the structure that blocks lie on.
        peers: its teammates.

    Returns:
        The place [m]; None if there is none.
    """
    near, far = _INSET, traffic.side - _INSET
    corners = ((near, near), (far, near), (near, far), (far, far))
    idle = standing_places([peer for peer in peers if peer.idle])
    busy = standing_places([peer for peer in peers if not peer.idle])
    wanted = [place for peer in peers for place in _wanted(peer)]
    found = []
    for place in corners:
        past = traffic.length(here, place, covered, idle)
        if past is None or any(math.dist(place, other) < traffic.clearance for other in (*idle, *busy, *wanted)):
            continue
        closed = (*idle, place)
        if not all(_is_open(traffic, peer, covered, closed) for peer in peers):
            continue
        if not all(_has_corner(traffic, peer, covered, closed, corners) for peer in peers if not peer.idle):
            continue
        away = [other for other in busy if math.dist(here, other) >= traffic.clearance]
        around = traffic.length(here, place, covered, (*idle, *away))
        found.append((past + _TAKEN if around is None else around, place))
    return min(found)[1] if found else None


def _wanted(peer: Peer) -> List[_Place]:
    """List where a teammate wants to be, one after the other."""
    return [dock.place for dock in (peer.goal, peer.target) if dock is not None]


def _is_open(traffic: Traffic, peer: Peer, covered: Collection[Tuple[int, int]], standing: Sequence[_Place]) -> bool:
    """Tell whether a teammate can get to where it wants to be."""
    end, legs = peer.way[-1], _wanted(peer)
    starts = [(end.x, end.y), *legs]
    return all(traffic.length(one, other, covered, standing) is not None for one, other in zip(starts, legs))


def _has_corner(
    traffic: Traffic,
    peer: Peer,
    covered: Collection[Tuple[int, int]],
    standing: Sequence[_Place],
    corners: Sequence[_Place],
) -> bool:
    """Tell whether a corner is left for a teammate."""
    end = peer.way[-1]
    return any(
        all(math.dist(corner, other) >= traffic.clearance for other in standing)
        and traffic.length((end.x, end.y), corner, covered, standing) is not None
        for corner in corners
    )
