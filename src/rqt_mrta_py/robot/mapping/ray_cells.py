"""Which cells of a grid straight rays pass through (the walk of Amanatides and Woo 1987, for many rays at once)."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, Tuple

import numpy as np

if TYPE_CHECKING:
    from numpy.typing import NDArray

__all__ = ["ray_cells"]


def ray_cells(
    x: float, y: float, directions: NDArray[np.float64], lengths: NDArray[np.float64]
) -> Tuple[NDArray[np.intp], NDArray[np.intp]]:
    """List the cells that rays from one point pass through or end in.

    A ray enters a cell where it crosses a border of columns or of rows: of the first kind the column is known and the
    row is looked up, of the second the other way round. Lengths are in cells: the cell (c, r) covers [c, c + 1) x
    [r, r + 1).

    Args:
        x: column of the point, with its fraction.
        y: row of the point, with its fraction.
        directions: of the rays [rad], shape (rays,).
        lengths: of the rays, finite [cells], shape (rays,).

    Returns:
        Columns and rows of the cells, in no special order, some of them more than once; the point's own is the first.
    """
    along = _entered(x, y, np.cos(directions), np.sin(directions), lengths)
    across = _entered(y, x, np.sin(directions), np.cos(directions), lengths)
    here = (np.array([math.floor(x)], dtype=np.intp), np.array([math.floor(y)], dtype=np.intp))
    return (
        np.concatenate((here[0], along[0], across[1])),
        np.concatenate((here[1], along[1], across[0])),
    )


def _entered(
    start: float, aside: float, step: NDArray[np.float64], step_aside: NDArray[np.float64], lengths: NDArray[np.float64]
) -> Tuple[NDArray[np.intp], NDArray[np.intp]]:
    """List the cells entered by crossing a border along one axis: their numbers along it, and across."""
    crossings = np.floor(start + step * lengths) - math.floor(start)
    most = int(np.abs(crossings).max()) if crossings.size else 0
    numbers = np.arange(1, most + 1, dtype=np.float64)[None, :]
    forward = (step > 0.0)[:, None]
    cell = math.floor(start) + np.where(forward, numbers, -numbers)
    border = np.where(forward, cell, cell + 1.0)
    with np.errstate(divide="ignore", invalid="ignore"):
        travelled = (border - start) / step[:, None]
        across = aside + step_aside[:, None] * travelled
        # Through a corner, a ray goes on to the cell that lies in its direction on both axes.
        beside = np.where(step_aside[:, None] < 0.0, np.ceil(across) - 1.0, np.floor(across))
    crossed = numbers <= np.abs(crossings)[:, None]
    return cell[crossed].astype(np.intp), beside[crossed].astype(np.intp)
