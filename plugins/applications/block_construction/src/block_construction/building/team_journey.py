"""The way of a builder that is not alone: as its driver reserves it."""

from __future__ import annotations

import math
from typing import FrozenSet, List, Optional, Sequence, Tuple

from block_construction.building.follower import ARRIVED, ASTRAY, Limits, lag, moment_of, towards
from block_construction.building.procedures import STAND_OFF, TRAVEL_SPEED, TURN_RATE
from block_construction.building.routes import stand_off
from block_construction.building.slot import BlockTask, Cell, Fetch
from block_construction.team.board import TeamBoard
from block_construction.team.choice import Trip, best_trip
from block_construction.team.peers import Dock, Peer
from block_construction.team.refuge import wanted_way
from block_construction.team.timed_way import TimedPoint, TimedWay
from block_construction.team.traffic import Traffic
from rqt_mrta_py.hooks import Perception
from rqt_mrta_py.model import Pose, Twist

__all__ = ["TeamJourney", "comes_nearer", "dock_before", "team_trip"]

_LIMITS = Limits(TRAVEL_SPEED, TURN_RATE)
_GIVES_UP = 90.0
"""Who has waited for so long looks whether there will be a way at all [s]."""
_TOO_NEAR = 0.03
"""By so much less than ways keep clear of others a robot comes near to nobody, whatever its way says [m]."""
_CREEP = 0.001
"""Who comes nearer no faster than this drives past [m/s]."""
_REACH = 0.40
"""From the middle of a block to that of the robot that holds or places it, at the least [m]."""


def dock_before(block: Pose) -> Dock:
    """Give the dock before a block that a robot faces [m, rad]."""
    stand, step = stand_off(block), STAND_OFF - _REACH
    ahead = (stand.x + step * math.cos(block.yaw), stand.y + step * math.sin(block.yaw))
    return Dock(stand.x, stand.y, *ahead)


def team_trip(
    board: TeamBoard, traffic: Traffic, slot: BlockTask, where: Tuple[Perception, Pose], covered: FrozenSet[Cell]
) -> Tuple[Optional[Trip], Tuple[Fetch, ...]]:
    """Choose where a block is fetched, with teammates where they are.

    Args:
        board: knows the teammates.
        traffic: knows ways.
        slot: of the block.
        where: what the robot perceives, and where it is.
        covered: what blocks lie on.

    Returns:
        The trip, if there is any, and the supply places that it counts.
    """
    perception, pose = where
    docks = [dock_before(fetch.facing) for fetch in slot.supply]
    peers = board.peers(perception)
    return best_trip(traffic, (pose.x, pose.y), (docks, dock_before(slot.facing)), covered, peers), slot.supply


def comes_nearer(pose: Pose, twist: Twist, others: Sequence[Tuple[float, float]], near: float) -> bool:
    """Tell whether a robot drives towards somebody who is near it already.

    Args:
        pose: of the robot.
        twist: its velocities, in its own frame.
        others: where they are [m].
        near: between the middles of both [m].
    """
    cos, sin = math.cos(pose.yaw), math.sin(pose.yaw)
    vx, vy = cos * twist.vx - sin * twist.vy, sin * twist.vx + cos * twist.vy
    for x, y in others:
        dx, dy = x - pose.x, y - pose.y
        distance = math.hypot(dx, dy)
        if distance < near and vx * dx + vy * dy > _CREEP * distance:
            return True
    return False


class TeamJourney:
    """Drives to one dock as its driver says, turning meanwhile.

    Attributes:
        way: that is reserved.
        is_waiting: whether the robot waits for a way.

    Args:
        traffic: knows ways.
        board: knows the teammates.
        dock: where to.
        yaw: heading to be turned to; None: stay as one is [rad].
    """

    def __init__(self, traffic: Traffic, board: TeamBoard, dock: Dock, yaw: Optional[float] = None) -> None:
        driver = board.driver(traffic)
        self._driver, self._traffic, self._board, self._dock, self._yaw = driver, traffic, board, dock, yaw
        self.way: TimedWay = driver.way
        self.is_waiting = False
        self._waits_since = math.inf

    def step(self, perception: Perception, pose: Pose, covered: FrozenSet[Cell]) -> Optional[Twist]:
        """Carry out one control tick.

        Args:
            perception: of the robot.
            pose: where it is.
            covered: what blocks lie on.

        Returns:
            The velocities; None once it is there, be it not turned yet.
        """
        now, driver, dock = perception.now, self._driver, self._dock
        if not driver.way or lag(moment_of(driver.way, now), pose) > ASTRAY:
            driver.stand(now, (pose.x, pose.y))
        self.way = driver.steer(now, (pose.x, pose.y), dock, covered, self._board.peers(perception))
        there = driver.is_there(now, dock)
        self.is_waiting = not there and now >= self.way[-1].time
        self._waits_since = min(self._waits_since, now) if self.is_waiting else math.inf
        if there and math.hypot(dock.x - pose.x, dock.y - pose.y) <= ARRIVED:
            return None
        yaw = pose.yaw if self._yaw is None else self._yaw
        twist = towards(pose, moment_of(self.way, now), yaw, _LIMITS)
        near = self._traffic.clearance - _TOO_NEAR
        if comes_nearer(pose, twist, self._board.places(perception), near):
            return Twist(wz=twist.wz)
        return twist

    def is_shut_in(self, perception: Perception, pose: Pose, covered: FrozenSet[Cell]) -> bool:
        """Tell whether the robot has waited long, and teammates that have nothing to do leave it no way."""
        now = perception.now
        if now - self._waits_since < _GIVES_UP:
            return False
        self._waits_since = now
        me = Peer("", (TimedPoint(now, pose.x, pose.y),), goal=self._dock)
        return not wanted_way(self._traffic, me, covered, self._board.peers(perception))

    @property
    def goal(self) -> Tuple[float, ...]:
        """Where it waits to go to, as it is told to teammates; empty if it does not wait."""
        goal: List[float] = [] if self._driver.goal is None else list(self._driver.goal)
        return tuple(goal)
