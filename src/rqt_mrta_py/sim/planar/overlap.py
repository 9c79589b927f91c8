"""How deep two footprints are in each other, and which way apart is the shortest: the separating axis test.

Two convex shapes are apart if and only if some axis separates them: one across an edge of either, or, where a disc is
one of them, the axis from its centre to the nearest corner of the other. The axis on which they overlap least is the
way by which they come apart soonest.
"""

from __future__ import annotations

from typing import Tuple

import numpy as np

from rqt_mrta_py.sim.planar.cells import Floats

__all__ = ["overlap"]

_SIGNS: Tuple[Tuple[float, float, float], ...] = tuple(
    (a, b, c) for a in (1.0, -1.0) for b in (1.0, -1.0) for c in (1.0, -1.0)
)
"""A corner of a polygon lies at the sum of its three half edges with one of these; the others are inside."""


def overlap(apart: Floats, first: Floats, second: Floats, rounding: Floats) -> Tuple[Floats, Floats]:
    """Measure pairs of footprints.

    Args:
        apart: from the first's centre to the second's [m], shape (2, pairs).
        first: half edges of the first, a polygon, turned [m], shape (2, 3, pairs).
        second: half edges of the second, turned [m], shape (2, 3, pairs).
        rounding: the second's radius if it is a disc, else 0 [m], shape (pairs,).

    Returns:
        Depth of the overlap, negative for a gap [m], shape (pairs,); of two corners that face each other a gap may be
        given too small, never too large. And the unit vectors along which the first comes apart from the second by
        that depth, shape (2, pairs).
    """
    edges = np.concatenate((first, second), axis=1)
    across = np.stack((-edges[1], edges[0]))
    if rounding.any():
        across = np.concatenate((across, _from_nearest_corner(apart, first)), axis=1)
    length = np.hypot(across[0], across[1])
    nx, ny = across / np.where(length > 0.0, length, 1.0)
    reach = (np.abs(edges[0][:, None] * nx + edges[1][:, None] * ny)).sum(axis=0) + rounding
    along = apart[0] * nx + apart[1] * ny
    depth = np.where(length > 0.0, reach - np.abs(along), np.inf)
    best = np.argmin(depth, axis=0)[None]
    nx, ny, along, depth = (np.take_along_axis(field, best, axis=0)[0] for field in (nx, ny, along, depth))
    away = np.where(along > 0.0, -1.0, 1.0)
    return depth, np.stack((away * nx, away * ny))


def _from_nearest_corner(apart: Floats, first: Floats) -> Floats:
    """Give the vectors from the first's corners nearest to the second's centre to that centre, shape (2, 1, pairs)."""
    x, y = (
        np.stack([apart[axis] - (a * e[0] + b * e[1] + c * e[2]) for a, b, c in _SIGNS]) for axis, e in enumerate(first)
    )
    nearest = np.argmin(x * x + y * y, axis=0)[None]
    return np.stack((np.take_along_axis(x, nearest, axis=0), np.take_along_axis(y, nearest, axis=0)))
