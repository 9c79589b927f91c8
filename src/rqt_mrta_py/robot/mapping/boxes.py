"""Occupied cells as few obstacles, which any planner understands."""

from __future__ import annotations

from typing import TYPE_CHECKING, Dict, List, Tuple

import numpy as np

from rqt_mrta_py.model import Obstacle, Pose

if TYPE_CHECKING:
    from numpy.typing import NDArray

__all__ = ["boxes"]

Block = Tuple[int, int, int, int]
"""First row, row after the last, first column, column after the last."""


def boxes(
    occupied: NDArray[np.bool_], min_x: float, min_y: float, resolution: float, height: float
) -> Tuple[Obstacle, ...]:
    """Cover the occupied cells of a grid, and no other cell, by boxes.

    Neighbours in a row are joined, and then equal pieces of neighbouring rows.

    Args:
        occupied: shape (rows, columns).
        min_x: of the grid's corner [m].
        min_y: of the grid's corner [m].
        resolution: edge of a cell [m].
        height: of the boxes [m].

    Returns:
        The boxes, by their first row, then column.
    """
    return tuple(
        Obstacle(
            f"seen{number}",
            Pose(min_x + (left + right) / 2.0 * resolution, min_y + (low + high) / 2.0 * resolution),
            ((right - left) * resolution, (high - low) * resolution, height),
        )
        for number, (low, high, left, right) in enumerate(sorted(_blocks(occupied)))
    )


def _blocks(occupied: NDArray[np.bool_]) -> List[Block]:
    blocks: List[Block] = []
    growing: Dict[Tuple[int, int], int] = {}
    (rows,) = np.nonzero(occupied.any(axis=1))
    for row in rows.tolist():
        edges = np.diff(np.concatenate(([0], occupied[row].astype(np.int8), [0])))
        runs = list(zip(np.flatnonzero(edges == 1).tolist(), np.flatnonzero(edges == -1).tolist()))
        reached = {run: growing[run] for run in runs if run in growing and blocks[growing[run]][1] == row}
        for left, right in runs:
            number = reached.get((left, right))
            if number is None:
                reached[left, right] = len(blocks)
                blocks.append((row, row + 1, left, right))
            else:
                blocks[number] = (blocks[number][0], row + 1, left, right)
        growing = reached
    return blocks
