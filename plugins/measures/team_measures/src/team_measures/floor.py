"""The free floor of an arena, as square cells, each of which counts as its centre."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, Sequence, Tuple

import numpy as np

from rqt_mrta_py.model import Arena, Obstacle

if TYPE_CHECKING:
    from numpy.typing import NDArray

__all__ = ["CELL", "Floor"]

CELL = 0.25
"""Side of a cell [m]; as long as a small robot."""

_MOST_CELLS = 1_000_000

_MOST_PLACES = 10_000
"""How many are looked at together; each has some eighty cells around it."""

_NONE: NDArray[np.int64] = np.empty(0, dtype=np.int64)


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
    def free_cells(self) -> int:
        """How many cells are free floor."""
        return int(np.count_nonzero(self._free))

    def near(self, places: Sequence[Tuple[float, float]], reach: float) -> Tuple[NDArray[np.int64], NDArray[np.int64]]:
        """Find the free cells whose centres are near some places.

        Args:
            places: x and y of each, in the arena's frame [m].
            reach: how far a centre may be from a place to count as near [m].

        Returns:
            Pairs of a place and a cell near it, as two arrays: the places' indices, rising, and the cells' numbers.
        """
        # In cells from the corner; the centre of cell i is at i + 0.5.
        at = (np.array(places, dtype=np.float64).reshape(-1, 2) - self._corner) / self._cell
        limit = reach / self._cell
        around = _cells_around(limit)
        pairs = [
            self._near(at[first : first + _MOST_PLACES], first, around, limit)
            for first in range(0, len(at), _MOST_PLACES)
        ]
        which, numbers = zip(*pairs) if pairs else ((_NONE,), (_NONE,))
        return np.concatenate(which), np.concatenate(numbers)

    def _near(
        self, at: NDArray[np.float64], first: int, around: NDArray[np.int64], limit: float
    ) -> Tuple[NDArray[np.int64], NDArray[np.int64]]:
        cells = np.floor(at).astype(np.int64)[:, None] + around
        apart = cells + 0.5 - at[:, None]
        is_near = (apart * apart).sum(axis=2) <= limit * limit
        is_near &= ((cells >= 0) & (cells < self._free.shape)).all(axis=2)
        which = np.nonzero(is_near)[0]
        numbers = np.ravel_multi_index(tuple(cells[is_near].T), self._free.shape)
        is_free = self._free.reshape(-1)[numbers]
        return first + which[is_free], numbers[is_free]


def _cells_around(limit: float) -> NDArray[np.int64]:
    """List the cells that may be near a place in the middle one, by their distance in cells along x and y."""
    steps = np.arange(-math.ceil(limit), math.ceil(limit) + 1)
    return np.stack(np.meshgrid(steps, steps, indexing="ij"), axis=-1).reshape(-1, 2)


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
