"""The farthest pair among a few points of many, with the rule for ties of ``farthest_pair``."""

from __future__ import annotations

from typing import Tuple

import numpy as np

from mrta_demir_cf.planning.arrays import Floats, Indices
from mrta_demir_cf.planning.compiled import kernel

__all__ = ["farthest_of"]


@kernel
def farthest_of(points: Floats, chosen: Indices, count: int) -> Tuple[int, int]:
    """Find the farthest pair among ``points[chosen[:count]]``, ``chosen`` rising; of equal ones the last.

    A point whose distance from the middle, added to the radius of all, stays below a distance that is there anyway, is
    no end of the pair; what is left is compared pair by pair.

    Returns:
        Indices of points.
    """
    middle_x, middle_y = 0.0, 0.0
    for index in range(count):
        middle_x += points[chosen[index], 0] / count
        middle_y += points[chosen[index], 1] / count
    radii = np.empty(count)
    outermost = 0
    for index in range(count):
        along_x, along_y = points[chosen[index], 0] - middle_x, points[chosen[index], 1] - middle_y
        radii[index] = np.sqrt(along_x * along_x + along_y * along_y)
        if radii[index] > radii[outermost]:
            outermost = index
    known = 0.0
    for index in range(count):
        known = max(known, _square(points, chosen[outermost], chosen[index]))
    least = (np.sqrt(known) - radii[outermost]) * (1.0 - 1e-9) - 1e-9 * radii[outermost]
    outer = np.empty(count, dtype=np.intp)
    kept = 0
    for index in range(count):
        if radii[index] >= least:
            outer[kept] = chosen[index]
            kept += 1
    longest, first, second = -1.0, chosen[0], chosen[0]
    for start in range(kept):
        for end in range(start + 1, kept):
            square = _square(points, outer[start], outer[end])
            if square >= longest:
                longest, first, second = square, outer[start], outer[end]
    return first, second


@kernel
def _square(points: Floats, start: int, end: int) -> float:
    along_x = points[end, 0] - points[start, 0]
    along_y = points[end, 1] - points[start, 1]
    return float(along_x * along_x + along_y * along_y)
