"""Lengths of the shortest ways to one goal, computed as far as they are asked for, kept as far as a new map allows."""

from __future__ import annotations

import heapq
import math
from typing import TYPE_CHECKING, List, Tuple

import numpy as np

from rqt_mrta_py.robot.navigation.search import steps_in_cells

if TYPE_CHECKING:
    from numpy.typing import NDArray

__all__ = ["Distances"]


class Distances:
    """Dijkstra's algorithm from a goal over the free cells of a flat grid, which stops when it knows what was asked.

    Lengths do not hang on the order in which they are asked for.

    Args:
        blocked: one byte a cell, row by row, with a blocked ring; anything but 0 blocks.
        width: cells in a row.
        goal: a free cell.
    """

    def __init__(self, blocked: bytes, width: int, goal: int) -> None:
        self._blocked = blocked
        self._width = width
        self._goal = goal
        self._steps = steps_in_cells(width)
        self._lengths = [math.inf] * len(blocked)
        self._lengths[goal] = 0.0
        self._queue: List[Tuple[float, int]] = [(0.0, goal)]

    def to(self, cell: int) -> float:
        """Give the length of the shortest way between a cell and the goal, in cells; infinity where there is none."""
        lengths, queue = self._lengths, self._queue
        # What is not farther than the front of the search will not become nearer any more.
        if queue and lengths[cell] > queue[0][0]:
            self._search(cell)
        return lengths[cell]

    def on(self, blocked: bytes) -> Distances:
        """Give the lengths on a changed map; these stay as they are.

        Ways only lead on to what is farther from the goal. So every length below those of all changed cells stays,
        and the search goes on from there.

        Args:
            blocked: the new map, of the same size; the goal is free on it.
        """
        if blocked == self._blocked:
            return self
        after = Distances(blocked, self._width, self._goal)
        old_lengths, free = np.array(self._lengths, dtype=np.float64), np.frombuffer(blocked, dtype=np.uint8) == 0
        (changed,) = np.nonzero((np.frombuffer(self._blocked, dtype=np.uint8) == 0) != free)
        # Beyond its front this search knows upper bounds only.
        limit = self._queue[0][0] if self._queue else math.inf
        if changed.size:
            offsets = np.array([0, *(step[0] for step in self._steps)], dtype=np.intp)
            around = (changed[:, None] + offsets[None, :]).ravel()
            around = around[(around >= 0) & (around < free.size)]
            # A cell that was blocked has no length yet; it is farther than the nearest of its neighbours.
            limit = min(limit, float(old_lengths[around].min()))
        kept = old_lengths < limit
        if not kept.any():
            return after
        lengths = np.where(kept, old_lengths, math.inf)
        grid = kept.reshape(-1, self._width)
        inner = np.zeros_like(grid)
        inner[1:-1, 1:-1] = _all_around(grid | ~free.reshape(grid.shape))
        (edge,) = np.nonzero((grid & ~inner).ravel())
        after._lengths = lengths.tolist()
        after._queue = list(zip(lengths[edge].tolist(), edge.tolist()))
        heapq.heapify(after._queue)
        return after

    def _search(self, cell: int) -> None:
        blocked, lengths, queue, steps = self._blocked, self._lengths, self._queue, self._steps
        pop, push = heapq.heappop, heapq.heappush
        while queue and lengths[cell] > queue[0][0]:
            here, there = pop(queue)
            if here > lengths[there]:
                continue
            for offset, beside_one, beside_other, step in steps:
                neighbour = there + offset
                length = here + step
                if length >= lengths[neighbour]:
                    continue
                if blocked[neighbour] or blocked[there + beside_one] or blocked[there + beside_other]:
                    continue
                lengths[neighbour] = length
                push(queue, (length, neighbour))


def _all_around(cells: NDArray[np.bool_]) -> NDArray[np.bool_]:
    """Tell of each cell but those of the ring whether all eight around it are set."""
    rows, columns = cells.shape
    around = np.ones((rows - 2, columns - 2), dtype=np.bool_)
    for down in (0, 1, 2):
        for right in (0, 1, 2):
            if (down, right) != (1, 1):
                around &= cells[down : rows - 2 + down, right : columns - 2 + right]
    return around
