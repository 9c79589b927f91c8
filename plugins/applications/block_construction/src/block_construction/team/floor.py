"""Where a robot has room: an arena with walls, placed blocks and supply places, and a lattice of nodes in it."""

from __future__ import annotations

import math
from functools import lru_cache
from typing import TYPE_CHECKING, FrozenSet, List, NamedTuple, Sequence, Tuple

import numpy as np

if TYPE_CHECKING:
    from numpy.typing import NDArray

__all__ = ["MOVES", "Floor", "Lattice", "Post"]

MOVES = ((0, 1), (0, -1), (1, 0), (-1, 0), (1, 1), (1, -1), (-1, 1), (-1, -1))
"""Steps between neighbouring nodes: rows and columns; the first four are straight."""

_CELL = 0.042
_SLACK = 1e-7
_SAMPLE = 0.01
"""How far apart places on a straight way are looked at [m]."""


class Post(NamedTuple):
    """A round thing on the floor.

    Attributes:
        x, y: its middle [m].
        radius: [m].
    """

    x: float
    y: float
    radius: float


class Lattice(NamedTuple):
    """Nodes in rows, with an edge of nodes around them where nobody can stand.

    Attributes:
        cell: between neighbours [m].
        width: nodes in a row, the edge included.
        places: of all nodes, row by row: array (nodes, 2) [m].
        inside: which nodes are not of the edge: array (nodes,).
    """

    cell: float
    width: int
    places: NDArray[np.float64]
    inside: NDArray[np.bool_]

    def step(self, move: int) -> int:
        """Tell by how much a move changes a node's index."""
        return MOVES[move][0] * self.width + MOVES[move][1]


class Floor:
    """An arena, and what a robot has to keep away from in it.

    Args:
        side: of the arena [m].
        site: left, bottom, right and top of the structure [m].
        radius: of the robot [m].
        pitch: of the structure's cells [m].
        posts: that robots drive around.
    """

    def __init__(
        self,
        side: float,
        site: Tuple[float, float, float, float],
        radius: float,
        pitch: float,
        posts: Sequence[Post] = (),
    ) -> None:
        self._side, self._site, self.radius, self._pitch = side, site, radius, pitch
        self._posts = np.array(posts, dtype=np.float64).reshape(-1, 3)
        self.lattice = _lattice(side, radius, site)
        self.free = lru_cache(maxsize=256)(self._free)
        """Which nodes can be stood on, by covered cells: array (nodes,)."""
        self.edges = lru_cache(maxsize=256)(self._edges)
        """Which moves can be made from which node, by covered cells: array (moves, nodes)."""

    def room(self, places: NDArray[np.float64], covered: FrozenSet[Tuple[int, int]]) -> NDArray[np.float64]:
        """Tell how far places lie from the nearest wall, block or post [m].

        Args:
            places: array (n, 2) [m].
            covered: columns and rows that blocks lie on, from 1.
        """
        x, y = places[:, 0], places[:, 1]
        room: NDArray[np.float64] = np.minimum.reduce([x, y, self._side - x, self._side - y])
        if covered:
            cells = np.array(sorted(covered), dtype=np.float64)
            left = self._site[0] + (cells[:, 0] - 1.0) * self._pitch
            bottom = self._site[1] + (cells[:, 1] - 1.0) * self._pitch
            dx = np.maximum(np.maximum(left - x[:, None], x[:, None] - left - self._pitch), 0.0)
            dy = np.maximum(np.maximum(bottom - y[:, None], y[:, None] - bottom - self._pitch), 0.0)
            room = np.minimum(room, np.hypot(dx, dy).min(axis=1))
        if len(self._posts):
            away = np.hypot(x[:, None] - self._posts[:, 0], y[:, None] - self._posts[:, 1]) - self._posts[:, 2]
            room = np.minimum(room, away.min(axis=1))
        return room

    def has_room(self, place: Tuple[float, float], covered: FrozenSet[Tuple[int, int]]) -> bool:
        """Tell whether a robot can stand at a place."""
        return float(self.room(np.array([place]), covered)[0]) >= self.radius - _SLACK

    def is_open(
        self, start: Tuple[float, float], goal: Tuple[float, float], covered: FrozenSet[Tuple[int, int]]
    ) -> bool:
        """Tell whether a robot can drive straight from one place to another.

        One that begins too near to something may go away from it.
        """
        count = max(2, math.ceil(math.dist(start, goal) / _SAMPLE) + 1)
        share = np.linspace(0.0, 1.0, count)[:, None]
        room = self.room(np.array([start]) * (1.0 - share) + np.array([goal]) * share, covered)
        return bool(np.all(room >= np.minimum(self.radius, np.maximum.accumulate(room)) - _SLACK))

    def near(self, place: Tuple[float, float], covered: FrozenSet[Tuple[int, int]]) -> List[int]:
        """List the free nodes around a place that can be driven to straight from there, and back; nearest first."""
        away = np.hypot(*(self.lattice.places - np.array(place)).T)
        found = np.flatnonzero(self.free(covered) & (away <= 1.5 * self.lattice.cell))
        nodes = sorted(found.tolist(), key=lambda node: (round(float(away[node]), 9), node))
        return [node for node in nodes if self.is_open(place, self.place_of(node), covered)]

    def place_of(self, node: int) -> Tuple[float, float]:
        """Tell where a node is [m]."""
        x, y = self.lattice.places[node].tolist()
        return x, y

    def _free(self, covered: FrozenSet[Tuple[int, int]]) -> NDArray[np.bool_]:
        free: NDArray[np.bool_] = self.room(self.lattice.places, covered) >= self.radius - _SLACK
        free &= self.lattice.inside
        free.setflags(write=False)
        return free

    def _edges(self, covered: FrozenSet[Tuple[int, int]]) -> NDArray[np.bool_]:
        free, lattice = self._free(covered), self.lattice
        edges = np.zeros((len(MOVES), len(free)), dtype=np.bool_)
        for move, (rows, columns) in enumerate(MOVES):
            # Cells are convex and small: ends and middle say enough.
            middle = lattice.places + np.array([columns, rows]) * (lattice.cell / 2.0)
            wide = self.room(middle, covered) >= self.radius - _SLACK
            edges[move] = free & np.roll(free, -lattice.step(move)) & wide
        edges.setflags(write=False)
        return edges


def _lattice(side: float, radius: float, site: Tuple[float, float, float, float]) -> Lattice:
    """Lay nodes from wall to wall so that the outermost lanes around the site lie as far apart as can be."""
    span, lane = side - 2.0 * radius, site[0] - 2.0 * radius
    least = max(2, round(span / _CELL) - 4)
    count = max(range(least, least + 9), key=lambda n: (round(math.floor(lane * n / span + 1e-9) * span / n, 9), n))
    cell, width = span / count, count + 3
    lines = radius + (np.arange(width) - 1) * cell
    columns, rows = np.meshgrid(lines, lines)
    inside = np.zeros((width, width), dtype=np.bool_)
    inside[1:-1, 1:-1] = True
    return Lattice(cell, width, np.stack([columns.ravel(), rows.ravel()], axis=1), inside.ravel())
