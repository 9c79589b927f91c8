"""What range finders can see in BulletWorld, and where it is."""

from __future__ import annotations

from typing import Sequence

import numpy as np
from numpy.typing import NDArray

from rqt_mrta_py.model import Arena, Obstacle
from rqt_mrta_py.sim.bullet.range_rays import Balls, Boxes, Pillars, Rays, cast_rays
from rqt_mrta_py.sim.bullet.robot_shape import RobotShape

__all__ = ["Sight"]

_Floats = NDArray[np.float64]
_NOBODY = -1
_ROUNDING = 1e-9
"""Of heights [m]."""


class Sight:
    """The shapes of one world: walls, obstacles, robots, loose bodies.

    A frame is a position [m] and a quaternion (x, y, z, w) in the frame ``map``.

    Args:
        arena: whose walls are seen.
        obstacles: that stand in it.
        robots: shapes in the setup's order; a robot's place among them is its number.
    """

    def __init__(self, arena: Arena, obstacles: Sequence[Obstacle], robots: Sequence[RobotShape]) -> None:
        self._arena = arena
        blocks = [obstacle for obstacle in obstacles if obstacle.shape == "box"]
        self._pillars = _pillars([obstacle for obstacle in obstacles if obstacle.shape == "cylinder"])
        self._numbers = np.arange(len(robots))
        self._box_centre = _vectors([robot.box_centre for robot in robots])
        half_size = _vectors([robot.box_half_size for robot in robots])
        self._boxes = _joined(_blocks(blocks), Boxes.of(self._numbers, half_size))
        self._robots_boxes = slice(len(blocks), None)
        balls_of = [(*robot.wheels, *robot.casters) for robot in robots]
        balls = [ball for some in balls_of for ball in some]
        self._ball_owner = np.repeat(self._numbers, np.array([len(some) for some in balls_of], dtype=np.int64))
        self._ball_centre = _vectors([ball.centre for ball in balls])
        self._ball_radius = np.array([ball.radius for ball in balls], dtype=np.float64)
        self._no_balls = Balls(self._ball_owner[:0], self._ball_centre[:0], self._ball_radius[:0])

    def measure(self, rays: Rays, robots: _Floats, bodies: _Floats, body_half_size: _Floats) -> _Floats:
        """Measure true distances.

        Args:
            rays: whose owners are robots' numbers; they begin inside the walls.
            robots: their frames, shape (robots, 7).
            bodies: frames of the loose bodies, shape (bodies, 7).
            body_half_size: half of length, width, height of each [m], shape (bodies, 3).

        Returns:
            To the nearest surface that is not the robot's own [m], shape (owners, rays); infinity where nothing is
            seen.
        """
        axes = _axes(robots[:, 3:])
        boxes = self._boxes
        boxes.centre[self._robots_boxes] = _placed(robots, axes, self._box_centre)
        boxes.axes[self._robots_boxes] = axes
        if len(bodies):
            loose = Boxes.of(np.full(len(bodies), _NOBODY, dtype=np.int64), body_half_size)
            loose.centre[:] = bodies[:, :3]
            loose.axes[:] = _axes(bodies[:, 3:])
            boxes = _joined(boxes, loose)
        seen = cast_rays(rays, boxes, self._balls(robots, axes, rays.origin[:, 2]), self._pillars)
        seen = np.minimum(seen, self._walls(rays))
        seen[seen > rays.max_range] = np.inf
        return seen

    def _balls(self, robots: _Floats, axes: _Floats, heights: _Floats) -> Balls:
        """Place those wheels and casters that may be at the height of any ray; that is seldom one."""
        owner = self._ball_owner
        rise = robots[owner, 2] + (axes[:, :, 2][owner] * self._ball_centre).sum(axis=1)
        reach = self._ball_radius + _ROUNDING
        met = (rise - reach <= heights.max(initial=-np.inf)) & (rise + reach >= heights.min(initial=np.inf))
        if not met.any():
            return self._no_balls
        owner = owner[met]
        return Balls(owner, _placed(robots[owner], axes[owner], self._ball_centre[met]), self._ball_radius[met])

    def _walls(self, rays: Rays) -> _Floats:
        """Follow rays to the nearer of the two walls that they go towards."""
        arena, (x, y, z) = self._arena, rays.origin.T[:, :, None]
        with np.errstate(divide="ignore", invalid="ignore"):  # rays along a wall
            along_x = np.abs((np.where(rays.cos > 0.0, arena.max_x, arena.min_x) - x) / rays.cos)
            along_y = np.abs((np.where(rays.sin > 0.0, arena.max_y, arena.min_y) - y) / rays.sin)
        return np.where(z <= arena.wall_height, np.fmin(along_x, along_y), np.inf)


def _blocks(obstacles: Sequence[Obstacle]) -> Boxes:
    half_size = _vectors([obstacle.size for obstacle in obstacles]) / 2
    yaw = np.array([obstacle.pose.yaw for obstacle in obstacles], dtype=np.float64)
    level = np.zeros_like(yaw)
    blocks = Boxes.of(np.full(len(obstacles), _NOBODY, dtype=np.int64), half_size)
    blocks.centre[:] = _centres(obstacles)
    blocks.axes[:] = _axes(np.stack((level, level, np.sin(yaw / 2), np.cos(yaw / 2)), axis=1))
    return blocks


def _joined(some: Boxes, more: Boxes) -> Boxes:
    return Boxes(*(np.concatenate(parts) for parts in zip(some, more)))


def _pillars(obstacles: Sequence[Obstacle]) -> Pillars:
    size = _vectors([obstacle.size for obstacle in obstacles])
    return Pillars(_centres(obstacles), size[:, 0] / 2, size[:, 2] / 2)


def _centres(obstacles: Sequence[Obstacle]) -> _Floats:
    return _vectors([(obstacle.pose.x, obstacle.pose.y, obstacle.size[2] / 2) for obstacle in obstacles])


def _vectors(vectors: Sequence[Sequence[float]]) -> _Floats:
    return np.array(vectors, dtype=np.float64).reshape(-1, 3)


def _placed(frames: _Floats, axes: _Floats, points: _Floats) -> _Floats:
    """Bring a point of each frame into the map."""
    placed: _Floats = frames[:, :3] + np.einsum("nij,ni->nj", axes, points)
    return placed


def _axes(quaternions: _Floats) -> _Floats:
    """Give the x, y and z axes of frames, one a row, from their quaternions (x, y, z, w)."""
    x, y, z, w = quaternions.T
    axes = np.empty((len(quaternions), 3, 3))
    axes[:, 0, 0] = 1 - 2 * (y * y + z * z)
    axes[:, 0, 1] = 2 * (x * y + z * w)
    axes[:, 0, 2] = 2 * (x * z - y * w)
    axes[:, 1, 0] = 2 * (x * y - z * w)
    axes[:, 1, 1] = 1 - 2 * (x * x + z * z)
    axes[:, 1, 2] = 2 * (y * z + x * w)
    axes[:, 2, 0] = 2 * (x * z + y * w)
    axes[:, 2, 1] = 2 * (y * z - x * w)
    axes[:, 2, 2] = 1 - 2 * (x * x + y * y)
    return axes
