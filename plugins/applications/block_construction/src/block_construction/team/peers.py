"""What a robot knows of its teammates when it decides where to drive."""

from __future__ import annotations

from typing import NamedTuple, Optional, Sequence, Tuple

from block_construction.team.timed_way import TimedPoint, TimedWay

__all__ = ["Dock", "Peer", "dock_at", "occupied_ways", "peer_ways"]

_AT_DOCK = 0.03
"""How far from a dock a way may end that leads there [m]."""
_SLOWLY = 0.01
"""Speed between a dock and the place ahead of it [m/s]."""


class Dock(NamedTuple):
    """Where a robot stands before it fetches or places, and how far it goes on from there.

    Attributes:
        x, y: where it stands [m].
        ahead_x, ahead_y: the place straight ahead that it goes to and comes back from [m].
    """

    x: float
    y: float
    ahead_x: float
    ahead_y: float

    @property
    def place(self) -> Tuple[float, float]:
        """Where a robot stands [m]."""
        return self.x, self.y

    @property
    def is_berth(self) -> bool:
        """Tell whether a robot does nothing there but wait, so that it may leave for others."""
        return self.place == self.ahead

    @property
    def ahead(self) -> Tuple[float, float]:
        """Where it goes from there [m]."""
        return self.ahead_x, self.ahead_y


class Peer(NamedTuple):
    """A teammate.

    Attributes:
        id: of the robot.
        way: that it has reserved.
        dock: where its way leads; None if to no dock.
        goal: the dock where it wants to be, if it waits for a way; None if it does not wait.
        target: the dock from which it will place its block; None if it has no task.
        idle: whether it has nothing to do, and will not move before it has.
        task: id of the one under way; empty if none.
        lingers: whether it has placed its block and makes room until there is more to do.
    """

    id: str
    way: TimedWay
    dock: Optional[Dock] = None
    goal: Optional[Dock] = None
    target: Optional[Dock] = None
    idle: bool = False
    task: str = ""
    lingers: bool = False

    @property
    def announced(self) -> float:
        """When it reserved its way, or came to stand where it does [s]."""
        return self.way[0].time


def dock_at(place: Tuple[float, float], docks: Sequence[Dock]) -> Optional[Dock]:
    """Find the dock at a place; None if it is none."""
    found = [
        (round((dock.x - place[0]) ** 2 + (dock.y - place[1]) ** 2, 9), dock)
        for dock in docks
        if abs(dock.x - place[0]) <= _AT_DOCK and abs(dock.y - place[1]) <= _AT_DOCK
    ]
    return min(found)[1] if found else None


def occupied_ways(peer: Peer) -> Tuple[TimedWay, ...]:
    """Give the ways on which a teammate may be: as reserved, and beyond, where a dock is at the end."""
    if peer.dock is None:
        return (peer.way,)
    end, (x, y) = peer.way[-1], peer.dock.ahead
    took = (abs(x - end.x) + abs(y - end.y)) / _SLOWLY
    return peer.way, (*peer.way, TimedPoint(end.time + took, x, y))


def peer_ways(peers: Sequence[Peer]) -> Tuple[TimedWay, ...]:
    """Join the ways of all teammates."""
    return tuple(way for peer in peers for way in occupied_ways(peer))


def standing_places(peers: Sequence[Peer]) -> Tuple[Tuple[float, float], ...]:
    """Tell where teammates will stand once their ways have ended."""
    return tuple((way[-1].x, way[-1].y) for way in peer_ways(peers))
