"""Points in square cells, so that those near a place are found without looking at all: memory O(n)."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from mrta_demir_cf.planning.arrays import Floats, Indices

__all__ = ["PointGrid", "grid_of"]


class PointGrid(NamedTuple):
    """Points sorted into the cells of a square.

    Attributes:
        low: smallest coordinates of the rectangle that holds the points, (2,) [m].
        high: its largest coordinates, (2,) [m].
        width: of a cell [m].
        side: cells along each axis.
        first: for each cell, row by row along x, where its points begin in ``members``; one more at the end.
        ends: for each cell, where its points end; before ``first`` of the next one where points were removed.
        members: indices of points, cell by cell.
        positions: where each point stands in ``members``.
    """

    low: Floats
    high: Floats
    width: float
    side: int
    first: Indices
    ends: Indices
    members: Indices
    positions: Indices


def grid_of(points: Floats, low: Floats, high: Floats, crowd: float) -> PointGrid:
    """Sort points into cells.

    Args:
        points: (n, 2) [m], at least one.
        low: smallest coordinates of a rectangle that holds them, (2,) [m].
        high: its largest coordinates, (2,) [m].
        crowd: points in a cell, were they spread evenly over a square.
    """
    side = max(1, int(np.sqrt(len(points) / crowd)))
    width = float((high - low).max()) / side or 1.0
    columns, rows = np.clip((points - low) // width, 0, side - 1).astype(np.intp).T
    cells = rows * side + columns
    first = np.concatenate([[0], np.cumsum(np.bincount(cells, minlength=side * side))]).astype(np.intp)
    members = cells.argsort(kind="stable")
    positions = np.empty(len(points), dtype=np.intp)
    positions[members] = np.arange(len(points))
    return PointGrid(low, high, width, side, first, first[1:].copy(), members, positions)
