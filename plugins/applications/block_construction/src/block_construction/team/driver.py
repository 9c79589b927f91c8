"""Where one robot drives when: it reserves ways, takes them back where another was first, and goes aside."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Collection, List, Optional, Sequence, Tuple

from block_construction.team.peers import Dock, Peer, peer_ways, standing_places
from block_construction.team.refuge import find_haven, find_refuge, is_off, wanted_way
from block_construction.team.timed_way import TimedPoint, TimedWay, is_apart, place_at
from block_construction.team.traffic import Traffic

__all__ = ["Driver", "DriverSettings", "conflicts"]

_Place = Tuple[float, float]
_Covered = Collection[Tuple[int, int]]

_THERE = 1e-6
_MOST_HEEDED = 2


@dataclass(frozen=True)
class DriverSettings:
    """How a robot deals with others.

    Attributes:
        delay: between announcing a way and driving: all have heard it by then [s].
        pause: between two attempts to plan [s].
        detour: how much longer than alone a way may take at once; twice as much as it has waited is added [s].
        patience: after what time without a way the others clear a robot's way [s].
        turn: after what time without a way a robot lets the others go first [s].
        turn_apart: by how much later each robot of the team does so than the one before, by their ids, so that they do
            not all do so at once [s].
        gain: by how much sooner it must be there to change its way [s].
        tolerance: by how much two robots may come nearer than planned before a way is taken back [m].
    """

    delay: float = 1.0
    pause: float = 1.0
    detour: float = 20.0
    patience: float = 20.0
    turn: float = 60.0
    turn_apart: float = 20.0
    gain: float = 4.0
    tolerance: float = 0.015


class Driver:
    """Reserves the ways of one robot.

    Args:
        robot_id: of the robot.
        traffic: plans ways.
        speed: of the robot [m/s].
        settings: how it deals with others.

    Attributes:
        way: that is reserved; the robot follows it.
        goal: where it wants to be; None if it is there, or on its way there.
    """

    def __init__(
        self, robot_id: str, traffic: Traffic, speed: float, settings: Optional[DriverSettings] = None
    ) -> None:
        self._robot_id, self._traffic, self._speed = robot_id, traffic, speed
        self._told = DriverSettings() if settings is None else settings
        self.way: TimedWay = ()
        self.goal: Optional[Dock] = None
        self._tried = -math.inf
        self._heard: Sequence[Peer] = ()
        self._asked_since = -math.inf
        self._asked: Optional[_Place] = None
        self._refused: Optional[Tuple[object, ...]] = None

    def stand(self, now: float, here: _Place) -> TimedWay:
        """Stay where one is, until further notice."""
        if len(self.way) != 1 or math.dist(self.way[0][1:], here) > self._told.tolerance:
            self.way = (TimedPoint(now, *here),)
        self.goal = None
        return self.way

    def steer(self, now: float, here: _Place, dock: Dock, covered: _Covered, peers: Sequence[Peer]) -> TimedWay:
        """Make for a dock.

        Args:
            now: the time [s].
            here: where the robot is [m].
            dock: where it shall be.
            covered: columns and rows of the structure that blocks lie on.
            peers: its teammates.

        Returns:
            The way to follow; one of a single point: stand there.
        """
        if self._asked != dock.place:
            self._asked, self._asked_since = dock.place, now
            self._tried = -math.inf
        if not self.way:
            self.way = (TimedPoint(now, *here),)
        news = tuple(peers) != self._heard
        self._heard = tuple(peers)
        if news and self._must_yield(now):
            self.way = (TimedPoint(now, *here),)
        leads_there = math.dist(self.way[-1][1:], dock.place) <= _THERE
        if leads_there and not (dock.is_berth and now >= self.way[-1].time):
            self.goal = None
            if news and now - self._tried >= self._told.pause:
                self._improve(now, dock, covered)
            return self.way
        self._wait_for(dock)
        if now < self.way[-1].time or now - self._tried < self._told.pause:
            return self.way
        self._tried = now
        if now - self.way[-1].time >= self._turn():
            self.way = (TimedPoint(now, *here),)
        wanted = self._wanted(now, dock, covered)
        found, hinders = None, not self._is_off(here, wanted)
        if not leads_there and all(self._is_off(place, wanted) for place in (dock.place, dock.ahead)):
            found = self._plan(now, here, dock, covered)
        if found is None and hinders:
            start = TimedPoint(now + self._told.delay, *here)
            aside = find_refuge(self._traffic, start, covered, self._heard, wanted)
            found = None if aside is None else (TimedPoint(now, *here), *aside)
        if found is not None:
            self.way = found
        self._wait_for(dock)
        if hinders and found is None:
            # Who cannot get away asks those to make way who stand between, but for the one that goes first of all.
            fixed = [wanted[0][0], *standing_places([peer for peer in self._heard if peer.idle])]
            haven = find_haven(self._traffic, here, covered, fixed, wanted[:1])
            self.goal = self.goal if haven is None else Dock(*haven, *haven)
        return self.way

    def _wait_for(self, dock: Dock) -> None:
        # Nobody clears the way to a berth.
        there = math.dist(self.way[-1][1:], dock.place) <= _THERE
        self.goal = None if there or dock.is_berth else dock

    def is_there(self, now: float, dock: Dock) -> bool:
        """Tell whether the way to a dock has ended."""
        return bool(self.way) and math.dist(self.way[-1][1:], dock.place) <= _THERE and now >= self.way[-1].time

    def _turn(self) -> float:
        """Give for how long the robot insists on its turn: whom nobody can serve may hinder all the others [s]."""
        return self._told.turn + self._told.turn_apart * sum(peer.id < self._robot_id for peer in self._heard)

    def _must_yield(self, now: float) -> bool:
        """Tell whether the way meets that of somebody who was first, or who will not move out of it."""
        own = (self.way[0].time, self._robot_id)
        return now < self.way[-1].time and any(
            (peer.idle or (peer.announced, peer.id) < own)
            and conflicts(self.way, peer.way, now, self._traffic.clearance - self._told.tolerance)
            for peer in self._heard
        )

    def _plan(self, now: float, here: _Place, dock: Dock, covered: _Covered) -> Optional[TimedWay]:
        asked = (dock, frozenset(covered), self._heard)
        if asked == self._refused:
            return None
        begin = now + self._told.delay
        found = self._traffic.plan(here, dock.place, begin, covered, peer_ways(self._heard), beyond=dock.ahead)
        if found is None:
            # Where nobody moves any more and nothing has changed, there will be no way either.
            self._refused = asked if all(peer.way[-1].time <= now for peer in self._heard) else None
            return None
        alone = self._traffic.length(here, dock.place, covered) or 0.0
        waited = now - self._asked_since
        if found[-1].time - begin > alone / self._speed + self._told.detour + 2.0 * waited:
            return None
        return (TimedPoint(now, *here), *found)

    def _improve(self, now: float, dock: Dock, covered: _Covered) -> None:
        """Change the way where others left one that is quicker by far."""
        begin = now + self._told.delay
        if self.way[-1].time <= begin + self._told.gain:
            return
        self._tried = now
        start = place_at(self.way, begin)
        found = self._traffic.plan(start, dock.place, begin, covered, peer_ways(self._heard), beyond=dock.ahead)
        if found is not None and found[-1].time < self.way[-1].time - self._told.gain:
            until = [point for point in self.way if now < point.time < begin]
            self.way = (TimedPoint(now, *place_at(self.way, now)), *until, *found)

    def _wanted(self, now: float, dock: Dock, covered: _Covered) -> List[Tuple[_Place, ...]]:
        """Give the ways of those who have waited too long and go first."""
        own = (math.inf if dock.is_berth else self.way[0].time, self._robot_id)
        waiting = [
            peer
            for peer in self._heard
            if peer.goal
            and (peer.goal.is_berth or (peer.announced, peer.id) < own)
            and now - peer.announced >= self._told.patience
        ]
        waiting.sort(key=lambda peer: (peer.goal is not None and peer.goal.is_berth, peer.announced, peer.id))
        ways = (wanted_way(self._traffic, peer, covered, self._heard) for peer in waiting[:_MOST_HEEDED])
        return [way for way in ways if way]

    def _is_off(self, place: _Place, ways: Sequence[Tuple[_Place, ...]]) -> bool:
        return all(is_off(self._traffic, place, way) for way in ways)


def conflicts(one: TimedWay, other: TimedWay, now: float, clearance: float) -> bool:
    """Tell whether two robots on their ways come too near from now on.

    Args:
        one: a way.
        other: a way.
        now: what was before does not count [s].
        clearance: between their middles [m].
    """
    here = TimedPoint(now, *place_at(one, now))
    points = [here, *(point for point in one if point.time > now)]
    last = max(points[-1].time, other[-1].time) + 1.0
    points.append(TimedPoint(last, points[-1].x, points[-1].y))
    return not all(is_apart(*move, other, clearance) for move in zip(points, points[1:]))
