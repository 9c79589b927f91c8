"""Lengths of ways in the arena, among blocks that are placed one after another.

Only what stands on the floor is in the way, and upper levels lie on it: lengths depend on the set of cells that are
covered, and one map from each supply place serves all ways to and from it. Maps are kept by that set.
"""

from __future__ import annotations

from functools import lru_cache
from typing import TYPE_CHECKING, Any, Dict, List, NamedTuple, Sequence, Tuple

import numpy as np

from block_construction.diagram.block_set import PITCH
from block_construction.execution.arena import Arena, Point, Site
from rqt_mrta_py.hooks import MissingDependencyError

if TYPE_CHECKING:
    from numpy.typing import NDArray

__all__ = ["Ground", "Ways"]

_MOST_KEPT = 1 << 16
_SLACK = 1e-9


class _Edges(NamedTuple):
    """Moves between neighbouring cells of the grid, sorted by the cell they start from.

    Attributes:
        start, end: indices of cells.
        beside: the two cells that a diagonal move passes; twice the end for a straight one.
        length: [m].
    """

    start: NDArray[np.int64]
    end: NDArray[np.int64]
    beside: NDArray[np.int64]
    length: NDArray[np.float64]


def _edges(count: int, cell: float) -> _Edges:
    index = np.arange(count * count).reshape(count, count)
    parts: List[NDArray[np.int64]] = []
    lengths: List[NDArray[np.float64]] = []
    for dy, dx in ((-1, -1), (-1, 0), (-1, 1), (0, -1), (0, 1), (1, -1), (1, 0), (1, 1)):
        rows = slice(max(0, -dy), count - max(0, dy))
        columns = slice(max(0, -dx), count - max(0, dx))
        start = index[rows, columns].ravel()
        end = start + dy * count + dx
        straight = not (dx and dy)
        sides = (end, end) if straight else (start + dx, start + dy * count)
        parts.append(np.stack([start, end, *sides]))
        lengths.append(np.full(len(start), cell if straight else cell * np.sqrt(2.0)))
    joined, length = np.concatenate(parts, axis=1), np.concatenate(lengths)
    order = np.argsort(joined[0], kind="stable")
    joined = joined[:, order]
    return _Edges(joined[0], joined[1], joined[2:], length[order])


class Ground:
    """The arena's floor as a grid of cells, of which placed blocks close some.

    Args:
        arena: measures and grid.
        site: where the structure stands.
        columns: of the structure; a column and row of it is a bit of a set of covered cells.
    """

    def __init__(self, arena: Arena, site: Site, columns: int) -> None:
        self._arena = arena
        self._site = site
        self._columns = columns
        self.count = int(arena.side / arena.cell + _SLACK)
        self._middles = (np.arange(self.count) + 0.5) * arena.cell
        inside = (self._middles >= arena.robot_radius - _SLACK) & (
            self._middles <= arena.side - arena.robot_radius + _SLACK
        )
        self._open = inside[:, None] & inside[None, :]
        self._around: Dict[int, NDArray[np.bool_]] = {}

    def cell_of(self, point: Point) -> int:
        """Give the cell whose middle is nearest to a point; of two as near, the one farther from the arena's middle."""
        column, row = (self._along(value) for value in point)
        return row * self.count + column

    def point_of(self, cell: int) -> Point:
        """Give the middle of a cell [m]."""
        row, column = divmod(cell, self.count)
        return Point(float(self._middles[column]), float(self._middles[row]))

    def free(self, covered: int) -> NDArray[np.bool_]:
        """Give the cells where the robot can stand, by index.

        Args:
            covered: columns and rows of the structure that blocks lie on, bit by bit: (y - 1) * columns + x - 1.
        """
        free = self._open.copy()
        bit = 0
        while covered >> bit:
            if covered >> bit & 1:
                free &= ~self._near(bit)
            bit += 1
        return free.ravel()

    def _along(self, value: float) -> int:
        exact = value / self._arena.cell - 0.5
        lower = int(np.floor(exact + _SLACK))
        beyond = exact - lower
        up = value > self._arena.side / 2.0 if abs(beyond - 0.5) < 1e-6 else beyond > 0.5
        return min(max(lower + up, 0), self.count - 1)

    def _near(self, bit: int) -> NDArray[np.bool_]:
        """Give the cells that are too near to one covered cell of the structure."""
        if bit not in self._around:
            row, column = divmod(bit, self._columns)
            left, bottom = self._site.left + column * PITCH, self._site.bottom + row * PITCH
            dx = np.maximum(np.maximum(left - self._middles, self._middles - left - PITCH), 0.0)
            dy = np.maximum(np.maximum(bottom - self._middles, self._middles - bottom - PITCH), 0.0)
            self._around[bit] = np.hypot(dx[None, :], dy[:, None]) < self._arena.robot_radius - _SLACK
        return self._around[bit]


class Ways:
    """Shortest ways on the grid between supply places and everything else, by Dijkstra's algorithm.

    Args:
        ground: the grid.
        sources: stands of supply places [m].
        goals: where ways end or begin otherwise [m].

    Raises:
        MissingDependencyError: SciPy is not installed.
    """

    def __init__(self, ground: Ground, cell: float, sources: Sequence[Point], goals: Sequence[Point]) -> None:
        try:
            from scipy.sparse import csgraph, csr_array
        except ImportError as error:
            raise MissingDependencyError("ways in the arena: SciPy is not installed; install scipy") from error
        self._dijkstra: Any = csgraph.dijkstra
        self._matrix: Any = csr_array
        self.ground = ground
        self._edges = _edges(ground.count, cell)
        self._sources = np.array([ground.cell_of(each) for each in sources], dtype=np.int64)
        self._goals = np.array([ground.cell_of(each) for each in goals], dtype=np.int64)
        self.lengths = lru_cache(maxsize=_MOST_KEPT)(self._lengths)
        """Of ways by covered cells: array (sources, goals) [m]; infinite where there is none; not to be changed."""

    def path(self, covered: int, source: int, goal: int) -> Tuple[Point, ...]:
        """Give the points of a shortest way, from a source to a goal; empty if there is none.

        Args:
            covered: cells of the structure, as for ``Ground.free``.
            source: its index.
            goal: its index.
        """
        graph = self._graph(covered)
        _, before = self._dijkstra(graph, indices=[int(self._sources[source])], return_predecessors=True)
        cell, first = int(self._goals[goal]), int(self._sources[source])
        cells = [cell]
        while cell != first:
            cell = int(before[0, cell])
            if cell < 0:
                return ()
            cells.append(cell)
        return tuple(self.ground.point_of(each) for each in reversed(cells))

    def _lengths(self, covered: int) -> NDArray[np.float64]:
        free = self.ground.free(covered)
        found: NDArray[np.float64] = self._dijkstra(self._graph(covered), indices=self._sources)[:, self._goals]
        # A closed cell has no edges, but it is 0 m away from itself.
        found[~free[self._sources]] = np.inf
        found[:, ~free[self._goals]] = np.inf
        found.setflags(write=False)
        return found

    def _graph(self, covered: int) -> Any:
        free, edges, size = self.ground.free(covered), self._edges, self.ground.count**2
        kept = free[edges.start] & free[edges.end] & free[edges.beside].all(axis=0)
        pointers = np.concatenate([[0], np.cumsum(np.bincount(edges.start[kept], minlength=size))])
        return self._matrix((edges.length[kept], edges.end[kept], pointers), shape=(size, size))
