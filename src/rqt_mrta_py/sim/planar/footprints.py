"""Shapes from above.

Every shape here is a centrally symmetric polygon, given by half its edges (a box by two, a box with wheels sticking out
by three), or a disc. Such a polygon reaches, in the direction of a unit vector n, as far as the sum of |e . n| over its
half edges e: all that collisions need to know.
"""

from __future__ import annotations

import math
from typing import NamedTuple, Sequence, Tuple

import numpy as np

from rqt_mrta_py.errors import SimError
from rqt_mrta_py.hooks import Body, RobotModel
from rqt_mrta_py.model import Obstacle, Pose
from rqt_mrta_py.sim.planar.cells import Floats, Rows

__all__ = ["Footprints", "Placed", "body_footprint", "columns_of_poses", "placed_obstacles", "robot_footprints"]

_Vector = Tuple[float, float]
_NOTHING: _Vector = (0.0, 0.0)


class Footprints(NamedTuple):
    """Shapes of many things, one thing a column, in the things' own frames.

    Attributes:
        half_edges: three of each thing, of no length where it needs fewer [m], shape (2, 3, things).
        half_size: half length and half width of the box that range finders see, 0 of discs [m], shape (2, things).
        rounding: radius of a disc, 0 of polygons [m], shape (things,).
        radius: of the circle around all of it [m], shape (things,).
        low, high: what it fills above the floor [m], shape (things,).
    """

    half_edges: Floats
    half_size: Floats
    rounding: Floats
    radius: Floats
    low: Floats
    high: Floats

    @property
    def widest(self) -> float:
        """The largest radius, 0 without things [m]."""
        return float(self.radius.max()) if self.radius.size else 0.0

    def joined(self, more: Footprints) -> Footprints:
        """Give these and more behind them."""
        return Footprints(*(np.concatenate(fields, axis=-1) for fields in zip(self, more)))

    def without(self, row: int) -> Footprints:
        """Give all but one."""
        return Footprints(*(np.delete(field, row, axis=-1) for field in self))


class Placed(NamedTuple):
    """Footprints and where they are.

    Attributes:
        footprints: of some things.
        poses: x, y [m] and yaw [rad] in the frame ``map``, shape (3, things).
    """

    footprints: Footprints
    poses: Floats

    def half_edges(self, rows: Rows) -> Floats:
        """Give the half edges of some things, turned as these are [m], shape (2, 3, rows)."""
        x, y = self.footprints.half_edges[:, :, rows]
        yaw = self.poses[2, rows]
        cos, sin = np.cos(yaw), np.sin(yaw)
        return np.array((cos * x - sin * y, sin * x + cos * y))


class _Shape(NamedTuple):
    """One footprint, as ``Footprints`` has them."""

    half_edges: Tuple[_Vector, _Vector, _Vector]
    half_size: _Vector
    rounding: float
    radius: float
    low: float
    high: float


def robot_footprints(models: Sequence[RobotModel]) -> Footprints:
    """Give the shapes of robots: the body's box, and under a differential drive the hull around it and its wheels."""
    return _stack([_robot(model) for model in models])


def placed_obstacles(obstacles: Sequence[Obstacle]) -> Placed:
    """Give obstacles their shapes.

    Raises:
        SimError: one has a shape that cannot be built.
    """
    footprints = _stack([_obstacle(obstacle) for obstacle in obstacles])
    return Placed(footprints, columns_of_poses([obstacle.pose for obstacle in obstacles]))


def columns_of_poses(poses: Sequence[Pose]) -> Floats:
    """Give poses as an array of x, y [m] and yaw [rad], shape (3, poses)."""
    rows = [(pose.x, pose.y, pose.yaw) for pose in poses]
    return np.array(rows, dtype=np.float64).reshape(-1, 3).transpose().copy()


def body_footprint(body: Body) -> Footprints:
    """Give the shape of one loose body, a box around its centre."""
    length, width, height = body.size
    middle = body.position[2]
    return _stack([_box(length, width, middle - height / 2, middle + height / 2)])


def _robot(model: RobotModel) -> _Shape:
    box = _box(model.length, model.width, 0.0, model.height)
    # As in BulletWorld, whose wheels are spheres in the middle of the sides.
    wheels = model.track / 2 + model.wheel_radius
    if model.drive != "differential" or wheels <= model.width / 2:
        return box
    half_length, half_width = box.half_size
    slope = (half_length / 2, (wheels - half_width) / 2)
    edges = ((0.0, half_width), slope, (slope[0], -slope[1]))
    return box._replace(half_edges=edges, radius=max(box.radius, wheels))


def _obstacle(obstacle: Obstacle) -> _Shape:
    length, width, height = obstacle.size
    if obstacle.shape == "box":
        return _box(length, width, 0.0, height)
    if obstacle.shape == "cylinder":
        return _Shape((_NOTHING, _NOTHING, _NOTHING), _NOTHING, length / 2, length / 2, 0.0, height)
    raise SimError(f"obstacle {obstacle.id}: no shape {obstacle.shape!r}; give box or cylinder")


def _box(length: float, width: float, low: float, high: float) -> _Shape:
    half_size = (length / 2, width / 2)
    edges = ((half_size[0], 0.0), (0.0, half_size[1]), _NOTHING)
    return _Shape(edges, half_size, 0.0, math.hypot(*half_size), low, high)


def _stack(shapes: Sequence[_Shape]) -> Footprints:
    half_edges, half_size, *numbers = zip(*shapes) if shapes else ((),) * len(_Shape._fields)
    rounding, radius, low, high = (np.array(field, dtype=np.float64) for field in numbers)
    return Footprints(
        np.array(half_edges, dtype=np.float64).reshape(-1, 3, 2).transpose(2, 1, 0).copy(),
        np.array(half_size, dtype=np.float64).reshape(-1, 2).transpose().copy(),
        rounding,
        radius,
        low,
        high,
    )
