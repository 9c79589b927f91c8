"""An occupancy grid: which cells of the floor a robot's centre may enter.

Cells are square and numbered row by row from the corner (min_x, min_y), in one flat array with a ring of blocked
cells around, so that a search need not look for the edge: cell ``row * width + column`` with ``width`` two more than
the floor has columns.
"""

from __future__ import annotations

import copy
import math
from typing import TYPE_CHECKING, Callable, Iterable, List, Optional, Sequence, Tuple

import numpy as np

from rqt_mrta_py.model import Arena, Obstacle, Pose

if TYPE_CHECKING:
    from numpy.typing import NDArray

__all__ = ["OccupancyGrid"]

_MOST_CELLS = 4_000_000


class OccupancyGrid:
    """The floor of an arena in cells; blocked are those nearer to a wall or obstacle than the clearance.

    Things known for good (walls, obstacles) and things passing by are held apart: the latter are replaced as a whole.

    Args:
        arena: the floor.
        clearance: least distance of a free cell's centre from walls and obstacles [m].
        passing_clearance: the same from passing things [m].
        resolution: edge of a cell [m]; shrunk a little where the arena is not a multiple.

    Raises:
        ValueError: the arena has no area, or would have more than four million cells; or a length is not above 0.
    """

    def __init__(self, arena: Arena, clearance: float, passing_clearance: float, resolution: float) -> None:
        length, breadth = arena.max_x - arena.min_x, arena.max_y - arena.min_y
        for name, value in (("length", length), ("breadth", breadth), ("resolution", resolution)):
            if not (math.isfinite(value) and value > 0.0):
                raise ValueError(f"a {name} of {value!r} m; it must be a finite number above 0")
        if (length / resolution) * (breadth / resolution) > _MOST_CELLS:
            raise ValueError(
                f"an arena of {length:g} m x {breadth:g} m in cells of {resolution:g} m; at most {_MOST_CELLS} cells "
                "are accepted: make the arena smaller, or the cells larger"
            )
        # Square cells: the longer side gets a whole number of them.
        columns = max(1, math.ceil(length / resolution - 1e-9))
        self.resolution = length / columns
        rows = max(1, math.ceil(breadth / self.resolution - 1e-9))
        self.width = columns + 2
        self.height = rows + 2
        self._min_x, self._min_y = arena.min_x, arena.min_y
        self._clearance = clearance
        self._passing_clearance = passing_clearance
        self._xs: NDArray[np.float64] = arena.min_x + (np.arange(columns, dtype=np.float64) + 0.5) * self.resolution
        self._ys: NDArray[np.float64] = arena.min_y + (np.arange(rows, dtype=np.float64) + 0.5) * self.resolution
        self._fixed: NDArray[np.bool_] = np.ones((self.height, self.width), dtype=np.bool_)
        near_x = (self._xs < arena.min_x + clearance) | (self._xs > arena.max_x - clearance)
        near_y = (self._ys < arena.min_y + clearance) | (self._ys > arena.max_y - clearance)
        self._fixed[1:-1, 1:-1] = near_y[:, None] | near_x[None, :]
        self._known_cells = self._fixed.tobytes()
        self._all_cells = self._known_cells

    @property
    def known(self) -> bytes:
        """One byte a cell, 1 where walls and obstacles block it."""
        return self._known_cells

    @property
    def blocked(self) -> bytes:
        """One byte a cell, 1 where walls, obstacles or passing things block it."""
        return self._all_cells

    def fork(self) -> OccupancyGrid:
        """Give a grid of the same floor that changes for itself; what neither changes is held once."""
        return copy.copy(self)

    def add_obstacles(self, obstacles: Iterable[Obstacle]) -> None:
        """Block what is nearer to fixed bodies than the clearance; forgets passing things."""
        self._fixed = self._fixed.copy()
        for obstacle in obstacles:
            self._block_obstacle(obstacle)
        self._known_cells = self._fixed.tobytes()
        self._all_cells = self._known_cells

    def set_passing(self, discs: Sequence[Tuple[Pose, float]]) -> None:
        """Replace the passing things: centre and radius [m] of each."""
        if not discs:
            self._all_cells = self._known_cells
            return
        cells = self._fixed.copy()
        for centre, radius in discs:
            self._block_disc(cells, centre, radius + self._passing_clearance)
        self._all_cells = cells.tobytes()

    def cell(self, x: float, y: float) -> Optional[int]:
        """Give the cell of a point in the frame ``map``; None outside the floor."""
        column = math.floor((x - self._min_x) / self.resolution)
        row = math.floor((y - self._min_y) / self.resolution)
        if 0 <= column < self.width - 2 and 0 <= row < self.height - 2:
            return (row + 1) * self.width + column + 1
        return None

    def centre(self, cell: int) -> Tuple[float, float]:
        """Give the centre of a cell in the frame ``map`` [m]."""
        row, column = divmod(cell, self.width)
        return (
            self._min_x + (column - 0.5) * self.resolution,
            self._min_y + (row - 0.5) * self.resolution,
        )

    def nearest_free(self, x: float, y: float, reach: float, blocked: bytes) -> Optional[int]:
        """Find the free cell to begin or end at: the point's own, or else the one whose centre is nearest.

        Args:
            x: of a point in the frame ``map`` [m].
            y: of the point [m].
            reach: how far the centre may be from the point [m].
            blocked: ``known`` or ``blocked``.

        Returns:
            The cell, of equal ones the lowest; None if there is none within reach.
        """
        own = self.cell(x, y)
        if own is not None and not blocked[own]:
            return own
        best: Optional[Tuple[float, int]] = None
        for row in _span(y - self._min_y, reach, self.resolution, self.height):
            for column in _span(x - self._min_x, reach, self.resolution, self.width):
                cell = row * self.width + column
                if not blocked[cell]:
                    centre_x, centre_y = self.centre(cell)
                    found = (math.hypot(centre_x - x, centre_y - y), cell)
                    if found[0] <= reach and (best is None or found < best):
                        best = found
        return best[1] if best else None

    def _block_obstacle(self, obstacle: Obstacle) -> None:
        length, width = obstacle.size[0], obstacle.size[1]
        if obstacle.shape == "cylinder":
            reach = length / 2.0 + self._clearance
            self._block_disc(self._fixed, obstacle.pose, reach)
        else:
            cos, sin = math.cos(obstacle.pose.yaw), math.sin(obstacle.pose.yaw)
            reach = math.hypot(length, width) / 2.0 + self._clearance

            def covered(dx: NDArray[np.float64], dy: NDArray[np.float64]) -> NDArray[np.bool_]:
                # A box along the axes, as maps are made of by the hundred, is a matter of its rows and its columns.
                along, aside = (dx, dy) if sin == 0.0 and cos == 1.0 else (cos * dx + sin * dy, cos * dy - sin * dx)
                beyond_x = np.maximum(np.abs(along) - length / 2.0, 0.0)
                beyond_y = np.maximum(np.abs(aside) - width / 2.0, 0.0)
                return np.asarray(
                    (beyond_x**2 + beyond_y**2 < self._clearance**2) | ((beyond_x == 0.0) & (beyond_y == 0.0)),
                    dtype=np.bool_,
                )

            self._block(self._fixed, obstacle.pose, reach, covered)

    def _block_disc(self, cells: NDArray[np.bool_], centre: Pose, reach: float) -> None:
        self._block(cells, centre, reach, lambda dx, dy: dx * dx + dy * dy < reach * reach)

    def _block(
        self,
        cells: NDArray[np.bool_],
        centre: Pose,
        reach: float,
        covered: Callable[[NDArray[np.float64], NDArray[np.float64]], NDArray[np.bool_]],
    ) -> None:
        first_column, last_column = np.searchsorted(self._xs, (centre.x - reach, centre.x + reach)).tolist()
        first_row, last_row = np.searchsorted(self._ys, (centre.y - reach, centre.y + reach)).tolist()
        dx = self._xs[first_column:last_column][None, :] - centre.x
        dy = self._ys[first_row:last_row][:, None] - centre.y
        window = cells[1 + first_row : 1 + last_row, 1 + first_column : 1 + last_column]
        window |= covered(dx, dy)


def _span(offset: float, reach: float, resolution: float, cells: int) -> List[int]:
    first = math.floor((offset - reach) / resolution) + 1
    last = math.floor((offset + reach) / resolution) + 1
    return list(range(max(1, first), min(cells - 2, last) + 1))
