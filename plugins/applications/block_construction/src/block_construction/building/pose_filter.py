"""Where a robot is: pose fixes fused with what its wheels count, or with what it was commanded."""

from __future__ import annotations

import math
from typing import Optional

from rqt_mrta_py.model import Pose, Twist, wrap_angle

__all__ = ["PER_ROOT_METRE", "PoseFilter", "Scalar", "composed", "corrected_gain", "moved", "relative"]

PER_ROOT_METRE = 0.003
"""How far off dead reckoning is after a metre [m]; errors are taken as if they added up like chance."""
_TURN_PER_ROOT_METRE = 0.03
"""How far off its heading is then [rad]."""
_TURN_PER_ROOT_RADIAN = 0.03
"""How far off its heading is after a turn of one radian [rad]."""
_UNKNOWN_PLACE = 0.05
_UNKNOWN_HEADING = 0.05
"""Standard deviations after a time in which nobody listened [m, rad]."""
_FIRST_NOISE = 0.01
"""Of fixes, before any have been compared [m, rad]."""
_LEAST_NOISE = 2e-5
_LONGEST_MEMORY = 300
"""Noise of fixes is learnt from about so many of them."""
_SURPRISE = 4.0
"""What is so many standard deviations off is no noise: something has pushed the robot."""


def corrected_gain(variance: float, noise: float) -> float:
    """Give how much of the difference to a measurement is believed: P / (P + R).

    Args:
        variance: of what is believed, P.
        noise: variance of the measurement, R.
    """
    return variance / (variance + noise)


def moved(twist: Twist, duration: float) -> Pose:
    """Give where a constant velocity leads, seen from the beginning, for turns of a few degrees.

    Args:
        twist: velocity in the robot's own frame.
        duration: of the motion [s].
    """
    middle = twist.wz * duration / 2.0
    cos, sin = math.cos(middle), math.sin(middle)
    return Pose(
        (cos * twist.vx - sin * twist.vy) * duration, (sin * twist.vx + cos * twist.vy) * duration, twist.wz * duration
    )


def composed(frame: Pose, pose: Pose) -> Pose:
    """Give a pose that is seen from another one: the reverse of ``relative``."""
    cos, sin = math.cos(frame.yaw), math.sin(frame.yaw)
    return Pose(
        frame.x + cos * pose.x - sin * pose.y, frame.y + sin * pose.x + cos * pose.y, wrap_angle(frame.yaw + pose.yaw)
    )


def relative(frame: Pose, pose: Pose) -> Pose:
    """Give a pose as seen from another one."""
    dx, dy, cos, sin = pose.x - frame.x, pose.y - frame.y, math.cos(frame.yaw), math.sin(frame.yaw)
    return Pose(cos * dx + sin * dy, cos * dy - sin * dx, wrap_angle(pose.yaw - frame.yaw))


class Scalar:
    """One number that is estimated, with the noise of its measurements learnt from how they scatter.

    Attributes:
        variance: of the estimate.
        noise: standard deviation of measurements.
    """

    __slots__ = ("_compared", "noise", "variance")

    def __init__(self) -> None:
        self.variance = math.inf
        self.noise = _FIRST_NOISE
        self._compared = 1

    def correct(self, difference: float) -> float:
        """Take in a measurement.

        Args:
            difference: of the measurement from what was believed.

        Returns:
            What to add to the estimate.
        """
        if math.isinf(self.variance):
            self.variance = self.noise**2
            return difference
        noise = self.noise**2
        if difference**2 > _SURPRISE**2 * (self.variance + noise):
            self.variance = difference**2
        else:
            self._compared = min(self._compared + 1, _LONGEST_MEMORY)
            # Of a difference, the share that is not doubt about the estimate itself.
            sample = difference**2 * noise / (self.variance + noise)
            noise = max(_LEAST_NOISE**2, noise + (sample - noise) / self._compared)
            self.noise = math.sqrt(noise)
        gain = corrected_gain(self.variance, noise)
        self.variance *= 1.0 - gain
        return gain * difference


class PoseFilter:
    """Fuses the poses that a localiser tells with dead reckoning; a robot that stands averages.

    Attributes:
        pose: that is believed; None before the first fix.
    """

    def __init__(self) -> None:
        self.pose: Optional[Pose] = None
        self._axes = (Scalar(), Scalar(), Scalar())
        self._fix: Optional[Pose] = None
        self._counted: Optional[Pose] = None
        self._time: Optional[float] = None

    @property
    def doubt(self) -> float:
        """Standard deviation of the position, the worse of both axes [m]."""
        return math.sqrt(max(self._axes[0].variance, self._axes[1].variance))

    @property
    def turn_doubt(self) -> float:
        """Standard deviation of the heading [rad]."""
        return math.sqrt(self._axes[2].variance)

    def resume(self, now: float) -> None:
        """Begin, or go on after a time in which nothing was taken in."""
        self._time, self._counted = now, None
        for axis, doubt in zip(self._axes, (_UNKNOWN_PLACE, _UNKNOWN_PLACE, _UNKNOWN_HEADING)):
            if math.isfinite(axis.variance):
                axis.variance = max(axis.variance, doubt**2)

    def step(self, now: float, fix: Optional[Pose], counted: Optional[Pose], twist: Twist) -> Optional[Pose]:
        """Take in what was heard since the last step.

        Args:
            now: the time [s].
            fix: newest that the localiser told; the same object as before, if it told none since.
            counted: newest pose that the wheels count, in a frame of their own; None if they do not.
            twist: that the robot was commanded since the last step; of use where wheels do not count.

        Returns:
            Where the robot is; None before the first fix.
        """
        elapsed = 0.0 if self._time is None else now - self._time
        self._time = now
        if self.pose is not None:
            self._reckon(elapsed, counted, twist)
        self._counted = counted
        if fix is not None and fix is not self._fix:
            self._fix = fix
            self._correct(fix)
        return self.pose

    def _reckon(self, elapsed: float, counted: Optional[Pose], twist: Twist) -> None:
        pose = self.pose
        if pose is None:
            return
        if counted is None:
            step = moved(twist, elapsed)
        elif self._counted is None or counted is self._counted:
            return
        else:
            step = relative(self._counted, counted)
        if step.x == step.y == step.yaw == 0.0:
            return
        self.pose = composed(pose, step)
        length = math.hypot(step.x, step.y)
        x, y, yaw = self._axes
        x.variance += PER_ROOT_METRE**2 * length
        y.variance += PER_ROOT_METRE**2 * length
        yaw.variance += _TURN_PER_ROOT_METRE**2 * length + _TURN_PER_ROOT_RADIAN**2 * abs(step.yaw)

    def _correct(self, fix: Pose) -> None:
        pose = self.pose or fix
        x, y, yaw = self._axes
        self.pose = Pose(
            pose.x + x.correct(fix.x - pose.x),
            pose.y + y.correct(fix.y - pose.y),
            wrap_angle(pose.yaw + yaw.correct(wrap_angle(fix.yaw - pose.yaw))),
        )
