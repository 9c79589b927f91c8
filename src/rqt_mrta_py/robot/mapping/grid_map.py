"""A robot's own map: the floor in cells, of each of which it believes more or less that something stands there."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, Optional

import numpy as np

from rqt_mrta_py.model import Arena, Pose
from rqt_mrta_py.robot.mapping.inverse_sensor import InverseSensor, updated
from rqt_mrta_py.robot.mapping.ray_cells import ray_cells

if TYPE_CHECKING:
    from numpy.typing import NDArray

__all__ = ["GridMap"]

_MOST_CELLS = 1_000_000
_WALL_CELLS = 2
_CERTAIN = 0.7


class GridMap:
    """What a robot has seen of an arena of which it knows the walls.

    A cell counts as occupied once its log-odds are above 0.7 (a probability of 2/3), until they are below -0.7, so that
    cells at the rim of things, which some rays hit and others pass, do not flicker. Cells along the walls never count:
    what is met there is the wall. Whatever was seen, also a robot that stood there, is unlearnt when the cell is seen
    free again.

    Args:
        arena: the floor.
        resolution: edge of a cell [m]; larger where the arena would have more than a million.
        sensor: how much a look tells; None for the usual.
    """

    def __init__(self, arena: Arena, resolution: float = 0.05, sensor: Optional[InverseSensor] = None) -> None:
        length, breadth = arena.max_x - arena.min_x, arena.max_y - arena.min_y
        self.resolution = max(resolution, math.sqrt(length * breadth / _MOST_CELLS))
        self.min_x, self.min_y = arena.min_x, arena.min_y
        self._columns = max(1, math.ceil(length / self.resolution - 1e-9))
        self._rows = max(1, math.ceil(breadth / self.resolution - 1e-9))
        self._sensor = sensor or InverseSensor()
        self._odds: NDArray[np.float32] = np.zeros(self._rows * self._columns, dtype=np.float32)
        self._occupied: NDArray[np.bool_] = np.zeros(self._rows * self._columns, dtype=np.bool_)
        within = np.zeros((self._rows, self._columns), dtype=np.bool_)
        within[_WALL_CELLS:-_WALL_CELLS, _WALL_CELLS:-_WALL_CELLS] = True
        self._within: NDArray[np.bool_] = within.ravel()
        self.revision = 0

    @property
    def odds(self) -> NDArray[np.float32]:
        """Log-odds of being occupied, shape (rows, columns), from the corner (min_x, min_y)."""
        return self._odds.reshape(self._rows, self._columns)

    @property
    def occupied(self) -> NDArray[np.bool_]:
        """Which cells are taken to be occupied, shape (rows, columns); ``revision`` counts how often that changed."""
        return self._occupied.reshape(self._rows, self._columns)

    def look(self, place: Pose, bearings: NDArray[np.float64], ranges: NDArray[np.float64], reach: float) -> None:
        """Add what was seen from one place.

        Of one look each cell gets one piece of evidence: a hit if any ray ended in it, else that it was passed.

        Args:
            place: of the range finder, in the frame ``map``.
            bearings: of the rays, from the heading [rad], shape (rays,).
            ranges: to what each ray met [m], shape (rays,); infinity where it met nothing.
            reach: beyond this distance nothing is learnt [m].
        """
        if not ranges.size:
            return
        directions = place.yaw + bearings
        met = ranges <= reach
        x, y = (place.x - self.min_x) / self.resolution, (place.y - self.min_y) / self.resolution
        lengths = np.minimum(ranges, reach) / self.resolution
        passed = self._cells(*ray_cells(x, y, directions, lengths))
        far, turned = lengths[met], directions[met]
        hit = self._cells(
            np.floor(x + far * np.cos(turned)).astype(np.intp), np.floor(y + far * np.sin(turned)).astype(np.intp)
        )
        hit = np.unique(hit[self._within[hit]])
        seen = np.zeros(self._odds.size, dtype=np.bool_)
        seen[passed] = True
        seen[hit] = False
        self._learn(np.flatnonzero(seen), self._sensor.passed)
        self._learn(hit, self._sensor.hit)

    def _cells(self, columns: NDArray[np.intp], rows: NDArray[np.intp]) -> NDArray[np.intp]:
        """Number the cells that lie on the floor."""
        inside = (columns >= 0) & (columns < self._columns) & (rows >= 0) & (rows < self._rows)
        return rows[inside] * self._columns + columns[inside]

    def _learn(self, cells: NDArray[np.intp], evidence: float) -> None:
        odds = updated(self._odds[cells], evidence, self._sensor.lowest, self._sensor.highest)
        self._odds[cells] = odds
        before = self._occupied[cells]
        occupied = np.where(before, odds >= -_CERTAIN, odds > _CERTAIN)
        if not np.array_equal(occupied, before):
            self._occupied[cells] = occupied
            self.revision += 1
