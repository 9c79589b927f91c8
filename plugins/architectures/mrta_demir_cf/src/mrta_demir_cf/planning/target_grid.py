"""Targets in square cells, so that those near a place are found without looking at all: memory O(N)."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from mrta_demir_cf.planning.arrays import Floats, Indices

__all__ = ["TargetGrid", "grid_of"]


class TargetGrid(NamedTuple):
    """Targets sorted into the cells of a square.

    Attributes:
        low: smallest coordinates of targets, (2,) [m].
        high: largest coordinates, (2,) [m].
        width: of a cell [m].
        side: cells along each axis.
        first: for each cell, row by row along x, where its targets begin in ``members``; one more at the end.
        members: indices of targets, cell by cell.
    """

    low: Floats
    high: Floats
    width: float
    side: int
    first: Indices
    members: Indices


def grid_of(targets: Floats) -> TargetGrid:
    """Sort targets into cells, two in each on average, were they spread evenly.

    Args:
        targets: (N, 2) [m], at least one.
    """
    low, high = targets.min(axis=0), targets.max(axis=0)
    side = max(1, int(np.sqrt(len(targets) / 2.0)))
    width = float((high - low).max()) / side or 1.0
    columns, rows = np.clip((targets - low) // width, 0, side - 1).astype(np.intp).T
    cells = rows * side + columns
    first = np.concatenate([[0], np.cumsum(np.bincount(cells, minlength=side * side))]).astype(np.intp)
    return TargetGrid(low, high, width, side, first, cells.argsort(kind="stable"))
