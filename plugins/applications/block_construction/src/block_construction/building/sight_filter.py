"""Where blocks are before the robot: looks averaged, as far as eyes err."""

from __future__ import annotations

import math
from typing import Dict, Mapping, NamedTuple, Optional

from block_construction.building.pose_filter import PER_ROOT_METRE, corrected_gain, relative
from rqt_mrta_py.model import Pose

__all__ = ["Place", "SightFilter"]

_LONGEST_MEMORY = 200
"""How much eyes err is learnt from about so many pairs of looks."""
_STANDS = 0.002
"""Between looks that are compared the robot moves less than that [m, rad]."""
_SURPRISE = 4.0
"""What is so many standard deviations off is no error of eyes: the block was moved."""
_MOVED = 0.002
"""Whatever eyes err, a block that is seen no farther off is the same that lies still [m]."""
_FALLEN = 0.005
"""A block that is seen so much higher or lower was moved [m]."""
_FARTHEST = 0.02
"""Looks that are farther apart say nothing about how much eyes err [m]."""


class Place(NamedTuple):
    """Where a block is, as seen from the robot.

    Attributes:
        x, y, z: its middle, ahead, to the left and up [m].
        variance: of x and of y [m2].
    """

    x: float
    y: float
    z: float
    variance: float = math.inf


class SightFilter:
    """Averages what eyes tell of blocks that lie still, while the robot stands or creeps.

    How much eyes err is learnt from how looks of a robot that stands scatter: of exact eyes the newest look counts.
    From one look to the next the robot goes by its wheels and by its heading, not by where it believes to be.
    """

    def __init__(self) -> None:
        self._noise = 0.0
        self._pairs = 0
        self._newest: Mapping[str, Place] = {}
        self._places: Mapping[str, Place] = {}
        self._robot: Optional[Pose] = None
        self._counted: Optional[Pose] = None

    @property
    def noise(self) -> float:
        """Standard deviation of one look, in x and in y [m]."""
        return math.sqrt(self._noise)

    def take(self, looks: Mapping[str, Place], robot: Pose, counted: Optional[Pose]) -> Mapping[str, Place]:
        """Take in what is seen.

        Args:
            looks: where blocks are, by id.
            robot: where the robot believes to be.
            counted: newest pose that the wheels count, in a frame of their own; None if they do not.

        Returns:
            Where they are by all looks, by id.
        """
        step = self._step(robot, counted)
        self._robot, self._counted = robot, counted
        places: Dict[str, Place] = {}
        for name, look in looks.items():
            newest, known = self._newest.get(name), self._places.get(name)
            if newest is None or known is None:
                places[name] = look
                continue
            if math.hypot(step.x, step.y) < _STANDS and abs(step.yaw) < _STANDS:
                self._compare(look, _seen_from(step, newest))
            places[name] = self._corrected(_seen_from(step, known), look)
        self._newest, self._places = looks, places
        return places

    def _step(self, robot: Pose, counted: Optional[Pose]) -> Pose:
        """Give where the robot is now, as seen from where it was at the last look."""
        if self._robot is None:
            return Pose(0.0, 0.0)
        believed = relative(self._robot, robot)
        if counted is None or self._counted is None:
            return believed
        wheels = relative(self._counted, counted)
        return Pose(wheels.x, wheels.y, believed.yaw)

    def _compare(self, look: Place, before: Place) -> None:
        """Learn from two looks, whose difference scatters with twice the variance of one."""
        dx, dy = look.x - before.x, look.y - before.y
        if math.hypot(dx, dy) > _FARTHEST or abs(look.z - before.z) > _FALLEN:
            return
        self._pairs = min(self._pairs + 1, _LONGEST_MEMORY)
        self._noise += ((dx * dx + dy * dy) / 4.0 - self._noise) / self._pairs

    def _corrected(self, known: Place, look: Place) -> Place:
        variance = known.variance if math.isfinite(known.variance) else self._noise
        off = math.hypot(look.x - known.x, look.y - known.y)
        is_moved = off > _MOVED + _SURPRISE * math.sqrt(variance + self._noise) or abs(look.z - known.z) > _FALLEN
        if is_moved or self._noise == 0.0:
            return look
        gain = corrected_gain(variance, self._noise)
        x, y = known.x + gain * (look.x - known.x), known.y + gain * (look.y - known.y)
        return Place(x, y, look.z, (1.0 - gain) * variance)


def _seen_from(step: Pose, place: Place) -> Place:
    """Give where a block is that lies still, after a step of the robot."""
    there = relative(step, Pose(place.x, place.y))
    length = math.hypot(step.x, step.y)
    return Place(there.x, there.y, place.z, place.variance + PER_ROOT_METRE**2 * length)
