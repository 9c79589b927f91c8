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

_CORNERS = tuple((a, b, c) for a in (1.0, -1.0) for b in (1.0, -1.0) for c in (1.0, -1.0))
"""A corner of a polygon lies at the sum of its three half edges with one of these signs; not all such sums are one."""


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
    edges_x, edges_y = np.concatenate((first, second), axis=1)
    across_x, across_y = -edges_y, edges_x
    if rounding.any():
        x, y = _from_nearest_corner(apart, first)
        across_x, across_y = np.concatenate((across_x, x)), np.concatenate((across_y, y))
    length = np.hypot(across_x, across_y)
    is_axis = length > 0.0
    length[~is_axis] = 1.0
    across_x, across_y = across_x / length, across_y / length
    reach = np.abs(edges_x[:, None] * across_x + edges_y[:, None] * across_y).sum(axis=0)
    along = apart[0] * across_x + apart[1] * across_y
    depths = np.where(is_axis, reach - np.abs(along), np.inf)
    chosen = (np.argmin(depths, axis=0), np.arange(rounding.size))
    away = np.where(along[chosen] > 0.0, -1.0, 1.0)
    return depths[chosen] + rounding, np.stack((away * across_x[chosen], away * across_y[chosen]))


def _from_nearest_corner(apart: Floats, first: Floats) -> Floats:
    """Give the vectors from the first's corners nearest to the second's centre to that centre, shape (2, 1, pairs)."""
    signs = np.array(_CORNERS)[:, :, None]
    x = apart[0] - (signs * first[0]).sum(axis=1)
    y = apart[1] - (signs * first[1]).sum(axis=1)
    chosen = (np.argmin(x * x + y * y, axis=0), np.arange(x.shape[1]))
    return np.stack((x[chosen], y[chosen]))[:, None]
