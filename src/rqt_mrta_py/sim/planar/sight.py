"""What range finders would see: robots and loose bodies as their boxes, obstacles as they are, walls.

Thousands of robots with dozens of rays each would make millions of pairs of ray and thing; yet a thing fills a small
angle, so of all rays only those that go its way are tried.
"""

from __future__ import annotations

from typing import Dict, NamedTuple, Sequence, Tuple

import numpy as np
from numpy.typing import NDArray

from rqt_mrta_py.model import Arena
from rqt_mrta_py.sim.planar.cells import Floats, Rows
from rqt_mrta_py.sim.planar.crowd import Crowd
from rqt_mrta_py.sim.planar.fan import Fan
from rqt_mrta_py.sim.planar.footprints import Placed
from rqt_mrta_py.sim.planar.nearby import Nearby
from rqt_mrta_py.sim.planar.visible import Visible

__all__ = ["Sight"]

_FULL_TURN = 2 * np.pi
_AT_ONCE = 4_000_000
"""Rays, and pairs of a robot and a thing, looked at together, which bounds the memory."""
_MOST_FANS = 16
_PARALLEL = 1e-300
"""Stands for no component across a face, so that dividing by it gives a huge number and not none."""
_TOWARDS_WALLS: Floats = np.array([np.pi, 0.0, -np.pi / 2, np.pi / 2])
"""Directions to the walls at the least x, the greatest x, the least y and the greatest y, frame ``map`` [rad]."""
_SIGNS: Floats = np.array([-1.0, 1.0, -1.0, 1.0])
"""Of the coordinates that grow towards them."""


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
        self._visible = Visible(crowd, obstacles)
        self._nearby = Nearby(self._visible, self._heights)
        self._fans: Dict[bytes, Fan] = {}

    def forget(self) -> None:
        """Look anew where everything is, for things have moved."""
        self._visible.forget()

    def ranges(self, rows: Rows, bearings: Floats, max_range: float) -> Floats:
        """Measure distances from robots.

        Args:
            rows: of the robots.
            bearings: relative to their headings, the same for all [rad], shape (rays,).
            max_range: what lies farther is not seen [m].

        Returns:
            Distances [m], shape (rows, rays); infinity where nothing is seen.
        """
        seen = np.full((rows.size, bearings.size), np.inf)
        if not bearings.size:
            return seen
        self._visible.look_again()
        fan = self._fan(bearings)
        at_once = max(1, _AT_ONCE // (self._visible.poses.shape[1] + bearings.size))
        for first in range(0, rows.size, at_once):
            some, nearest = rows[first : first + at_once], seen[first : first + at_once].reshape(-1)
            rays = _Rays(self._crowd.poses[:, some], fan, max_range)
            self._look_at_walls(rays, self._heights[some], nearest)
            self._look_at_things(rays, some, nearest)
        return seen

    def _fan(self, bearings: Floats) -> Fan:
        key = bearings.tobytes()
        if key not in self._fans:
            if len(self._fans) >= _MOST_FANS:
                self._fans.clear()
            self._fans[key] = Fan(bearings.copy())
        return self._fans[key]

    def _look_at_walls(self, rays: _Rays, heights: Floats, seen: Floats) -> None:
        """Measure to the inner faces of the walls, not over their tops."""
        arena = self._arena
        rooms = np.array((rays.x - arena.min_x, arena.max_x - rays.x, rays.y - arena.min_y, arena.max_y - rays.y))
        wall, robot = np.nonzero((rooms <= rays.max_range) & (heights <= arena.wall_height))
        room = rooms[wall, robot]
        half_angle = np.arccos(np.maximum(room, 0.0) / rays.max_range)
        which, cell, direction = rays.towards(robot, _TOWARDS_WALLS[wall], half_angle)
        wall, room = wall[which], room[which]
        # The walls come in their order: first those across x, then those across y.
        along_y = int(np.searchsorted(wall, 2))
        ahead = np.concatenate((np.cos(direction[:along_y]), np.sin(direction[along_y:]))) * _SIGNS[wall]
        is_ahead = ahead > 0.0
        with np.errstate(over="ignore"):
            rays.see(seen, cell, np.divide(room, ahead, out=room, where=is_ahead), is_ahead)

    def _look_at_things(self, rays: _Rays, rows: Rows, seen: Floats) -> None:
        """Measure to obstacles, robots and loose bodies."""
        visible, pairs = self._visible, self._nearby.pairs(rows, rays.max_range)
        x = visible.poses[0][pairs.thing] - rays.x[pairs.robot]
        y = visible.poses[1][pairs.thing] - rays.y[pairs.robot]
        squared = x * x + y * y
        near = np.flatnonzero(squared <= pairs.reach_squared)
        x, y, radius, thing = x[near], y[near], pairs.radius[near], pairs.thing[near]
        distance = np.sqrt(squared[near])
        half_angle = np.arcsin(radius / np.maximum(distance, radius))
        half_angle[distance <= radius] = np.pi
        which, cell, direction = rays.towards(pairs.robot[near], np.arctan2(y, x), half_angle)
        tries = _Tries(thing[which], x[which], y[which], direction)
        rounding = visible.shapes.rounding
        if not rounding.any():
            rays.see(seen, cell, *_to_boxes(visible, tries))
            return
        is_disc = rounding[tries.thing] > 0.0
        for chosen, measure in ((~is_disc, _to_boxes), (is_disc, _to_discs)):
            rays.see(seen, cell[chosen], *measure(visible, tries.some(chosen)))


class _Rays:
    """Rays of robots.

    Attributes:
        x, y: where they begin [m], shape (robots,).
        max_range: how far they go [m].
    """

    def __init__(self, poses: Floats, fan: Fan, max_range: float) -> None:
        self.x, self.y, self._yaw = poses
        self._heading = self._yaw - _FULL_TURN * np.rint(self._yaw / _FULL_TURN)
        self._fan = fan
        self.max_range = max_range

    def towards(self, robot: Rows, way: Floats, half_angle: Floats) -> Tuple[Rows, Rows, Floats]:
        """Find the rays that go some way from robots.

        Args:
            robot: their rows, shape (ways,).
            way: direction in the frame ``map``, from -pi to pi [rad], shape (ways,).
            half_angle: how far beside it rays go at most, up to pi [rad], shape (ways,).

        Returns:
            For each ray the row of the way, its cell among the rays of all robots, robot by robot, and its direction
            in the frame ``map`` [rad].
        """
        fan = self._fan
        which, ray = fan.towards(way - self._heading[robot], half_angle)
        robot = robot[which]
        return which, robot * fan.bearings.size + ray, self._yaw[robot] + fan.bearings[ray]

    def see(self, seen: Floats, cell: Rows, distance: Floats, is_hit: NDArray[np.bool_]) -> None:
        """Shorten what is seen along rays to distances where something is hit, as far as they go [m]."""
        near = np.flatnonzero(is_hit & (distance <= self.max_range))
        np.minimum.at(seen, cell[near], distance[near])


class _Tries(NamedTuple):
    """Rays that go the way of a thing, one an element of every array.

    Attributes:
        thing: its column in ``Visible``.
        x, y: of its centre from where the ray begins [m].
        direction: of the ray in the frame ``map`` [rad].
    """

    thing: Rows
    x: Floats
    y: Floats
    direction: Floats

    def some(self, chosen: NDArray[np.bool_]) -> _Tries:
        """Give those that are chosen."""
        return _Tries(self.thing[chosen], self.x[chosen], self.y[chosen], self.direction[chosen])


def _to_boxes(visible: Visible, tries: _Tries) -> Tuple[Floats, NDArray[np.bool_]]:
    """Measure along rays to boxes [m], and tell which are hit."""
    thing, x, y, direction = tries
    cos, sin = visible.cos[thing], visible.sin[thing]
    turned = direction - visible.poses[2][thing]
    with np.errstate(over="ignore"):
        enters_x, leaves_x = _between(cos * x + sin * y, visible.shapes.half_size[0][thing], np.cos(turned))
        enters_y, leaves_y = _between(cos * y - sin * x, visible.shapes.half_size[1][thing], np.sin(turned))
    enters, leaves = np.maximum(enters_x, enters_y), np.minimum(leaves_x, leaves_y)
    return enters, (enters <= leaves) & (enters >= 0.0)


def _between(centre: Floats, half_size: Floats, ahead: Floats) -> Tuple[Floats, Floats]:
    """Measure along rays to where they come between two faces and leave from between them [m].

    Args:
        centre: of what is between the faces, across them [m].
        half_size: from there to either [m].
        ahead: components of unit vectors along the rays, across the faces.
    """
    ahead[ahead == 0.0] = _PARALLEL
    # Where a ray goes from the side of the lower coordinates to the higher, it enters by the lower face.
    half_size = np.copysign(half_size, ahead)
    return (centre - half_size) / ahead, (centre + half_size) / ahead


def _to_discs(visible: Visible, tries: _Tries) -> Tuple[Floats, NDArray[np.bool_]]:
    """Measure along rays to discs [m], and tell which are hit."""
    thing, x, y, direction = tries
    cos, sin, radius = np.cos(direction), np.sin(direction), visible.shapes.rounding[thing]
    along, across = cos * x + sin * y, cos * y - sin * x
    half_chord_squared = radius * radius - across * across
    enters = along - np.sqrt(np.maximum(half_chord_squared, 0.0))
    return enters, (half_chord_squared >= 0.0) & (enters >= 0.0)
