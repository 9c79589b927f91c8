"""Points in a ``PointGrid`` that move or go."""

from __future__ import annotations

from mrta_demir_cf.planning.arrays import Floats, Mask
from mrta_demir_cf.planning.compiled import inner_kernel
from mrta_demir_cf.planning.point_grid import PointGrid

__all__ = ["border_of_ring", "cell_along", "remove", "sort_again"]


@inner_kernel
def cell_along(coordinate: float, low: float, grid: PointGrid) -> int:
    """Give the column or row of cells that holds a coordinate [m]; the nearest one for what lies outside."""
    return int(min(max((coordinate - low) // grid.width, 0.0), grid.side - 1.0))


@inner_kernel
def border_of_ring(place_x: float, place_y: float, ring: int, grid: PointGrid) -> float:
    """Tell how near points can be that lie in this square ring of cells around a place's own, or beyond [m].

    Returns:
        A lower bound, exact but for rounding; infinite if there are no such cells.
    """
    column, row = cell_along(place_x, grid.low[0], grid), cell_along(place_y, grid.low[1], grid)
    if ring == 0:
        return 0.0
    border = float("inf")
    if column - ring >= 0:
        border = min(border, place_x - grid.low[0] - (column - ring + 1) * grid.width)
    if column + ring < grid.side:
        border = min(border, grid.low[0] + (column + ring) * grid.width - place_x)
    if row - ring >= 0:
        border = min(border, place_y - grid.low[1] - (row - ring + 1) * grid.width)
    if row + ring < grid.side:
        border = min(border, grid.low[1] + (row + ring) * grid.width - place_y)
    return border


@inner_kernel
def sort_again(grid: PointGrid, points: Floats, hidden: Mask) -> None:
    """Put points where they belong, those of a cell by their index, but for hidden ones."""
    for cell in range(len(grid.first)):
        grid.first[cell] = 0
    for index in range(len(points)):
        if hidden[index]:
            continue
        row = cell_along(points[index, 1], grid.low[1], grid)
        cell = row * grid.side + cell_along(points[index, 0], grid.low[0], grid)
        grid.positions[index] = cell
        grid.first[cell + 1] += 1
    for cell in range(grid.side * grid.side):
        grid.first[cell + 1] += grid.first[cell]
        grid.ends[cell] = grid.first[cell]
    for index in range(len(points)):
        if hidden[index]:
            continue
        cell = grid.positions[index]
        grid.members[grid.ends[cell]] = index
        grid.positions[index] = grid.ends[cell]
        grid.ends[cell] += 1


@inner_kernel
def remove(grid: PointGrid, points: Floats, index: int) -> None:
    """Take a point out; the last one of its cell takes its position."""
    row = cell_along(points[index, 1], grid.low[1], grid)
    cell = row * grid.side + cell_along(points[index, 0], grid.low[0], grid)
    grid.ends[cell] -= 1
    last = grid.members[grid.ends[cell]]
    grid.members[grid.positions[index]] = last
    grid.positions[last] = grid.positions[index]
