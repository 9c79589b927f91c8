"""Following a way in space and time, and going to a pose: velocities for a base that drives in any direction."""

from __future__ import annotations

import math
from bisect import bisect_right
from typing import NamedTuple, Sequence

from block_construction.team.timed_way import TimedPoint
from rqt_mrta_py.model import Pose, Twist, wrap_angle

__all__ = ["ARRIVED", "ASTRAY", "Limits", "Moment", "go_to", "lag", "moment_of", "towards"]

ARRIVED = 0.01
"""So near its end a way is over [m]."""
ASTRAY = 0.06
"""So far off its way a robot asks for another one [m]."""
_GAIN = 2.0
"""Of what is off now, so much a second is made good [1/s]."""


class Limits(NamedTuple):
    """How fast at most: speed [m/s], turn rate [rad/s]."""

    speed: float
    turn_rate: float


class Moment(NamedTuple):
    """Where to be at one moment [m], and how fast [m/s]."""

    x: float
    y: float
    vx: float
    vy: float


def moment_of(way: Sequence[TimedPoint], time: float) -> Moment:
    """Give where a way is at a time: at its first point before it begins, at its last when it is over.

    Args:
        way: at least one point, times growing.
        time: [s].
    """
    after = bisect_right([point.time for point in way], time)
    if after == 0 or after == len(way):
        _, x, y = way[0] if after == 0 else way[-1]
        return Moment(x, y, 0.0, 0.0)
    first, second = way[after - 1], way[after]
    duration = second.time - first.time
    vx, vy = (second.x - first.x) / duration, (second.y - first.y) / duration
    elapsed = time - first.time
    return Moment(first.x + vx * elapsed, first.y + vy * elapsed, vx, vy)


def lag(moment: Moment, pose: Pose) -> float:
    """Tell how far a robot is from where it should be [m]."""
    return math.hypot(moment.x - pose.x, moment.y - pose.y)


def towards(pose: Pose, moment: Moment, yaw: float, limits: Limits) -> Twist:
    """Give the velocities that follow a way, while turning.

    Args:
        pose: of the robot.
        moment: where it should be, and how fast.
        yaw: heading to turn to meanwhile [rad].
        limits: not to be exceeded.
    """
    vx = moment.vx + _GAIN * (moment.x - pose.x)
    vy = moment.vy + _GAIN * (moment.y - pose.y)
    speed = math.hypot(vx, vy)
    if speed > limits.speed:
        vx, vy = vx * limits.speed / speed, vy * limits.speed / speed
    turn = _GAIN * wrap_angle(yaw - pose.yaw)
    cos, sin = math.cos(pose.yaw), math.sin(pose.yaw)
    return Twist(cos * vx + sin * vy, cos * vy - sin * vx, max(-limits.turn_rate, min(limits.turn_rate, turn)))


def go_to(pose: Pose, goal: Pose, limits: Limits) -> Twist:
    """Give the velocities that lead straight to a pose, slowing down near it.

    Args:
        pose: of the robot.
        goal: where to.
        limits: not to be exceeded.
    """
    return towards(pose, Moment(goal.x, goal.y, 0.0, 0.0), goal.yaw, limits)
