"""The free floor of an arena, as square cells, each of which counts as its centre."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, NamedTuple, Sequence, Tuple

import numpy as np

from rqt_mrta_py.model import Arena, Obstacle

if TYPE_CHECKING:
    from numpy.typing import NDArray

__all__ = ["CELL", "Bands", "Floor", "Patch"]

CELL = 0.25
"""Side of a cell [m]; as long as a small robot."""

_MOST_CELLS = 1_000_000

_ROUNDING = 1e-9
"""What lies on the edge of reach is near, whatever rounding did [cells]."""


class Bands(NamedTuple):
    """Parts of rows of cells, each near one place.

    Attributes:
        places: indices, rising.
        rows: of the floor's grid.
        first: column.
        end: column after the last.
    """

    places: NDArray[np.int64]
    rows: NDArray[np.int64]
    first: NDArray[np.int64]
    end: NDArray[np.int64]


class Patch(NamedTuple):
    """A rectangular part of a floor, and some of its cells.

    Attributes:
        rows: of the floor's grid, along x.
        columns: of the floor's grid, along y.
        cells: which of them, shape (rows, columns).
    """

    rows: slice
    columns: slice
    cells: NDArray[np.bool_]


class Floor:
    """Which cells of an arena are free floor.

    Cells are ``CELL`` wide, wider in arenas of more than a million of them.

    Args:
        arena: where the floor ends.
        obstacles: what stands on it for good.
    """

    def __init__(self, arena: Arena, obstacles: Sequence[Obstacle]) -> None:
        self._corner = (arena.min_x, arena.min_y)
        width, length = arena.max_x - arena.min_x, arena.max_y - arena.min_y
        self._cell = max(CELL, math.sqrt(width * length / _MOST_CELLS))
        x = _centres(arena.min_x, arena.max_x, self._cell)
        y = _centres(arena.min_y, arena.max_y, self._cell)
        free = np.ones((len(x), len(y)), dtype=bool)
        for obstacle in obstacles:
            reach = math.hypot(obstacle.size[0], obstacle.size[1]) / 2.0
            rows = _within(x, obstacle.pose.x, reach)
            columns = _within(y, obstacle.pose.y, reach)
            free[rows, columns] &= ~_inside(obstacle, x[rows, None], y[None, columns])
        self._free = free

    @property
    def shape(self) -> Tuple[int, int]:
        """How many cells there are along x and along y."""
        return self._free.shape[0], self._free.shape[1]

    @property
    def free_cells(self) -> int:
        """How many cells are free floor."""
        return int(np.count_nonzero(self._free))

    def near(self, places: Sequence[Tuple[float, float]], reach: float) -> Bands:
        """Find the cells whose centres are near some places: in each row of cells those between two ends.

        Args:
            places: x and y of each, in the arena's frame [m].
            reach: how far a centre may be from a place to count as near [m].

        Returns:
            The rows' parts near each place, in the order of places.
        """
        # In cells from the corner; the centre of cell i is at i + 0.5.
        x, y = ((np.array(places, dtype=np.float64).reshape(-1, 2) - self._corner) / self._cell).T[:, :, None]
        limit = reach / self._cell + _ROUNDING
        rows = np.floor(x) + np.arange(-math.ceil(limit), math.ceil(limit) + 1)
        squared = limit * limit - (rows + 0.5 - x) ** 2
        half = np.sqrt(np.maximum(squared, 0.0))
        first = np.maximum(np.ceil(y - half - 0.5), 0.0)
        end = np.minimum(np.floor(y + half + 0.5), float(self._free.shape[1]))
        on_floor = (squared >= 0.0) & (first < end) & (rows >= 0.0) & (rows < self._free.shape[0])
        parts = np.stack((rows[on_floor], first[on_floor], end[on_floor])).astype(np.int64)
        return Bands(np.nonzero(on_floor)[0], *parts)

    def free_in(self, bands: Bands) -> Patch:
        """Find the free cells in some parts of rows, each once."""
        _, rows, first, end = bands
        if not rows.size:
            return Patch(slice(0, 0), slice(0, 0), np.zeros((0, 0), dtype=bool))
        top, left = int(rows.min()), int(first.min())
        patch_rows, patch_columns = slice(top, int(rows.max()) + 1), slice(left, int(end.max()))
        free = self._free[patch_rows, patch_columns]
        # One column more, where what reaches the last one ends.
        width = free.shape[1] + 1
        begin = (rows - top) * width - left
        cells = free.shape[0] * width
        steps = np.bincount(begin + first, minlength=cells) - np.bincount(begin + end, minlength=cells)
        return Patch(patch_rows, patch_columns, free & (steps.reshape(-1, width).cumsum(axis=1)[:, :-1] > 0))


def _centres(low: float, high: float, cell: float) -> NDArray[np.float64]:
    """List the centres of the cells from one wall to the other; a last one beyond the wall is none."""
    return np.asarray(np.arange(low + cell / 2.0, high, cell), dtype=np.float64)


def _within(centres: NDArray[np.float64], middle: float, reach: float) -> slice:
    """Find the centres that are at most so far from the middle of something [m]."""
    first, last = np.searchsorted(centres, (middle - reach, middle + reach))
    return slice(int(first), int(last) + 1)


def _inside(obstacle: Obstacle, x: NDArray[np.float64], y: NDArray[np.float64]) -> NDArray[np.bool_]:
    """Tell of points, in the frame ``map``, whether they lie in an obstacle, seen from above."""
    dx, dy = x - obstacle.pose.x, y - obstacle.pose.y
    length, width = obstacle.size[0], obstacle.size[1]
    if obstacle.shape == "cylinder":
        return np.asarray(dx * dx + dy * dy <= length * length / 4.0)
    cos, sin = math.cos(obstacle.pose.yaw), math.sin(obstacle.pose.yaw)
    along, across = cos * dx + sin * dy, cos * dy - sin * dx
    return np.asarray((abs(along) <= length / 2.0) & (abs(across) <= width / 2.0))
