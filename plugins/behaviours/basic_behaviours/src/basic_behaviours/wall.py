"""The wall beside a robot, as a straight line through what its range finder sees."""

from __future__ import annotations

import math
from typing import NamedTuple, Optional

import numpy as np

from basic_behaviours.sight import FAR, Sight
from rqt_mrta_py.model import Pose, wrap_angle

__all__ = ["KnownWall", "Wall", "length_at", "nearest_long_wall", "wall_at", "wall_beside"]

_AHEAD = math.radians(30.0)
_BEHIND = math.radians(130.0)
_HALF_WINDOW = math.radians(36.0)
_SAME_WALL = 1.6
_LARGEST_BEND = math.radians(75.0)
_OFF_LINE = 0.06
_OFF_LINE_PER_METRE = 0.03


class Wall(NamedTuple):
    """A wall as seen from the robot.

    Attributes:
        distance: from the robot's centre to its nearest point [m].
        bearing: of that point [rad].
    """

    distance: float
    bearing: float


class KnownWall(NamedTuple):
    """A wall in the frame ``map``: a straight line by its normal form.

    Attributes:
        normal: direction from the side on which the robot was when it saw the wall [rad].
        offset: of the line from the origin along that direction [m].
        seen: when it was seen last [s].
    """

    normal: float
    offset: float
    seen: float

    @classmethod
    def at(cls, wall: Wall, pose: Pose, now: float) -> KnownWall:
        """Place a wall that is seen from a pose at a time [s] on the map."""
        normal = wrap_angle(pose.yaw + wall.bearing)
        return cls(normal, _along(normal, pose) + wall.distance, now)

    def seen_from(self, pose: Pose) -> Optional[Wall]:
        """Give the wall as seen from a pose; None from its other side."""
        distance = self.offset - _along(self.normal, pose)
        return Wall(distance, wrap_angle(self.normal - pose.yaw)) if distance > 0.0 else None


def _along(normal: float, pose: Pose) -> float:
    return math.cos(normal) * pose.x + math.sin(normal) * pose.y


def wall_beside(sight: Sight, side: int, within: float, least: float = 0.0) -> Optional[Wall]:
    """Find the nearest wall on one side, from a little ahead to behind.

    Args:
        sight: what is seen.
        side: 1 for the left, -1 for the right.
        within: how far what is seen of it may be [m].
        least: how long it must be seen to be; 0 for anything [m].

    Returns:
        The wall; None if there is none.
    """
    turned = side * sight.bearings
    (rays,) = np.nonzero((turned >= -_AHEAD) & (turned <= _BEHIND) & (sight.ranges <= within))
    for ray in rays[np.argsort(sight.ranges[rays], kind="stable")].tolist():
        if least <= 0.0 or length_at(sight, ray) >= least:
            return wall_at(sight, ray)
    return None


def wall_at(sight: Sight, ray: int) -> Wall:
    """Fit a wall to what the rays about one ray have met.

    A straight line whose nearest point is d away at bearing b is seen at bearing p at range r with
    cos(p - b) / d = 1 / r, which is linear in cos(p) and sin(p): least squares give d and b. Where the ray itself does
    not end on that line (a corner, a round thing), its end is taken for the wall's nearest point.

    Args:
        sight: what is seen.
        ray: index of the ray.
    """
    distance, bearing = float(sight.ranges[ray]), float(sight.bearings[ray])
    apart = np.abs(np.remainder(sight.bearings - bearing + np.pi, 2.0 * np.pi) - np.pi)
    alike = (sight.ranges < _SAME_WALL * distance) & (sight.ranges * _SAME_WALL > distance)
    chosen = alike & (apart <= _HALF_WINDOW)
    inverse = 1.0 / np.maximum(sight.ranges[chosen], 0.01)
    cos, sin = np.cos(sight.bearings[chosen]), np.sin(sight.bearings[chosen])
    cc, ss, cs = float(cos @ cos), float(sin @ sin), float(cos @ sin)
    cr, sr = float(cos @ inverse), float(sin @ inverse)
    determinant = cc * ss - cs * cs
    if inverse.size >= 3 and determinant > 1e-6:
        a, b = (ss * cr - cs * sr) / determinant, (cc * sr - cs * cr) / determinant
        fitted = Wall(1.0 / max(math.hypot(a, b), 1e-6), math.atan2(b, a))
        bend = abs(wrap_angle(fitted.bearing - bearing))
        off_line = abs(distance * math.cos(bend) - fitted.distance)
        if bend < _LARGEST_BEND and off_line < _OFF_LINE + _OFF_LINE_PER_METRE * distance:
            return fitted
    return Wall(distance, bearing)


def length_at(sight: Sight, ray: int) -> float:
    """Measure how much of the wall that a ray has met is seen.

    Args:
        sight: what is seen.
        ray: index of the ray.

    Returns:
        How far apart the outermost points are to which neighbouring rays lead along the fitted line without a gap of
        more than one ray [m].
    """
    wall = wall_at(sight, ray)
    between = sight.bearings - wall.bearing
    off_line = np.abs(sight.ranges * np.cos(between) - wall.distance)
    on_line = (off_line < _OFF_LINE + _OFF_LINE_PER_METRE * sight.ranges).tolist()
    along = (sight.ranges * np.sin(between)).tolist()
    count = len(on_line)
    low = high = along[ray]
    for step in (1, -1):
        missed = 0
        for index in range(ray + step, ray + step * count, step):
            if not (0 <= index < count or sight.all_around):
                break
            if on_line[index % count]:
                missed = 0
                low, high = min(low, along[index % count]), max(high, along[index % count])
            else:
                missed += 1
                if missed > 1:
                    break
    return float(high - low)


def nearest_long_wall(sight: Sight, least: float, beyond: float = 0.0) -> Optional[Wall]:
    """Find the nearest wall all around that is at least so long and beyond a distance [m]; None if none is seen."""
    for ray in np.argsort(sight.ranges, kind="stable").tolist():
        if sight.ranges[ray] >= FAR:
            return None
        if sight.ranges[ray] > beyond and length_at(sight, ray) >= least:
            return wall_at(sight, ray)
    return None
