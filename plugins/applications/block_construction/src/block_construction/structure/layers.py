"""Concentric layers of a grid, and the order in which its cells are numbered."""

from __future__ import annotations

from typing import Tuple

from rqt_mrta_py.hooks import Structure, Voxel

__all__ = ["cells_in_order", "layer_count", "layer_of"]


def layer_count(columns: int, rows: int) -> int:
    """Count the concentric layers of a grid: the shorter side, halved and rounded up.

    Args:
        columns: cells along x.
        rows: cells along y.

    Dantas (2017), equation 5.1.
    Differs from the paper: its formula reads as if of one cell; it is of the whole grid, as the example of 4 x 3 cells
    with 2 layers shows.
    """
    return (min(columns, rows) + 1) // 2


def layer_of(x: int, y: int, columns: int, rows: int) -> int:
    """Tell the concentric layer of a cell; 1 is the outermost.

    Args:
        x: column, from 1.
        y: row, from 1.
        columns: of the grid.
        rows: of the grid.

    Dantas (2017), equation 5.2.
    Differs from the paper: it leaves out "+ 1", with which the last column and row belong to layer 1 as the first do.
    """
    return min(x, y, columns - x + 1, rows - y + 1)


def cells_in_order(structure: Structure) -> Tuple[Voxel, ...]:
    """List the filled cells as automata are numbered: by level, from the outermost layer in, by row, by column.

    Dantas (2017), section 5.2.
    """
    columns, rows = structure.columns, structure.rows
    filled = [
        Voxel(x, y, z)
        for y in range(1, rows + 1)
        for x in range(1, columns + 1)
        for z in range(1, structure.heights[y - 1][x - 1] + 1)
    ]
    return tuple(sorted(filled, key=lambda cell: (cell.z, layer_of(cell.x, cell.y, columns, rows), cell.y, cell.x)))
