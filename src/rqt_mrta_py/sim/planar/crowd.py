"""Everything that moves: robots, then loose bodies; where it is, how willingly it moves, who carries it."""

from __future__ import annotations

from typing import List, Sequence

import numpy as np
from numpy.typing import NDArray

from rqt_mrta_py.hooks import Body, PlacedRobot
from rqt_mrta_py.sim.planar.cells import Floats, Rows
from rqt_mrta_py.sim.planar.footprints import (
    Footprints,
    Placed,
    body_footprint,
    columns_of_poses,
    robot_footprints,
)

__all__ = ["Crowd"]

_DEEP = -1e6
"""How high up what has been taken away is [m]."""


class Crowd:
    """Robots in the setup's order, then loose bodies in the order of their adding, one a column of every array.

    Attributes:
        names: ids.
        robots: how many of them, from the first, are robots.
        poses: x, y [m] and yaw [rad] in the frame ``map``, shape (3, things).
        footprints: their shapes.
        carrier: for a carried body the row of its robot, for all else the thing's own row, shape (things,).
        is_frozen: shape (robots,).
        lineup: changes whenever anything but a pose does.
    """

    def __init__(self, robots: Sequence[PlacedRobot]) -> None:
        self.names: List[str] = [robot.id for robot in robots]
        self.robots = len(robots)
        self.footprints: Footprints = robot_footprints([robot.model for robot in robots])
        self.poses: Floats = columns_of_poses([robot.start for robot in robots])
        self.is_frozen: NDArray[np.bool_] = np.zeros(self.robots, dtype=np.bool_)
        self.carrier: Rows = np.arange(self.robots)
        self.lineup = 0
        self._masses: Floats = np.array([robot.model.mass for robot in robots], dtype=np.float64)
        self._holds: Floats = np.zeros((3, self.robots))
        self._carried: Rows = np.empty(0, dtype=np.intp)

    def add(self, body: Body) -> None:
        """Put a loose body behind all others."""
        x, y, _ = body.position
        self.names.append(body.id)
        self.footprints = self.footprints.joined(body_footprint(body))
        self.poses = np.concatenate((self.poses, [[x], [y], [body.yaw]]), axis=1)
        self.carrier = np.append(self.carrier, self.carrier.size)
        self._masses = np.append(self._masses, body.mass)
        self._holds = np.concatenate((self._holds, np.zeros((3, 1))), axis=1)
        self.lineup += 1

    def remove(self, row: int) -> None:
        """Take a loose body away; rows behind it move up."""
        self.release(row)
        del self.names[row]
        self.footprints = self.footprints.without(row)
        self.poses = np.delete(self.poses, row, axis=1)
        carrier = np.delete(self.carrier, row)
        self.carrier = carrier - (carrier > row)
        self._masses = np.delete(self._masses, row)
        self._holds = np.delete(self._holds, row, axis=1)
        self._note_carried()

    def sink(self, robot: int) -> None:
        """Take a robot away for good, its row staying: it is so far below the floor that it meets and shows nothing."""
        self.is_frozen[robot] = True
        self.footprints.low[robot] = self.footprints.high[robot] = _DEEP
        self.lineup += 1

    def hold(self, robot: int, row: int) -> None:
        """Let a robot carry a body from now on, in their present relative pose."""
        dx, dy, turned = self.poses[:, row] - self.poses[:, robot]
        cos, sin = np.cos(self.poses[2, robot]), np.sin(self.poses[2, robot])
        self._holds[:, row] = (cos * dx + sin * dy, cos * dy - sin * dx, turned)
        self.carrier[row] = robot
        self._note_carried()

    def release(self, row: int) -> None:
        """Let a body stand for itself again."""
        self.carrier[row] = row
        self._note_carried()

    def carry(self) -> None:
        """Bring carried bodies to where their robots are."""
        if not self._carried.size:
            return
        x, y, yaw = self.poses[:, self.carrier[self._carried]]
        ahead, left, turned = self._holds[:, self._carried]
        cos, sin = np.cos(yaw), np.sin(yaw)
        self.poses[:, self._carried] = (x + cos * ahead - sin * left, y + sin * ahead + cos * left, yaw + turned)

    def placed(self) -> Placed:
        """Give all footprints where they are now."""
        return Placed(self.footprints, self.poses)

    def mobility(self) -> Floats:
        """Give the share that each takes when two push each other apart: 1/mass, 0 while frozen [1/kg]."""
        mobility = 1.0 / self._masses
        mobility[: self.robots][self.is_frozen] = 0.0
        return mobility

    def _note_carried(self) -> None:
        self._carried = np.flatnonzero(self.carrier != np.arange(self.carrier.size))
        self.lineup += 1
