"""The way of a builder from one place to the next."""

from __future__ import annotations

import math
from typing import FrozenSet, Optional

from block_construction.building.follower import ARRIVED, ASTRAY, Limits, go_to, lag, moment_of, towards
from block_construction.building.procedures import TRAVEL_SPEED, TURN_RATE
from block_construction.building.seams import Traffic
from block_construction.building.slot import Cell
from block_construction.team.timed_way import TimedPoint, TimedWay
from rqt_mrta_py.hooks import Perception
from rqt_mrta_py.model import Pose, Twist

__all__ = ["Journey"]

_LIMITS = Limits(TRAVEL_SPEED, TURN_RATE)
_PATIENCE = 1.0
"""Where there is no way, it asks again after so long [s]."""


class Journey:
    """Drives to one place, turning meanwhile; asks for a way, follows it, asks again when it has gone astray.

    Attributes:
        way: that is reserved; empty before the first step.
        is_waiting: whether the robot stays where it is, for there is no way at present.

    Args:
        traffic: knows ways.
        goal: where to.
    """

    def __init__(self, traffic: Traffic, goal: Pose) -> None:
        self._traffic = traffic
        self._goal = goal
        self._asked = -math.inf
        self.way: TimedWay = ()
        self.is_waiting = False

    def step(self, perception: Perception, pose: Pose, covered: FrozenSet[Cell]) -> Optional[Twist]:
        """Carry out one control tick.

        Args:
            perception: of the robot.
            pose: where it is.
            covered: what blocks lie on.

        Returns:
            The velocities; None once it is there, be it not turned yet.
        """
        now, goal = perception.now, self._goal
        if math.hypot(goal.x - pose.x, goal.y - pose.y) <= ARRIVED:
            return None
        is_astray = not self.way or self.is_waiting or lag(moment_of(self.way, now), pose) > ASTRAY
        if is_astray and now - self._asked >= _PATIENCE:
            self._asked = now
            found = self._traffic.plan((pose.x, pose.y), (goal.x, goal.y), now, covered, ())
            if found is None:
                return self._hold(now, pose)
            self.way, self.is_waiting = found, False
        return towards(pose, moment_of(self.way, now), goal.yaw, _LIMITS)

    def _hold(self, now: float, pose: Pose) -> Twist:
        """Stay where the robot is, and turn towards the goal meanwhile."""
        if not self.is_waiting or not self.way:
            self.way, self.is_waiting = (TimedPoint(now, pose.x, pose.y),), True
        _, x, y = self.way[0]
        return go_to(pose, Pose(x, y, self._goal.yaw), _LIMITS)
