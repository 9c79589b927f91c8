"""Where a robot was at which moment of a mission, in bounded memory: for whoever shows any moment of it again."""

from __future__ import annotations

import math
from array import array
from typing import NamedTuple, Optional, Tuple

__all__ = ["PoseLog", "RobotTrack"]

_Turn = Tuple[float, float, float, float]


class RobotTrack(NamedTuple):
    """Where a robot was.

    Attributes:
        robot: its id.
        radius: of the circle around it [m].
        period: between two poses that were both heard in time [s].
        times: of its poses, increasing, on the stream's clock [s].
        xs, ys: in the frame ``map`` [m].
        yaws: counter-clockwise from the x axis [rad].
        gone: from when on it was nowhere, for somebody had taken it away [s]; None if nobody did.
    """

    robot: str
    radius: float
    period: float
    times: Tuple[float, ...]
    xs: Tuple[float, ...]
    ys: Tuple[float, ...]
    yaws: Tuple[float, ...]
    gone: Optional[float] = None


class PoseLog:
    """Keeps a pose of one robot now and then; when they become too many, every other one goes.

    Whoever hears poses looks at ``due`` and hands over what comes from then on, so that what comes between costs one
    comparison.

    Attributes:
        due: when the next pose is wanted [s].

    Args:
        period: between two poses, at first [s].
        most: poses, at least 4.
    """

    __slots__ = ("_most", "_period", "_times", "_xs", "_yaws", "_ys", "due")

    def __init__(self, period: float, most: int) -> None:
        self._period = period
        self._most = most
        self._times, self._xs, self._ys, self._yaws = array("d"), array("d"), array("d"), array("d")
        self.due = -math.inf

    def add(self, time: float, x: float, y: float, turn: _Turn) -> None:
        """Take in a pose that is due.

        Args:
            time: of its receipt, on the stream's clock [s].
            x: in the frame ``map`` [m].
            y: in the frame ``map`` [m].
            turn: quaternion x, y, z, w.
        """
        qx, qy, qz, qw = turn
        self._times.append(time)
        self._xs.append(x)
        self._ys.append(y)
        self._yaws.append(math.atan2(2.0 * (qw * qz + qx * qy), 1.0 - 2.0 * (qy * qy + qz * qz)))
        if len(self._times) > self._most:
            for column in (self._times, self._xs, self._ys, self._yaws):
                del column[1::2]
            self._period *= 2.0
        self.due = self._times[-1] + self._period

    def track(self, robot: str, radius: float) -> RobotTrack:
        """Give what was kept.

        Args:
            robot: its id.
            radius: of the circle around it [m].
        """
        return RobotTrack(
            robot, radius, self._period, tuple(self._times), tuple(self._xs), tuple(self._ys), tuple(self._yaws)
        )
