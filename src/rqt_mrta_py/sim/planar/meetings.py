"""Who is in whom: pairs that may meet are kept for some steps, and looked at closely in each."""

from __future__ import annotations

from typing import NamedTuple, Sequence

import numpy as np

from rqt_mrta_py.model import Arena, Obstacle
from rqt_mrta_py.sim.planar.cells import Cells, Floats, Rows
from rqt_mrta_py.sim.planar.crowd import Crowd
from rqt_mrta_py.sim.planar.footprints import Footprints, obstacle_footprints
from rqt_mrta_py.sim.planar.overlap import overlap

__all__ = ["FixedMeetings", "Meetings", "MovingMeetings"]

_FORESIGHT = 0.2
"""Pairs are kept that would meet if they came nearer by this; found anew once something has moved half of it [m]."""


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
            shapes = crowd.footprints
            widest = float(shapes.radius.max()) if shapes.radius.size else 0.0
            first, second = Cells(x, y).near(x, y, 2 * widest + _FORESIGHT)
            differ = (first < second) & (crowd.carrier[first] != crowd.carrier[second])
            kept.keep(crowd, shapes, crowd.poses, first[differ], second[differ])
        return _closely(crowd, crowd.footprints, crowd.poses, kept, least_depth)


class FixedMeetings:
    """Meetings of a crowd's things with obstacles and walls.

    The second of a meeting is the obstacle's number, or the number of obstacles for a wall.

    Args:
        crowd: what moves.
        arena: its walls.
        obstacles: in their order.

    Raises:
        SimError: an obstacle has a shape that cannot be built.
    """

    def __init__(self, crowd: Crowd, arena: Arena, obstacles: Sequence[Obstacle]) -> None:
        self._crowd = crowd
        self._arena = arena
        self.footprints = obstacle_footprints(obstacles)
        places = [(obstacle.pose.x, obstacle.pose.y, obstacle.pose.yaw) for obstacle in obstacles]
        self.poses: Floats = np.array(places, dtype=np.float64).reshape(-1, 3).transpose().copy()
        self._cells = Cells(self.poses[0], self.poses[1])
        self._kept = _Kept()

    def find(self, least_depth: float) -> Meetings:
        """Find all that overlap deeper than given [m], things in front of walls first."""
        crowd, kept = self._crowd, self._kept
        if kept.is_stale(crowd):
            x, y, _ = crowd.poses
            radii = (crowd.footprints.radius, self.footprints.radius)
            reach = sum(float(radius.max()) for radius in radii if radius.size) + _FORESIGHT
            kept.keep(crowd, self.footprints, self.poses, *self._cells.near(x, y, reach))
        with_walls = self._with_walls(least_depth)
        with_obstacles = _closely(crowd, self.footprints, self.poses, kept, least_depth)
        if not with_walls.first.size:
            return with_obstacles
        return Meetings(*(np.concatenate(fields, axis=-1) for fields in zip(with_walls, with_obstacles)))

    def _with_walls(self, least_depth: float) -> Meetings:
        """Find what reaches beyond the inner face of a wall, whatever lies behind that."""
        crowd, arena = self._crowd, self._arena
        x, y, yaw = crowd.poses
        shapes = crowd.footprints
        room = np.stack((x - arena.min_x, arena.max_x - x, y - arena.min_y, arena.max_y - y))
        is_near = (room < shapes.radius - least_depth) & (shapes.low < arena.wall_height)
        side, row = np.nonzero(is_near)
        edges = np.abs(shapes.turned(row, yaw[row])).sum(axis=1)
        depth = np.where(side < 2, edges[0], edges[1]) - room[side, row]
        is_in = depth > least_depth
        away = np.array(((1.0, -1.0, 0.0, 0.0), (0.0, 0.0, 1.0, -1.0)))[:, side[is_in]]
        return Meetings(row[is_in], np.full(int(is_in.sum()), self.poses.shape[1]), depth[is_in], away)


class _Kept:
    """Pairs that may meet, with what of them does not change."""

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
        return bool(((x * x + y * y) > (_FORESIGHT / 2) ** 2).any())

    def keep(self, crowd: Crowd, others: Footprints, poses: Floats, first: Rows, second: Rows) -> None:
        """Keep those of some pairs that may meet soon, in a defined order."""
        shapes = crowd.footprints
        x, y, _ = crowd.poses[:, first] - poses[:, second]
        radii = shapes.radius[first] + others.radius[second]
        may_meet = x * x + y * y < (radii + _FORESIGHT) ** 2
        may_meet &= (shapes.low[first] < others.high[second]) & (others.low[second] < shapes.high[first])
        first, second, radii = first[may_meet], second[may_meet], radii[may_meet]
        order = np.lexsort((second, first))
        self.first, self.second, self.radii = first[order], second[order], radii[order]
        self._poses = crowd.poses.copy()
        self._lineup = crowd.lineup


def _closely(crowd: Crowd, others: Footprints, poses: Floats, kept: _Kept, least_depth: float) -> Meetings:
    """Measure the pairs that were kept, things of a crowd and others."""
    x, y, _ = poses[:, kept.second] - crowd.poses[:, kept.first]
    is_near = x * x + y * y < (kept.radii - least_depth) ** 2
    first, second = kept.first[is_near], kept.second[is_near]
    if not first.size:
        return Meetings(first, second, np.empty(0), np.empty((2, 0)))
    depth, away = overlap(
        np.stack((x[is_near], y[is_near])),
        crowd.footprints.turned(first, crowd.poses[2, first]),
        others.turned(second, poses[2, second]),
        others.rounding[second],
    )
    is_in = depth > least_depth
    return Meetings(first[is_in], second[is_in], depth[is_in], away[:, is_in])
