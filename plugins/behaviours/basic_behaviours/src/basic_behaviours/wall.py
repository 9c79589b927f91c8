"""The wall beside a robot, as a straight line through what its range finder sees."""

from __future__ import annotations

import math
from typing import NamedTuple, Optional

import numpy as np

from basic_behaviours.sight import Sight
from rqt_mrta_py.model import wrap_angle

__all__ = ["Wall", "wall_beside"]

_AHEAD = math.radians(30.0)
_BEHIND = math.radians(130.0)
_HALF_WINDOW = math.radians(36.0)
_SAME_WALL = 1.6
_LARGEST_BEND = math.radians(30.0)


class Wall(NamedTuple):
    """A wall as seen from the robot.

    Attributes:
        distance: from the robot's centre to its nearest point [m].
        bearing: of that point [rad].
    """

    distance: float
    bearing: float


def wall_beside(sight: Sight, side: int, within: float) -> Optional[Wall]:
    """Find the nearest wall on one side, from a little ahead to behind.

    A straight line whose nearest point is d away at bearing b is seen at bearing p at range r with
    cos(p - b) / d = 1 / r, which is linear in cos(p) and sin(p): least squares over the rays about the nearest one
    give d and b. Where that disagrees with the nearest ray (a corner, a round thing), the nearest ray is taken.

    Args:
        sight: what is seen.
        side: 1 for the left, -1 for the right.
        within: how far a wall may be [m].

    Returns:
        The wall; None if there is none.
    """
    turned = side * sight.bearings
    beside = np.where((turned >= -_AHEAD) & (turned <= _BEHIND), sight.ranges, math.inf)
    nearest = int(np.argmin(beside))
    distance, bearing = float(beside[nearest]), float(sight.bearings[nearest])
    if distance > within:
        return None
    apart = np.abs(np.remainder(sight.bearings - bearing + np.pi, 2.0 * np.pi) - np.pi)
    chosen = (apart <= _HALF_WINDOW) & (sight.ranges < _SAME_WALL * distance)
    inverse = 1.0 / np.maximum(sight.ranges[chosen], 0.01)
    cos, sin = np.cos(sight.bearings[chosen]), np.sin(sight.bearings[chosen])
    cc, ss, cs = float(cos @ cos), float(sin @ sin), float(cos @ sin)
    cr, sr = float(cos @ inverse), float(sin @ inverse)
    determinant = cc * ss - cs * cs
    if inverse.size >= 3 and determinant > 1e-6:
        a, b = (ss * cr - cs * sr) / determinant, (cc * sr - cs * cr) / determinant
        fitted = math.atan2(b, a)
        if abs(wrap_angle(fitted - bearing)) < _LARGEST_BEND:
            return Wall(1.0 / math.hypot(a, b), fitted)
    return Wall(distance, bearing)
