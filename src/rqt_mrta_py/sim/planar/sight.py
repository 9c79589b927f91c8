"""What range finders would see: robots and loose bodies as their boxes, obstacles as they are, walls.

Thousands of robots with dozens of rays each would make millions of pairs of ray and thing; yet a thing fills a small
angle, so of all rays only those that go its way are tried.
"""

from __future__ import annotations

from typing import NamedTuple, Optional, Sequence, Tuple

import numpy as np

from rqt_mrta_py.model import Arena
from rqt_mrta_py.sim.planar.cells import Cells, Floats, Rows, counting
from rqt_mrta_py.sim.planar.crowd import Crowd
from rqt_mrta_py.sim.planar.footprints import Placed

__all__ = ["Sight"]

_FULL_TURN = 2 * np.pi
_BARELY = 1e-9
"""By how much an angle may be off by rounding [rad]."""
_AT_ONCE = 4_000_000
"""Rays, and pairs of a robot and a thing, looked at together, which bounds the memory."""
_PARALLEL = 1e-300
"""Stands for no component across a face, so that dividing by it gives a huge number and not none."""


class Sight:
    """Rays from the robots of a crowd.

    Args:
        crowd: who looks and is seen.
        sensor_heights: of the planes of the robots' range finders [m].
        arena: its walls.
        obstacles: where they are.
    """

    def __init__(self, crowd: Crowd, sensor_heights: Sequence[float], arena: Arena, obstacles: Placed) -> None:
        self._crowd = crowd
        self._heights: Floats = np.array(sensor_heights, dtype=np.float64)
        self._arena = arena
        self._obstacles = _Things(obstacles)
        self._crowd_now: Optional[_Things] = None
        self._lineup = -1

    def forget(self) -> None:
        """Look anew where everything is, for things have moved."""
        self._crowd_now = None

    def ranges(self, rows: Rows, bearings: Floats, max_range: float) -> Floats:
        """Measure distances from robots.

        Args:
            rows: of the robots.
            bearings: relative to their headings, the same for all [rad], shape (rays,).
            max_range: what lies farther is not seen [m].

        Returns:
            Distances [m], shape (rows, rays); infinity where nothing is seen.
        """
        crowd = self._crowd
        if self._crowd_now is None or self._lineup != crowd.lineup:
            self._crowd_now, self._lineup = _Things(crowd.placed()), crowd.lineup
        seen = np.full((rows.size, bearings.size), np.inf)
        if not bearings.size:
            return seen
        things = self._obstacles.count + self._crowd_now.count
        at_once = max(1, _AT_ONCE // (things + bearings.size))
        for first in range(0, rows.size, at_once):
            some, nearest = rows[first : first + at_once], seen[first : first + at_once]
            rays = _Rays(crowd.poses[:, some], self._heights[some], bearings, max_range)
            self._look_at_walls(rays, nearest)
            self._obstacles.look(rays, None, nearest)
            self._crowd_now.look(rays, some, nearest)
        seen[~(seen <= max_range)] = np.inf
        return seen

    def _look_at_walls(self, rays: _Rays, seen: Floats) -> None:
        """Measure to the inner faces of the walls, not over their tops."""
        arena = self._arena
        room = np.minimum(
            np.minimum(rays.x - arena.min_x, arena.max_x - rays.x),
            np.minimum(rays.y - arena.min_y, arena.max_y - rays.y),
        )
        near = np.flatnonzero((room <= rays.max_range) & (rays.heights <= arena.wall_height))
        directions = rays.directions[near]
        far = np.full(directions.shape, np.inf)
        for place, ahead, low, high in (
            (rays.x[near], np.cos(directions), arena.min_x, arena.max_x),
            (rays.y[near], np.sin(directions), arena.min_y, arena.max_y),
        ):
            ahead[ahead == 0.0] = _PARALLEL
            face = np.where(ahead > 0.0, (high - place)[:, None], (low - place)[:, None])
            with np.errstate(over="ignore"):
                np.minimum(far, face / ahead, out=far)
        seen[near] = far


class _Rays:
    """Rays of robots, sorted by bearing so that those into a range of bearings lie side by side.

    Attributes:
        x, y: where they begin [m], shape (robots,).
        yaw: headings of the robots [rad], shape (robots,).
        heights: of the rays [m], shape (robots,).
        directions: [rad] in the frame ``map``, shape (robots, rays).
        max_range: how far they go [m].
        count: of each robot.
    """

    def __init__(self, poses: Floats, heights: Floats, bearings: Floats, max_range: float) -> None:
        self.x, self.y, self.yaw = poses
        self.heights = heights
        self.directions: Floats = self.yaw[:, None] + bearings
        self.max_range = max_range
        self.count = bearings.size
        turns = np.mod(bearings, _FULL_TURN)
        self._order: Rows = np.argsort(turns, kind="stable")
        sorted_turns = turns[self._order]
        self._twice = np.concatenate((sorted_turns, sorted_turns + _FULL_TURN))

    def towards(self, bearing: Floats, half_angle: Floats) -> Tuple[Rows, Rows]:
        """Find the rays that go into ranges of bearings.

        Args:
            bearing: the middle of each [rad], shape (ranges,).
            half_angle: from its middle to its ends, up to pi [rad], shape (ranges,).

        Returns:
            Rows of ranges and of rays, by range.
        """
        low = np.mod(bearing - half_angle - _BARELY, _FULL_TURN)
        begins = np.searchsorted(self._twice, low)
        counts = np.searchsorted(self._twice, low + (2 * half_angle + 2 * _BARELY), side="right") - begins
        counts = np.minimum(counts, self._order.size)
        which = np.repeat(begins, counts) + counting(counts)
        return np.repeat(np.arange(counts.size), counts), self._order[which % self._order.size]


class _Tries(NamedTuple):
    """Rays that go the way of a thing, one an element of every array.

    Attributes:
        cell: of the ray, among those of all robots, robot by robot.
        thing: its row.
        x, y: of its centre from where the ray begins [m].
        direction: of the ray in the frame ``map`` [rad].
    """

    cell: Rows
    thing: Rows
    x: Floats
    y: Floats
    direction: Floats


class _Things:
    """Things that can be seen, where they are now.

    Attributes:
        count: how many.
    """

    def __init__(self, placed: Placed) -> None:
        self._footprints, self._poses, _ = placed
        self._headings: Floats = np.array((np.cos(self._poses[2]), np.sin(self._poses[2])))
        self._is_disc = self._footprints.rounding > 0.0
        self._cells = Cells(self._poses[0], self._poses[1])
        self.count = self._poses.shape[1]

    def look(self, rays: _Rays, own: Optional[Rows], seen: Floats) -> None:
        """Shorten distances to those of things that are nearer.

        Args:
            rays: to follow.
            own: for each robot, which of the things it is itself; None if they are none of them.
            seen: distances, changed in place [m], shape (robots, rays).
        """
        shapes, poses = self._footprints, self._poses
        robot, thing = self._cells.near(rays.x, rays.y, rays.max_range + shapes.widest)
        x, y = poses[0][thing] - rays.x[robot], poses[1][thing] - rays.y[robot]
        reach_squared = (rays.max_range + shapes.radius) ** 2
        near = np.flatnonzero(x * x + y * y <= reach_squared[thing])
        robot, thing = robot[near], thing[near]
        height = rays.heights[robot]
        is_level = (shapes.low[thing] <= height) & (height <= shapes.high[thing])
        if own is not None:
            is_level &= own[robot] != thing
        level = np.flatnonzero(is_level)
        robot, thing, near = robot[level], thing[level], near[level]
        x, y = x[near], y[near]
        bearing = np.arctan2(y, x) - rays.yaw[robot]
        distance, radius = np.hypot(x, y), shapes.radius[thing]
        is_beside = distance > radius
        half_angle = np.where(is_beside, np.arcsin(radius / np.where(is_beside, distance, radius)), np.pi)
        pair, ray = rays.towards(bearing, half_angle)
        robot, thing, x, y = robot[pair], thing[pair], x[pair], y[pair]
        cell = robot * rays.count + ray
        tries = _Tries(cell, thing, x, y, rays.directions.reshape(-1)[cell])
        nearest = seen.reshape(-1)
        if not self._is_disc.any():
            np.minimum.at(nearest, cell, self._to_boxes(tries))
            return
        is_disc = self._is_disc[thing]
        for chosen, measure in ((~is_disc, self._to_boxes), (is_disc, self._to_discs)):
            some = _Tries(cell[chosen], thing[chosen], x[chosen], y[chosen], tries.direction[chosen])
            np.minimum.at(nearest, some.cell, measure(some))

    def _to_boxes(self, tries: _Tries) -> Floats:
        """Measure along rays to boxes; infinity for a miss [m]."""
        _, thing, x, y, direction = tries
        cos, sin = self._headings[:, thing]
        centre = np.array((cos * x + sin * y, cos * y - sin * x))
        turned = direction - self._poses[2, thing]
        ahead = np.array((np.cos(turned), np.sin(turned)))
        ahead[ahead == 0.0] = _PARALLEL
        # Where a ray goes from the side of the lower coordinates to the higher, it enters by the lower face.
        ahead_half = np.copysign(self._footprints.half_size[:, thing], ahead)
        with np.errstate(over="ignore"):
            enters = np.maximum(*((centre - ahead_half) / ahead))
            leaves = np.minimum(*((centre + ahead_half) / ahead))
        return np.where((enters <= leaves) & (enters >= 0.0), enters, np.inf)

    def _to_discs(self, tries: _Tries) -> Floats:
        """Measure along rays to discs; infinity for a miss [m]."""
        _, thing, x, y, direction = tries
        cos, sin, radius = np.cos(direction), np.sin(direction), self._footprints.rounding[thing]
        along, across = cos * x + sin * y, cos * y - sin * x
        half_chord_squared = radius * radius - across * across
        enters = along - np.sqrt(np.maximum(half_chord_squared, 0.0))
        return np.where((half_chord_squared >= 0.0) & (enters >= 0.0), enters, np.inf)
