"""What "near a robot's rough schedule" means, which the paper leaves open (Algorithm 3'')."""

from __future__ import annotations

import math
from typing import List, Sequence, Tuple

__all__ = ["hull_distance", "is_near", "mean_nearest_neighbour"]

_Point = Tuple[float, float]


def is_near(place: _Point, rival: _Point, schedule: Sequence[_Point], others: Sequence[_Point]) -> bool:
    """Tell whether another's request concerns a robot's rough schedule.

    Differs from the paper, which gives no threshold: it does if the requested task lies in the convex hull of the
    schedule, dilated by the mean distance of its tasks to their nearest neighbours; or if the requester is the nearest
    other robot to some task of the schedule.

    Args:
        place: where the requested task is [m].
        rival: where the requester is [m].
        schedule: places of the tasks of the rough schedule [m]; nothing is near an empty one.
        others: places of the other robots, without the requester [m].
    """
    if not schedule:
        return False
    if hull_distance(place, schedule) <= mean_nearest_neighbour(schedule):
        return True
    return any(all(math.dist(rival, task) <= math.dist(other, task) for other in others) for task in schedule)


def mean_nearest_neighbour(points: Sequence[_Point]) -> float:
    """Give the mean distance of points to their nearest neighbours; 0 for less than two [m]."""
    if len(points) < 2:
        return 0.0
    nearest = [
        min(math.dist(point, other) for j, other in enumerate(points) if i != j) for i, point in enumerate(points)
    ]
    return sum(nearest) / len(nearest)


def hull_distance(place: _Point, points: Sequence[_Point]) -> float:
    """Give how far a place is from the convex hull of points; 0 inside [m].

    Args:
        place: anywhere.
        points: at least one.
    """
    hull = _convex_hull(points)
    if len(hull) == 1:
        return math.dist(place, hull[0])
    edges = list(zip(hull, hull[1:] + hull[:1]))
    if len(hull) > 2 and all(_turn(start, end, place) >= 0.0 for start, end in edges):
        return 0.0
    return min(_segment_distance(place, start, end) for start, end in edges)


def _convex_hull(points: Sequence[_Point]) -> List[_Point]:
    """Give the corners of the convex hull, counter-clockwise (monotone chain of A. M. Andrew, 1979)."""
    ordered = sorted(set(points))
    if len(ordered) < 3:
        return ordered
    chains: List[List[_Point]] = []
    for way in (ordered, ordered[::-1]):
        chain: List[_Point] = []
        for point in way:
            while len(chain) > 1 and _turn(chain[-2], chain[-1], point) <= 0.0:
                chain.pop()
            chain.append(point)
        chains.append(chain[:-1])
    return chains[0] + chains[1]


def _turn(start: _Point, end: _Point, point: _Point) -> float:
    """Give a number above 0 if a point is to the left of the way from start to end, below 0 to its right."""
    return (end[0] - start[0]) * (point[1] - start[1]) - (end[1] - start[1]) * (point[0] - start[0])


def _segment_distance(place: _Point, start: _Point, end: _Point) -> float:
    along = (end[0] - start[0], end[1] - start[1])
    length = along[0] ** 2 + along[1] ** 2
    share = 0.0
    if length > 0.0:
        share = ((place[0] - start[0]) * along[0] + (place[1] - start[1]) * along[1]) / length
        share = min(1.0, max(0.0, share))
    return math.dist(place, (start[0] + share * along[0], start[1] + share * along[1]))
