"""A robot that was taken off the floor: nobody meets or sees it, and nothing moves it."""

from __future__ import annotations

import math
from typing import Tuple

from rqt_mrta_py.model import Twist
from rqt_mrta_py.sim.bullet.robot import BulletRobot, Frame

__all__ = ["RemovedRobot"]

_DEEP = -1e6
"""How high up it is shown to range finders [m]."""


class RemovedRobot:
    """What is left of a robot in one physics client: its place among the others.

    Attributes:
        body: a number that PyBullet gives to none.
        parts, hand, lifts, grip_force: of what touches and holds nothing.
        shape: as it was.

    Args:
        robot: as it was, before PyBullet removed its body.
    """

    body = -1
    parts: Tuple[int, ...] = ()
    hand = -1
    lifts = False
    grip_force = math.inf

    def __init__(self, robot: BulletRobot) -> None:
        self.shape = robot.shape
        (x, y, _), orientation = robot.frame()
        self._frame: Frame = ((x, y, _DEEP), orientation)

    def command(self, twist: Twist) -> None:
        """Do nothing."""

    def freeze(self) -> None:
        """Do nothing."""

    def release(self) -> None:
        """Do nothing."""

    def frame(self) -> Frame:
        """Give where it was, deep below the floor."""
        return self._frame

    def hand_frame(self) -> Frame:
        """Give the same: it has no hand."""
        return self._frame
