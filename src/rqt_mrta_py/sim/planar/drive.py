"""From commands to motion: limits of the model, the lag of motors, arcs of circles."""

from __future__ import annotations

import math
from array import array
from typing import Sequence

import numpy as np
from numpy.typing import NDArray

from rqt_mrta_py.hooks import RobotModel
from rqt_mrta_py.model import Twist
from rqt_mrta_py.sim.planar.cells import Floats

__all__ = ["DRIVES", "LAG", "Drive"]

DRIVES = ("differential", "omni")
"""Drives that can be built; of a command's three speeds, ``omni`` obeys the one to the left too."""

LAG = 0.05
"""Time constant of all speeds: after it, 63 % of a change are made [s]."""


class Drive:
    """The bases of all robots.

    Each speed v follows its command u as dv/dt = (u - v) / LAG, solved exactly, whatever the length of a step; within
    a step a robot moves on an arc of a circle.

    Args:
        models: of the robots, in their order.
    """

    def __init__(self, models: Sequence[RobotModel]) -> None:
        count = len(models)
        self._count = count
        # Numbers that come one by one: writing them into a NumPy array would take three times as long.
        self._commands = array("d", bytes(3 * 8 * count))
        self._speeds: Floats = np.zeros((3, count))
        self._max_speed: Floats = np.array([model.max_speed for model in models], dtype=np.float64)
        self._max_turn_rate: Floats = np.array([model.max_turn_rate for model in models], dtype=np.float64)
        self._sideways: Floats = np.array([model.drive == "omni" for model in models], dtype=np.float64)

    def command(self, row: int, twist: Twist) -> None:
        """Set the velocity that one robot shall have, finite, in its own frame."""
        commands, count = self._commands, self._count
        commands[row] = twist.vx
        commands[row + count] = twist.vy
        commands[row + 2 * count] = twist.wz

    def advance(self, poses: Floats, is_frozen: NDArray[np.bool_], duration: float) -> None:
        """Move every robot on.

        Args:
            poses: x, y [m] and yaw [rad], changed in place; shape (3, robots).
            is_frozen: who stands still at once and stays so, shape (robots,).
            duration: [s].
        """
        wanted = self._within_limits()
        if is_frozen.any():
            self._speeds[:, is_frozen] = wanted[:, is_frozen] = 0.0
        missing = self._speeds - wanted
        decay = math.exp(-duration / LAG)
        along, left, turn = wanted * duration + missing * (LAG * (1.0 - decay))
        self._speeds = wanted + missing * decay
        # The chord of an arc, shorter than it by sin(a)/a, lies in the direction of the arc's middle.
        heading = poses[2] + turn / 2
        chord = np.sinc(turn / (2 * np.pi))
        cos, sin = chord * np.cos(heading), chord * np.sin(heading)
        poses[0] += cos * along - sin * left
        poses[1] += sin * along + cos * left
        yaw = poses[2] + turn
        poses[2] = yaw - 2 * np.pi * np.ceil((yaw - np.pi) / (2 * np.pi))

    def hold_up(self, is_pushed: NDArray[np.bool_], moved: Floats, yaw: Floats, duration: float) -> None:
        """Slow robots that were pushed down to the speed at which they got on, at most to a stand.

        Args:
            is_pushed: who was, shape (robots,).
            moved: from where to where they all came, frame ``map`` [m], shape (2, robots).
            yaw: headings [rad], shape (robots,).
            duration: in which they did [s].
        """
        rows = np.flatnonzero(is_pushed)
        if not rows.size:
            return
        (x, y), cos, sin = moved[:, rows], np.cos(yaw[rows]), np.sin(yaw[rows])
        speeds = self._speeds[:2, rows]
        made = np.stack((cos * x + sin * y, cos * y - sin * x)) / duration
        self._speeds[:2, rows] = np.clip(made, np.minimum(speeds, 0.0), np.maximum(speeds, 0.0))

    def _within_limits(self) -> Floats:
        """Bring the commands within the models' limits, keeping the direction of travel."""
        vx, vy, wz = np.frombuffer(self._commands, dtype=np.float64).reshape(3, self._count)
        vy = vy * self._sideways
        half_speed = np.hypot(vx / 2, vy / 2)  # half, for the whole may be beyond all numbers
        most = self._max_speed / 2
        scale = most / np.maximum(half_speed, most)
        wz = np.minimum(np.maximum(wz, -self._max_turn_rate), self._max_turn_rate)
        return np.array((vx * scale, vy * scale, wz))
