"""The free floor of an arena, as square cells, each of which counts as its centre."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, Iterable, Sequence, Tuple

import numpy as np

from rqt_mrta_py.model import Arena, Obstacle

if TYPE_CHECKING:
    from numpy.typing import NDArray

__all__ = ["CELL", "Floor"]

CELL = 0.25
"""Side of a cell [m]; as long as a small robot."""

_MOST_CELLS = 1_000_000


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
            free &= ~_inside(obstacle, x[:, None], y[None, :])
        self._free = free

    @property
    def free_cells(self) -> int:
        """How many cells are free floor."""
        return int(np.count_nonzero(self._free))

    def near(self, places: Iterable[Tuple[float, float]], reach: float) -> NDArray[np.bool_]:
        """Tell which free cells have their centre near one of some places.

        Args:
            places: x and y of each, in the arena's frame [m].
            reach: how far a centre may be from a place to count as near [m].

        Returns:
            Shape (cells along x, cells along y).
        """
        near = np.zeros(self._free.shape, dtype=bool)
        # In cells from the corner; the centre of cell i is at i + 0.5.
        at = (np.array(list(places), dtype=np.float64).reshape(-1, 2) - self._corner) / self._cell
        own = np.floor(at).astype(np.int64)
        limit = reach / self._cell
        farthest = math.ceil(limit)
        for dx in range(-farthest, farthest + 1):
            for dy in range(-farthest, farthest + 1):
                cells = own + (dx, dy)
                apart = cells + 0.5 - at
                reached = cells[(apart * apart).sum(axis=1) <= limit * limit]
                kept = reached[((reached >= 0) & (reached < near.shape)).all(axis=1)]
                near[kept[:, 0], kept[:, 1]] = True
        result: NDArray[np.bool_] = near & self._free
        return result


def _centres(low: float, high: float, cell: float) -> NDArray[np.float64]:
    """List the centres of the cells from one wall to the other; a last one beyond the wall is none."""
    return np.asarray(np.arange(low + cell / 2.0, high, cell), dtype=np.float64)


def _inside(obstacle: Obstacle, x: NDArray[np.float64], y: NDArray[np.float64]) -> NDArray[np.bool_]:
    """Tell of points, in the frame ``map``, whether they lie in an obstacle, seen from above."""
    dx, dy = x - obstacle.pose.x, y - obstacle.pose.y
    length, width = obstacle.size[0], obstacle.size[1]
    if obstacle.shape == "cylinder":
        return np.asarray(dx * dx + dy * dy <= length * length / 4.0)
    cos, sin = math.cos(obstacle.pose.yaw), math.sin(obstacle.pose.yaw)
    along, across = cos * dx + sin * dy, cos * dy - sin * dx
    return np.asarray((abs(along) <= length / 2.0) & (abs(across) <= width / 2.0))
