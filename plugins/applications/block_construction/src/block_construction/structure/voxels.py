"""From filled cells to a structure that can stand."""

from __future__ import annotations

from typing import TYPE_CHECKING, Tuple

import numpy as np

from block_construction.errors import ConstructionError
from rqt_mrta_py.hooks import Structure, Voxel

if TYPE_CHECKING:
    from numpy.typing import NDArray

__all__ = ["MOST_CELLS", "check_size", "filled_cells", "structure_of"]

MOST_CELLS = 1_000_000
"""A grid may have so many cells, filled or not."""


def check_size(name: str, columns: int, rows: int, levels: int) -> None:
    """Check that a grid can be held.

    Args:
        name: of the drawing, for errors.
        columns: cells along x.
        rows: cells along y.
        levels: cells along z.

    Raises:
        ConstructionError: a side is below 1, or there are too many cells.
    """
    if min(columns, rows, levels) < 1:
        raise ConstructionError(f"{name}: measures {columns} x {rows} x {levels} cells; each side must be 1 or more")
    if columns * rows * levels > MOST_CELLS:
        raise ConstructionError(
            f"{name}: measures {columns} x {rows} x {levels} cells; at most {MOST_CELLS} are accepted"
        )


def structure_of(name: str, filled: NDArray[np.bool_]) -> Structure:
    """Make a structure of filled cells; empty columns and rows around them are left out.

    Differs from the paper: there concentric layers come from the bounds of the whole drawing, so that one structure
    drawn at two places would be built in two ways.

    Args:
        name: of the structure, for people and errors.
        filled: shape (levels, rows, columns); row index = y - 1.

    Returns:
        The structure, moved to column 1, row 1.

    Raises:
        ConstructionError: nothing is filled, or a cell floats; names the lowest, then first by row and column.
    """
    check_size(name, filled.shape[2], filled.shape[1], filled.shape[0])
    if not filled.any():
        raise ConstructionError(f"{name}: no cell is filled; a structure needs at least one")
    floating = filled[1:] & ~filled[:-1]
    if floating.any():
        level, row, column = np.argwhere(floating)[0].tolist()
        voxel = Voxel(column + 1, row + 1, level + 2)
        raise ConstructionError(
            f"{name}: the voxel at x {voxel.x}, y {voxel.y}, level {voxel.z} floats: the cell below it is empty; "
            f"{int(floating.sum())} in all; each filled cell above level 1 must stand on a filled one"
        )
    if not filled[0].any():
        raise ConstructionError(f"{name}: level 1 is empty; a structure stands on the floor")
    heights = filled.sum(axis=0)
    rows, columns = np.flatnonzero(heights.any(axis=1)), np.flatnonzero(heights.any(axis=0))
    kept = heights[rows[0] : rows[-1] + 1, columns[0] : columns[-1] + 1]
    listed: Tuple[Tuple[int, ...], ...] = tuple(tuple(int(height) for height in row) for row in kept)
    return Structure(name, listed)


def filled_cells(structure: Structure) -> NDArray[np.bool_]:
    """Give the filled cells of a structure: shape (levels, rows, columns), row index = y - 1."""
    heights = np.array(structure.heights, dtype=np.int64)
    filled: NDArray[np.bool_] = np.arange(structure.levels)[:, None, None] < heights[None]
    return filled
