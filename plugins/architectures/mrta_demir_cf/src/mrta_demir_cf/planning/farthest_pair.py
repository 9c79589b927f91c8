"""The two points of a set that lie farthest apart: (b1, b2) of Eq. 3.

Of pairs at the same distance the last in lexicographic order of indices i < j is taken: Table 1 of Sariel, Erdogan and
Balch (2007) comes out under this rule only. Squared distances are compared, which are exact for integer coordinates.

Few points are compared pair by pair. Of many, only those that may lie on the rim: the end points of a farthest pair
are extreme points of the set, and all points are kept that cannot be proved not to be. (On coordinates that are not
integers, where rounding makes pairs equal that are not, a point within some 1e-16 of the rim may go.)
"""

from __future__ import annotations

from typing import List, Tuple

import numpy as np

from mrta_demir_cf.planning.arrays import Floats, Indices, squared_distances

__all__ = ["farthest_pair", "farthest_pair_of_all", "rim"]

FEW = 64
"""Up to so many points all pairs are compared."""

_ROWS = 64
"""Points whose distances to all points are looked at together: bounds the memory on a circle, where all are extreme."""

_ROUNDING = 4.0 * float(np.finfo(np.float64).eps)


def farthest_pair(points: Floats) -> Tuple[int, int]:
    """Find the two points that lie farthest apart; of equal pairs the last, i < j.

    Args:
        points: (n, 2) [m], at least two; they may coincide.

    Returns:
        Indices i < j.
    """
    if len(points) <= FEW:
        return farthest_pair_of_all(points)
    outer = rim(points)
    first, second = farthest_pair_of_all(points[outer])
    return int(outer[first]), int(outer[second])


def farthest_pair_of_all(points: Floats) -> Tuple[int, int]:
    """Find what ``farthest_pair`` finds by looking at all pairs i < j, some rows of them at a time."""
    count = len(points)
    columns = np.arange(count)
    longest, pair = -1.0, (0, 1)
    for start in range(0, count - 1, _ROWS):
        rows = columns[start : start + _ROWS, None]
        squares = np.where(columns > rows, squared_distances(points[rows], points), -1.0)
        # argmax takes the first of equals; read backwards, that is the last.
        last = squares.size - 1 - int(squares[::-1, ::-1].argmax())
        length = float(squares.flat[last])
        if length >= longest:
            longest, pair = length, (start + last // count, last % count)
    return pair


def rim(points: Floats) -> Indices:
    """Give the points that may be extreme: those on the convex hull, and what rounding cannot tell from it.

    Andrew's monotone chain (A. M. Andrew, Another efficient algorithm for convex hulls in two dimensions, Information
    Processing Letters 9(5), 1979) over the points outside an octagon that has extreme points as corners. Differs from
    it: a point is dropped only if it lies beyond rounding error on the inner side of a line between two others.

    Args:
        points: (n, 2) [m].

    Returns:
        Indices, rising.
    """
    kept = _outside_of_octagon(points)
    order = kept[np.lexsort((points[kept, 1], points[kept, 0]))]
    lower = _chain(points, order)
    upper = _chain(points, order[::-1])
    return np.unique(np.concatenate([lower, upper]))


def _outside_of_octagon(points: Floats) -> Indices:
    along_x, along_y = points[:, 0], points[:, 1]
    # The eight directions, going round against the clock.
    keys = (-along_y, along_x - along_y, along_x, along_x + along_y, along_y, along_y - along_x, -along_x)
    corners = [int(key.argmax()) for key in (*keys, -along_x - along_y)]
    inside = np.full(len(points), bool((points != points[0]).any()))
    for start, end in zip(corners, [*corners[1:], corners[0]]):
        if (points[start] != points[end]).any():
            inside &= _turn(points[start], points[end], points) > 0.0
    return np.flatnonzero(~inside)


def _chain(points: Floats, order: Indices) -> Indices:
    chain: List[int] = []
    for index in order.tolist():
        while len(chain) > 1 and float(_turn(points[chain[-2]], points[chain[-1]], points[index])) < 0.0:
            chain.pop()
        chain.append(index)
    return np.array(chain, dtype=np.intp)


def _turn(start: Floats, end: Floats, points: Floats) -> Floats:
    """Tell on which side of a line points lie: above 0 on its left, below 0 on its right, 0 where rounding hides it.

    The bound of the error is that of J. R. Shewchuk, Adaptive precision floating-point arithmetic and fast robust
    geometric predicates, Discrete & Computational Geometry 18, 1997, stage A, rounded up.
    """
    left = (end[0] - start[0]) * (points[..., 1] - start[1])
    right = (end[1] - start[1]) * (points[..., 0] - start[0])
    side = left - right
    certain = np.abs(side) > _ROUNDING * (np.abs(left) + np.abs(right))
    return np.asarray(np.where(certain, side, 0.0), dtype=np.float64)
