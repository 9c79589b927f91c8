"""Places and motions in the plane (REP-103: metres, radians, x forward, y left)."""

from __future__ import annotations

import math
from dataclasses import dataclass

__all__ = ["Pose", "Twist", "wrap_angle"]


@dataclass(frozen=True)
class Pose:
    """A position and heading in the frame ``map`` unless said otherwise.

    Attributes:
        x: [m].
        y: [m].
        yaw: heading, counter-clockwise from the x axis [rad].
    """

    x: float
    y: float
    yaw: float = 0.0

    def distance(self, other: Pose) -> float:
        """Return the Euclidean distance to another position [m]."""
        return math.hypot(other.x - self.x, other.y - self.y)

    def bearing(self, other: Pose) -> float:
        """Return the direction of another position as seen from here, relative to the heading, in (-pi, pi] [rad]."""
        return wrap_angle(math.atan2(other.y - self.y, other.x - self.x) - self.yaw)


@dataclass(frozen=True)
class Twist:
    """A planar velocity in the robot's own frame.

    Attributes:
        vx: forward [m/s].
        vy: to the left [m/s].
        wz: counter-clockwise turn rate [rad/s].
    """

    vx: float = 0.0
    vy: float = 0.0
    wz: float = 0.0


def wrap_angle(angle: float) -> float:
    """Bring an angle into (-pi, pi].

    Args:
        angle: any finite angle [rad].

    Returns:
        The same direction in (-pi, pi] [rad].
    """
    wrapped = math.remainder(angle, 2.0 * math.pi)
    return math.pi if wrapped == -math.pi else wrapped
