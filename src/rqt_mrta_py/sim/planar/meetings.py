"""Who is in whom: pairs that may meet are kept for some steps, and looked at closely in each."""

from __future__ import annotations

from typing import NamedTuple, Sequence

import numpy as np

from rqt_mrta_py.model import Arena, Obstacle
from rqt_mrta_py.sim.planar.cells import Cells, Floats, Rows
from rqt_mrta_py.sim.planar.crowd import Crowd
from rqt_mrta_py.sim.planar.footprints import Placed, placed_obstacles
from rqt_mrta_py.sim.planar.overlap import overlap

__all__ = ["FixedMeetings", "Meetings", "MovingMeetings"]

_FORESIGHT = 0.2
"""Pairs are kept that would meet if they came nearer by this; found anew once something has moved half of it [m]."""

_LEVEL = 1e-6
"""What overlaps less in height lies on top of the other [m]."""

_OFF_WALLS: Floats = np.array([[1.0, -1.0, 0.0, 0.0], [0.0, 0.0, 1.0, -1.0]])
"""Unit vectors away from the four walls, in their order."""


class Meetings(NamedTuple):
    """Pairs that overlap, or nearly so.

    Attributes:
        first, second: the two; what these numbers count says who gives them; shape (pairs,).
        depth: of the overlap, negative for a gap [m], shape (pairs,).
        away: unit vectors along which the first comes apart from the second, shape (2, pairs).
    """

    first: Rows
    second: Rows
    depth: Floats
    away: Floats


class MovingMeetings:
    """Meetings of things in a crowd, both numbered by their columns there."""

    def __init__(self, crowd: Crowd) -> None:
        self._crowd = crowd
        self._kept = _Kept()

    def find(self, least_depth: float) -> Meetings:
        """Find all that overlap deeper than given [m]; a robot and what it carries do not meet one another."""
        crowd, kept = self._crowd, self._kept
        if kept.is_stale(crowd):
            x, y, _ = crowd.poses
            first, second = Cells(x, y).near(x, y, 2 * crowd.footprints.widest + _FORESIGHT)
            differ = (first < second) & (crowd.carrier[first] != crowd.carrier[second])
            kept.keep(crowd, crowd.placed(), first[differ], second[differ])
        return _closely(crowd, kept, crowd.placed(), least_depth)


class FixedMeetings:
    """Meetings of a crowd's things with obstacles and walls.

    The second of a meeting is the obstacle's number; the walls count on from there, at the least x, the greatest x, the
    least y and the greatest y.

    Attributes:
        obstacles: where they are.
        count: of obstacles and walls.

    Args:
        crowd: what moves.
        arena: its walls.
        obstacles: in their order.

    Raises:
        SimError: an obstacle has a shape that cannot be built.
    """

    def __init__(self, crowd: Crowd, arena: Arena, obstacles: Sequence[Obstacle]) -> None:
        self._crowd = crowd
        self._wall_height = arena.wall_height
        low, high = np.array([[arena.min_x, arena.min_y], [arena.max_x, arena.max_y]])[:, :, None]
        self._centre: Floats = (low + high) / 2
        self._half_span: Floats = (high - low) / 2
        self.obstacles: Placed = placed_obstacles(obstacles)
        self.count = len(obstacles) + _OFF_WALLS.shape[1]
        self._cells = Cells(self.obstacles.poses[0], self.obstacles.poses[1])
        self._kept = _Kept()

    def find(self, least_depth: float) -> Meetings:
        """Find all that overlap deeper than given [m], things in front of walls first."""
        crowd, kept = self._crowd, self._kept
        if kept.is_stale(crowd):
            x, y, _ = crowd.poses
            reach = crowd.footprints.widest + self.obstacles.footprints.widest + _FORESIGHT
            kept.keep(crowd, self.obstacles, *self._cells.near(x, y, reach))
        with_obstacles = _closely(crowd, kept, self.obstacles, least_depth)
        with_walls = self._with_walls(least_depth)
        return _together(with_walls, with_obstacles)

    def _with_walls(self, least_depth: float) -> Meetings:
        """Find what reaches beyond the inner face of a wall, whatever lies behind that."""
        crowd = self._crowd
        is_low = crowd.footprints.low < self._wall_height - _LEVEL
        off_centre = crowd.poses[:2] - self._centre
        reach = np.abs(crowd.half_edges).sum(axis=1)
        depths = np.stack((-off_centre, off_centre), axis=1) + reach[:, None] - self._half_span[:, None]
        depths = depths.reshape(_OFF_WALLS.shape[1], -1)
        wall, row = np.nonzero((depths > least_depth) & is_low)
        return Meetings(row, self.obstacles.poses.shape[1] + wall, depths[wall, row], _OFF_WALLS[:, wall])


class _Kept:
    """Pairs of a crowd's things and others that may meet."""

    def __init__(self) -> None:
        self.first: Rows = np.empty(0, dtype=np.intp)
        self.second: Rows = np.empty(0, dtype=np.intp)
        self.radii: Floats = np.empty(0)
        self._poses: Floats = np.empty((3, 0))
        self._lineup = -1

    def is_stale(self, crowd: Crowd) -> bool:
        """Tell whether something has moved far, or changed otherwise, since the pairs were found."""
        if self._lineup != crowd.lineup:
            return True
        x, y, _ = crowd.poses - self._poses
        return bool((x * x + y * y > (_FORESIGHT / 2) ** 2).any())

    def keep(self, crowd: Crowd, others: Placed, first: Rows, second: Rows) -> None:
        """Keep those of some pairs that may meet soon, in a defined order."""
        shapes, other_shapes = crowd.footprints, others.footprints
        x, y, _ = crowd.poses[:, first] - others.poses[:, second]
        radii = shapes.radius[first] + other_shapes.radius[second]
        may_meet = x * x + y * y < (radii + _FORESIGHT) ** 2
        may_meet &= shapes.low[first] < other_shapes.high[second] - _LEVEL
        may_meet &= other_shapes.low[second] < shapes.high[first] - _LEVEL
        first, second, radii = first[may_meet], second[may_meet], radii[may_meet]
        order = np.lexsort((second, first))
        self.first, self.second, self.radii = first[order], second[order], radii[order]
        self._poses = crowd.poses.copy()
        self._lineup = crowd.lineup


def _closely(crowd: Crowd, kept: _Kept, others: Placed, least_depth: float) -> Meetings:
    """Measure the pairs that were kept."""
    x, y, _ = others.poses[:, kept.second] - crowd.poses[:, kept.first]
    near = np.flatnonzero(x * x + y * y < (kept.radii - least_depth) ** 2)
    first, second = kept.first[near], kept.second[near]
    if not near.size:
        return Meetings(first, second, np.empty(0), np.empty((2, 0)))
    apart = np.stack((x[near], y[near]))
    rounding = others.footprints.rounding[second]
    depth, away = overlap(apart, crowd.half_edges[:, :, first], others.half_edges[:, :, second], rounding)
    found = np.flatnonzero(depth > least_depth)
    return Meetings(first[found], second[found], depth[found], away[:, found])


def _together(one: Meetings, other: Meetings) -> Meetings:
    """Give both, one after the other."""
    if not one.first.size or not other.first.size:
        return one if one.first.size else other
    return Meetings(*(np.concatenate(fields, axis=-1) for fields in zip(one, other)))
