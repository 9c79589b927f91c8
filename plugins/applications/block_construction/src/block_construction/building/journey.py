"""The way of a builder from one place to the next."""

from __future__ import annotations

import math
from typing import FrozenSet, Optional

from block_construction.building.follower import Limits, go_to, lag, moment_of, towards
from block_construction.building.procedures import TRAVEL_SPEED, TURN_RATE
from block_construction.building.seams import Board, Traffic
from block_construction.building.slot import Cell
from block_construction.team.timed_way import TimedPoint, TimedWay
from rqt_mrta_py.hooks import Perception
from rqt_mrta_py.model import Pose, Twist

__all__ = ["Journey"]

_LIMITS = Limits(TRAVEL_SPEED, TURN_RATE)
_ARRIVED = 0.01
"""So near its end a way is over [m]."""
_ASTRAY = 0.06
"""So far off its way a robot asks for another one [m]."""
_PATIENCE = 1.0
"""Where there is no way, it asks again after so long [s]."""


class Journey:
    """Drives to one place, turning meanwhile; asks for a way, follows it, asks again when it has gone astray.

    Args:
        traffic: knows ways.
        board: knows what others have reserved.
        goal: where to.
    """

    def __init__(self, traffic: Traffic, board: Board, goal: Pose) -> None:
        self._traffic = traffic
        self._board = board
        self.goal = goal
        self._way: Optional[TimedWay] = None
        self._asked = -math.inf
        self.waits_since: Optional[float] = None

    @property
    def way(self) -> TimedWay:
        """That is reserved; empty if none was found yet."""
        return self._way or ()

    def step(self, perception: Perception, pose: Pose, covered: FrozenSet[Cell]) -> Optional[Twist]:
        """Carry out one control tick.

        Args:
            perception: of the robot.
            pose: where it is.
            covered: what blocks lie on.

        Returns:
            The velocities; None once it is there, be it not turned yet.
        """
        now, goal = perception.now, self.goal
        if math.hypot(goal.x - pose.x, goal.y - pose.y) <= _ARRIVED:
            return None
        way = self._way
        if way is None or lag(moment_of(way, now), pose) > _ASTRAY:
            way = self._ask(perception, pose, covered)
        if way is None:
            return Twist()
        return towards(pose, moment_of(way, now), goal.yaw, _LIMITS)

    def hold(self, now: float, pose: Pose) -> Twist:
        """Stay where the robot is, and turn towards the goal meanwhile."""
        if self._way is None or len(self._way) > 1:
            self._way = (TimedPoint(now, pose.x, pose.y),)
        _, x, y = self._way[0]
        return go_to(pose, Pose(x, y, self.goal.yaw), _LIMITS)

    def _ask(self, perception: Perception, pose: Pose, covered: FrozenSet[Cell]) -> Optional[TimedWay]:
        now = perception.now
        if now - self._asked < _PATIENCE:
            return self._way if self._way is not None and self.waits_since is None else None
        self._asked = now
        others = self._board.others(perception)
        found = self._traffic.plan((pose.x, pose.y), (self.goal.x, self.goal.y), now, covered, others)
        if found is None:
            self._way = (TimedPoint(now, pose.x, pose.y),)
            self.waits_since = now if self.waits_since is None else self.waits_since
            return None
        self._way, self.waits_since = found, None
        return found
