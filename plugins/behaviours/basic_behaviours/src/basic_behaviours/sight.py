"""What a range finder sees, and how far the robot can go in each direction.

Directions and bearings are relative to the robot's heading, counter-clockwise [rad]; distances are from its centre.
"""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, Dict, NamedTuple, Optional, Sequence, Tuple

import numpy as np

from rqt_mrta_py.hooks import Heard, Perception, Subscription

if TYPE_CHECKING:
    from numpy.typing import NDArray

__all__ = ["FAR", "SCAN", "Disc", "Sight", "SightReader"]

SCAN = Subscription(
    "scan",
    "sensor_msgs/LaserScan",
    ("angle_min", "angle_increment", "range_min", "range_max", "ranges"),
)

FAR = 1000.0
"""Stands for the distance of what is not seen [m]; finite, so that arithmetic stays finite."""

_STALE = 1.0
_MOST_DIRECTIONS = 36


class _Rays:
    """The directions of a range finder's rays, and those among them in which a robot may think of going."""

    def __init__(self, count: int, angle_min: float, angle_increment: float) -> None:
        self.key = (count, angle_min, angle_increment)
        raw = angle_min + angle_increment * np.arange(count, dtype=np.float64)
        self.bearings: NDArray[np.float64] = np.remainder(raw + np.pi, 2.0 * np.pi) - np.pi
        self.directions: NDArray[np.float64] = self.bearings[:: math.ceil(count / _MOST_DIRECTIONS) or 1]
        between = self.bearings[None, :] - self.directions[:, None]
        self.along: NDArray[np.float64] = np.cos(between)
        self.across: NDArray[np.float64] = np.sin(between)
        self.all_around = count * abs(angle_increment) > 2.0 * math.pi - 1.5 * abs(angle_increment)
        self.limits = sorted((angle_min, angle_min + angle_increment * (count - 1)))


class Disc(NamedTuple):
    """Something on the floor, as seen from the robot.

    Attributes:
        x: of its centre, ahead of the robot's [m].
        y: of the same, to the left [m].
        radius: [m].
    """

    x: float
    y: float
    radius: float


class Sight:
    """One scan, made ready to steer by.

    Attributes:
        bearings: of the rays, in [-pi, pi) [rad], shape (rays,).
        ranges: distance of what each ray met, ``FAR`` where it met nothing [m], shape (rays,).
        directions: in which ``travel`` looks [rad], shape (directions,).
    """

    def __init__(self, rays: _Rays, ranges: NDArray[np.float64]) -> None:
        self._rays = rays
        self.bearings = rays.bearings
        self.ranges = ranges
        self.directions = rays.directions
        self._travel: Optional[Tuple[float, NDArray[np.float64]]] = None
        self._towards: Dict[Tuple[float, float], float] = {}

    @property
    def all_around(self) -> bool:
        """True if the rays leave no gap, behind the robot neither."""
        return self._rays.all_around

    def with_discs(self, discs: Sequence[Disc]) -> Sight:
        """Give the same sight with discs on the floor in it, which are too low for the range finder perhaps."""
        ranges = self.ranges.copy()
        for disc in discs:
            distance = math.hypot(disc.x, disc.y)
            apart = np.abs(np.remainder(self.bearings - math.atan2(disc.y, disc.x) + np.pi, 2.0 * np.pi) - np.pi)
            half = math.asin(min(1.0, disc.radius / max(distance, 1e-9)))
            # Its nearest point lies on the ray next to its centre, should it be too small to be met by one.
            met = (apart <= half) | (apart <= apart.min())
            ranges[met] = np.minimum(ranges[met], max(distance - disc.radius, 0.01))
        return Sight(self._rays, ranges)

    def without_disc(self, disc: Disc) -> Sight:
        """Give the same sight as if what was met within a disc were not there, nor anything behind it."""
        xs, ys = self.ranges * np.cos(self.bearings), self.ranges * np.sin(self.bearings)
        within = (xs - disc.x) ** 2 + (ys - disc.y) ** 2 <= disc.radius**2
        return Sight(self._rays, np.where(within, FAR, self.ranges))

    def within(self, direction: float) -> float:
        """Bring a direction to the nearest one that is seen [rad]."""
        if self._rays.all_around:
            return direction
        low, high = self._rays.limits
        return min(max(direction, low), high)

    def travel(self, radius: float) -> NDArray[np.float64]:
        """Compute how far a disc can go in each of ``directions`` before it touches what is seen.

        Args:
            radius: of the disc [m].

        Returns:
            Distances [m], ``FAR`` or thereabouts where nothing is in the way, shape (directions,). What is already
            inside the disc bars the half-plane of directions towards it.
        """
        if self._travel is None or self._travel[0] != radius:
            free = _travel(self.ranges * self._rays.along, self.ranges * self._rays.across, radius).min(axis=1)
            self._travel = (radius, free)
        return self._travel[1]

    def travel_towards(self, direction: float, radius: float) -> float:
        """Compute the same for one direction, whichever [m]; of a scan, once."""
        asked = (direction, radius)
        if asked not in self._towards:
            between = self.bearings - direction
            free = _travel(self.ranges * np.cos(between), self.ranges * np.sin(between), radius)
            self._towards[asked] = float(free.min())
        return self._towards[asked]


class SightReader:
    """Turns the newest scan into a Sight, once for each scan."""

    def __init__(self) -> None:
        self._rays: Optional[_Rays] = None
        self._heard: Optional[Heard] = None
        self._sight: Optional[Sight] = None

    def read(self, perception: Perception) -> Optional[Sight]:
        """Give what is seen now; None if nothing was heard for a second, or the scan has no rays."""
        heard = perception.newest(SCAN.topic)
        if heard is None or perception.now - heard.receipt > _STALE:
            return None
        if heard is not self._heard:
            self._heard = heard
            self._sight = self._see(heard)
        return self._sight

    @staticmethod
    def is_fresh(perception: Perception) -> bool:
        """Tell whether a scan was heard within the last second."""
        heard = perception.newest(SCAN.topic)
        return heard is not None and perception.now - heard.receipt <= _STALE

    def _see(self, heard: Heard) -> Optional[Sight]:
        fields = heard.fields
        ranges = np.array(fields["ranges"], dtype=np.float64)
        angle_min, angle_increment = float(fields["angle_min"]), float(fields["angle_increment"])
        if ranges.size == 0 or not (math.isfinite(angle_min) and math.isfinite(angle_increment)):
            return None
        if self._rays is None or self._rays.key != (ranges.size, angle_min, angle_increment):
            self._rays = _Rays(ranges.size, angle_min, angle_increment)
        # REP-117: -inf is too near to be measured; any other value outside the limits means nothing, NaN neither.
        valid = (ranges >= fields["range_min"]) & (ranges <= fields["range_max"])
        return Sight(self._rays, np.where(valid, ranges, np.where(np.isneginf(ranges), fields["range_min"], FAR)))


def _travel(along: NDArray[np.float64], across: NDArray[np.float64], radius: float) -> NDArray[np.float64]:
    reach = radius * radius - across * across
    in_the_way = (reach > 0.0) & (along > 0.0)
    free: NDArray[np.float64] = np.where(in_the_way, along - np.sqrt(np.maximum(reach, 0.0)), FAR)
    return np.maximum(free, 0.0)
