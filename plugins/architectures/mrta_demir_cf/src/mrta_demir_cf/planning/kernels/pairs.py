"""The farthest pair among a few points of many, with the rule for ties of ``farthest_pair``."""

from __future__ import annotations

from typing import Tuple

import numpy as np

from mrta_demir_cf.planning.arrays import Floats, Indices
from mrta_demir_cf.planning.compiled import inner_kernel

__all__ = ["farthest_of"]


@inner_kernel
def farthest_of(points: Floats, chosen: Indices, count: int, outer: Indices) -> Tuple[int, int]:
    """Find the farthest pair among ``points[chosen[:count]]``, in any order; of equal ones the last by indices i < j.

    A point whose distance from the middle, added to the radius of all, stays below a distance that is there anyway, is
    no end of the pair; what is left is compared pair by pair.

    Args:
        points: (n, 2) [m].
        chosen: indices of some.
        count: how many.
        outer: room for as many.

    Returns:
        Indices i < j of points; twice the same if there is but one.
    """
    middle_x, middle_y = 0.0, 0.0
    for index in range(count):
        middle_x += points[chosen[index], 0] / count
        middle_y += points[chosen[index], 1] / count
    outermost, largest = 0, -1.0
    for index in range(count):
        square = _square(middle_x, middle_y, points, chosen[index])
        if square > largest:
            outermost, largest = chosen[index], square
    known = 0.0
    for index in range(count):
        known = max(known, _square(points[outermost, 0], points[outermost, 1], points, chosen[index]))
    radius = np.sqrt(largest)
    least = max((np.sqrt(known) - radius) * (1.0 - 1e-9) - 1e-9 * radius, 0.0)
    kept = 0
    for index in range(count):
        if _square(middle_x, middle_y, points, chosen[index]) >= least * least:
            outer[kept] = chosen[index]
            kept += 1
    longest, first, second = -1.0, chosen[0], chosen[0]
    for start in range(kept):
        for end in range(start):
            square = _square(points[outer[start], 0], points[outer[start], 1], points, outer[end])
            if square >= longest:
                low, high = min(outer[start], outer[end]), max(outer[start], outer[end])
                if square > longest or low > first or (low == first and high > second):
                    longest, first, second = square, low, high
    return first, second


@inner_kernel
def _square(x: float, y: float, points: Floats, index: int) -> float:
    along_x, along_y = points[index, 0] - x, points[index, 1] - y
    return float(along_x * along_x + along_y * along_y)
