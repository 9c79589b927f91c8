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

_FORESIGHT = 0.3
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


_NO_MEETINGS = Meetings(np.empty(0, dtype=np.intp), np.empty(0, dtype=np.intp), np.empty(0), np.empty((2, 0)))


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
        self._by_walls: Rows = np.empty(0, dtype=np.intp)

    def find(self, least_depth: float) -> Meetings:
        """Find all that overlap deeper than given [m], things in front of walls first."""
        crowd, kept = self._crowd, self._kept
        if kept.is_stale(crowd):
            x, y, _ = crowd.poses
            reach = crowd.footprints.widest + self.obstacles.footprints.widest + _FORESIGHT
            kept.keep(crowd, self.obstacles, *self._cells.near(x, y, reach))
            self._by_walls = self._near_walls()
        with_obstacles = _closely(crowd, kept, self.obstacles, least_depth)
        with_walls = self._with_walls(least_depth)
        return _together(with_walls, with_obstacles)

    def _with_walls(self, least_depth: float) -> Meetings:
        """Find what reaches beyond the inner face of a wall, whatever lies behind that."""
        rows, things = self._by_walls, self._crowd.placed()
        if not rows.size:
            return _NO_MEETINGS
        off_centre = things.poses[:2, rows] - self._centre
        reach = np.abs(things.half_edges(rows)).sum(axis=1)
        depths = np.stack((-off_centre, off_centre), axis=1) + reach[:, None] - self._half_span[:, None]
        depths = depths.reshape(_OFF_WALLS.shape[1], -1)
        wall, near = np.nonzero(depths > least_depth)
        return Meetings(rows[near], self.obstacles.poses.shape[1] + wall, depths[wall, near], _OFF_WALLS[:, wall])

    def _near_walls(self) -> Rows:
        """Find what may meet walls soon."""
        shapes = self._crowd.footprints
        room = self._half_span - np.abs(self._crowd.poses[:2] - self._centre)
        is_near = room.min(axis=0) < shapes.radius + _FORESIGHT
        return np.flatnonzero(is_near & (shapes.low < self._wall_height - _LEVEL))


class _Kept:
    """Pairs of a crowd's things and others that may meet."""

    def __init__(self) -> None:
        self.first: Rows = np.empty(0, dtype=np.intp)
        self.second: Rows = np.empty(0, dtype=np.intp)
        self.radii: Floats = np.empty(0)
        self._places: Floats = np.empty((2, 0))
        self._lineup = -1

    def is_stale(self, crowd: Crowd) -> bool:
        """Tell whether something has moved far, or changed otherwise, since the pairs were found."""
        if self._lineup != crowd.lineup:
            return True
        way = crowd.poses[:2] - self._places
        way *= way
        return bool((way[0] + way[1]).max(initial=0.0) > (_FORESIGHT / 2) ** 2)

    def keep(self, crowd: Crowd, others: Placed, first: Rows, second: Rows) -> None:
        """Keep those of some pairs that may meet soon, in a defined order."""
        shapes, other_shapes = crowd.footprints, others.footprints
        x, y = crowd.poses[0][first] - others.poses[0][second], crowd.poses[1][first] - others.poses[1][second]
        radii = shapes.radius[first] + other_shapes.radius[second]
        may_meet = x * x + y * y < (radii + _FORESIGHT) ** 2
        may_meet &= shapes.low[first] < other_shapes.high[second] - _LEVEL
        may_meet &= other_shapes.low[second] < shapes.high[first] - _LEVEL
        first, second, radii = first[may_meet], second[may_meet], radii[may_meet]
        order = np.lexsort((second, first))
        self.first, self.second, self.radii = first[order], second[order], radii[order]
        self._places = crowd.poses[:2].copy()
        self._lineup = crowd.lineup


def _closely(crowd: Crowd, kept: _Kept, others: Placed, least_depth: float) -> Meetings:
    """Measure the pairs that were kept."""
    if not kept.first.size:
        return _NO_MEETINGS
    x = others.poses[0][kept.second] - crowd.poses[0][kept.first]
    y = others.poses[1][kept.second] - crowd.poses[1][kept.first]
    near = np.flatnonzero(x * x + y * y < (kept.radii - least_depth) ** 2)
    if not near.size:
        return _NO_MEETINGS
    first, second = kept.first[near], kept.second[near]
    apart = np.array((x[near], y[near]))
    rounding = others.footprints.rounding[second]
    depth, away = overlap(apart, crowd.placed().half_edges(first), others.half_edges(second), rounding)
    found = np.flatnonzero(depth > least_depth)
    return Meetings(first[found], second[found], depth[found], away[:, found])


def _together(one: Meetings, other: Meetings) -> Meetings:
    """Give both, one after the other."""
    if not one.first.size or not other.first.size:
        return one if one.first.size else other
    return Meetings(*(np.concatenate(fields, axis=-1) for fields in zip(one, other)))
