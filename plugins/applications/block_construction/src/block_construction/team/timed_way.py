"""Ways in space and time: where a robot will be when."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, Iterable, NamedTuple, Tuple

import numpy as np

if TYPE_CHECKING:
    from numpy.typing import NDArray

__all__ = [
    "TimedPoint",
    "TimedWay",
    "clear_since",
    "is_apart",
    "last_time",
    "place_at",
    "places_at",
    "way_length",
]

_SLACK = 1e-7
"""By how much distances may be off by rounding [m]."""


class TimedPoint(NamedTuple):
    """A place, and when a robot is there.

    Attributes:
        time: [s].
        x, y: [m].
    """

    time: float
    x: float
    y: float


TimedWay = Tuple[TimedPoint, ...]
"""Straight between its points, each at an even speed; before the first the robot stands there, and the last is held."""


def place_at(way: TimedWay, time: float) -> Tuple[float, float]:
    """Tell where a robot is on its way at one time [m]."""
    if time <= way[0].time:
        return way[0].x, way[0].y
    for before, after in zip(way, way[1:]):
        if time <= after.time:
            share = (time - before.time) / (after.time - before.time) if after.time > before.time else 1.0
            return before.x + share * (after.x - before.x), before.y + share * (after.y - before.y)
    return way[-1].x, way[-1].y


def places_at(way: TimedWay, times: NDArray[np.float64]) -> NDArray[np.float64]:
    """Tell where a robot is on its way at many times [m]: array (times, 2)."""
    points = np.array(way, dtype=np.float64)
    return np.stack([np.interp(times, points[:, 0], points[:, axis]) for axis in (1, 2)], axis=1)


def way_length(way: TimedWay) -> float:
    """Give the length of a way [m]."""
    return sum(math.hypot(b.x - a.x, b.y - a.y) for a, b in zip(way, way[1:]))


def is_apart(one: TimedPoint, other: TimedPoint, way: TimedWay, clearance: float) -> bool:
    """Tell whether a straight move keeps clear of somebody else's way.

    A move that begins nearer than the clearance is clear if it comes no nearer than it begins: robots that stand close
    may part.

    Args:
        one: where and when the move begins.
        other: where and when it ends.
        way: of the other robot.
        clearance: between the middles of both [m].
    """
    kept = min(clearance, math.dist((one.x, one.y), place_at(way, one.time)))
    times = [one.time, *(point.time for point in way if one.time < point.time < other.time), other.time]
    gaps = []
    for time in times:
        (x, y), (there_x, there_y) = place_at((one, other), time), place_at(way, time)
        gaps.append((x - there_x, y - there_y))
    return all(_nearest(a, b) >= kept - _SLACK for a, b in zip(gaps, gaps[1:]))


def clear_since(place: Tuple[float, float], way: TimedWay, clearance: float) -> float:
    """Tell from when on a place is left clear for ever by a robot on its way [s].

    Args:
        place: [m].
        way: of the robot.
        clearance: between the middles of both [m].

    Returns:
        Minus infinity if it is clear all the time, infinity if it never will be.
    """
    gaps = [(point.x - place[0], point.y - place[1]) for point in way]
    if math.hypot(*gaps[-1]) < clearance - _SLACK:
        return math.inf
    for number in range(len(way) - 1, 0, -1):
        (x, y), (end_x, end_y) = gaps[number - 1], gaps[number]
        if _nearest((x, y), (end_x, end_y)) >= clearance - _SLACK:
            continue
        # The last of both times at which it crosses the circle: |x + share dx| = clearance.
        dx, dy = end_x - x, end_y - y
        square, half = dx * dx + dy * dy, x * dx + y * dy
        root = math.sqrt(max(0.0, half * half - square * (x * x + y * y - clearance * clearance)))
        share = min(1.0, (root - half) / square)
        return way[number - 1].time + share * (way[number].time - way[number - 1].time)
    return -math.inf


def last_time(ways: Iterable[TimedWay]) -> float:
    """Tell when the last of several robots comes to rest [s]; minus infinity without any."""
    return max((way[-1].time for way in ways), default=-math.inf)


def _nearest(one: Tuple[float, float], other: Tuple[float, float]) -> float:
    """Give how near a straight line between two points comes to the origin."""
    (x, y), dx, dy = one, other[0] - one[0], other[1] - one[1]
    length = dx * dx + dy * dy
    share = 0.0 if length == 0.0 else min(1.0, max(0.0, -(x * dx + y * dy) / length))
    return math.hypot(x + share * dx, y + share * dy)
