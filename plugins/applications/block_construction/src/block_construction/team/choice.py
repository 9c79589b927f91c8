"""From where a robot fetches a block, with its teammates where they are."""

from __future__ import annotations

import math
from typing import Collection, NamedTuple, Optional, Sequence, Tuple

from block_construction.team.peers import Dock, Peer, standing_places
from block_construction.team.traffic import Traffic

__all__ = ["Trip", "best_trip"]

_Place = Tuple[float, float]
_IN_THE_WAY = 1.5
"""What it counts that teammates must move first [m]."""


class Trip(NamedTuple):
    """A block fetched and placed.

    Attributes:
        cost: of both ways, and of teammates that are in the way [m].
        supply: index of the supply place.
    """

    cost: float
    supply: int


def best_trip(
    traffic: Traffic,
    here: _Place,
    docks: Tuple[Sequence[Dock], Dock],
    covered: Collection[Tuple[int, int]],
    peers: Sequence[Peer],
) -> Optional[Trip]:
    """Choose the supply place whose ways are shortest, around teammates and with what waiting for them counts.

    Args:
        traffic: knows ways.
        here: where the robot is [m].
        docks: of the supply places, and that of the slot.
        covered: columns and rows of the structure that blocks lie on.
        peers: its teammates.

    Returns:
        The trip; None if there is none, even without teammates.
    """
    idle = tuple(sorted(standing_places([peer for peer in peers if peer.idle])))
    busy = tuple(sorted(standing_places([peer for peer in peers if not peer.idle])))
    sources, slot = docks
    trips = []
    for number, source in enumerate(sources):
        kept = [place for place in idle if math.dist(place, here) >= traffic.clearance]
        if any(_is_near(traffic, dock, place) for dock in (source, slot) for place in kept):
            continue
        ways = [_counted(traffic, (place, source.place), covered, kept, busy) for place in (here, slot.place)]
        taken = sum(_is_near(traffic, dock, place) for dock in (source, slot) for place in busy)
        if None not in ways:
            trips.append(Trip(sum(way for way in ways if way is not None) + _IN_THE_WAY * min(taken, 2), number))
    return min(trips, default=None)


def _is_near(traffic: Traffic, dock: Dock, place: _Place) -> bool:
    return any(math.dist(point, place) < traffic.clearance for point in (dock.place, dock.ahead))


def _counted(
    traffic: Traffic,
    ends: Tuple[_Place, _Place],
    covered: Collection[Tuple[int, int]],
    idle: Sequence[_Place],
    busy: Sequence[_Place],
) -> Optional[float]:
    """Measure a way around those who stay, and around those who will leave if that is not too far."""
    past = traffic.length(*ends, covered, idle)
    if past is None:
        return None
    away = [place for place in busy if all(math.dist(place, end) >= traffic.clearance for end in ends)]
    around = traffic.length(*ends, covered, (*idle, *away))
    return past + _IN_THE_WAY if around is None else min(around, past + _IN_THE_WAY)
