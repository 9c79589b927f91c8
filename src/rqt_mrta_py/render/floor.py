"""What never moves: floor, grid, axes, walls, obstacles; and from metres to pixels."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, Optional, Sequence, Tuple

import numpy as np

from rqt_mrta_py.hooks import SceneView
from rqt_mrta_py.model import Arena, Obstacle, Pose
from rqt_mrta_py.render.canvas import Box, Canvas, Point
from rqt_mrta_py.render.layout import SMALL
from rqt_mrta_py.render.palette import FAINT, FRAME, GRID, INK, MUTED, OBSTACLE, WHITE, mix
from rqt_mrta_py.render.times import number, ticks

if TYPE_CHECKING:
    from numpy.typing import NDArray

__all__ = ["ArenaMap", "draw_floor", "extent", "nearby", "somewhere", "without_places"]

_UNKNOWN = Arena(-2.0, -2.0, 2.0, 2.0, 0.0)
_SNAP = 2.0
# Of its two sides the shorter is shown no shorter than this share of the longer, and neither shorter than this [m].
_THINNEST, _SMALLEST = 0.02, 1e-3
_FARTHEST, _FARTHEST_AWAY = 1e6, 1e7


class ArenaMap:
    """From metres in the frame ``map`` to pixels, to scale, in the middle of a box.

    Args:
        floor: what is shown.
        box: where.
    """

    def __init__(self, floor: Arena, box: Box) -> None:
        room = box.inset(40, 4, 6, 34)
        width, height = floor.max_x - floor.min_x, floor.max_y - floor.min_y
        self.scale = min(room.width / width, room.height / height)
        x, y = room.centre
        left, top = round(x - width * self.scale / 2.0), round(y - height * self.scale / 2.0)
        self.floor = floor
        self.box = Box(left, top, round(left + width * self.scale), round(top + height * self.scale))

    def __call__(self, x: float, y: float) -> Point:
        """Give the place of a point [m]."""
        return (
            self.box.left + (x - self.floor.min_x) * self.scale,
            self.box.bottom - (y - self.floor.min_y) * self.scale,
        )

    def inside(self, pose: Pose) -> Point:
        """Give the place of a pose from the map's upper left corner, at most a million pixels away."""
        x, y = (pose.x - self.floor.min_x) * self.scale, (self.floor.max_y - pose.y) * self.scale
        return min(max(x, -_FARTHEST), _FARTHEST), min(max(y, -_FARTHEST), _FARTHEST)

    def inside_array(self, points: NDArray[np.float64]) -> NDArray[np.float64]:
        """Give the places of points (points, 2) [m] from the map's upper left corner."""
        origin, scale = (self.floor.min_x, self.floor.max_y), (self.scale, -self.scale)
        return (points.clip(-_FARTHEST_AWAY, _FARTHEST_AWAY) - origin) * scale


def extent(scene: SceneView) -> Arena:
    """Give the floor to show: the arena, or where nothing is known of it, what holds everything seen.

    Args:
        scene: what there is; without an arena the edges move in steps, so that the picture keeps still.

    Returns:
        A floor that can be drawn, to scale, whatever the arena is like: never without width or height.
    """
    if scene.arena is not None:
        return _drawable(scene.arena)
    points = [(obstacle.pose.x, obstacle.pose.y) for obstacle in scene.obstacles]
    points += [(robot.pose.x, robot.pose.y) for robot in scene.robots if robot.pose is not None]
    points += [(x, y) for robot in scene.robots for _, x, y in robot.trail]
    points += [(task.place.x, task.place.y) for task in scene.tasks if task.place is not None]
    points += [(body.x, body.y) for body in scene.bodies]
    points = [point for point in points if abs(point[0]) < _FARTHEST_AWAY and abs(point[1]) < _FARTHEST_AWAY]
    if not points:
        return _UNKNOWN
    (min_x, max_x), (min_y, max_y) = (_snapped([point[axis] for point in points]) for axis in (0, 1))
    return _drawable(Arena(min_x, min_y, max_x, max_y, 0.0))


def somewhere(pose: Optional[Pose]) -> Optional[Pose]:
    """Give a pose if it is known and anywhere near; not if it is so far away that arithmetic would suffer."""
    if pose is None or not (abs(pose.x) < _FARTHEST_AWAY and abs(pose.y) < _FARTHEST_AWAY):
        return None
    return pose


def nearby(points: NDArray[np.float64]) -> NDArray[np.bool_]:
    """Tell of each of many points (points, 2) what ``somewhere`` tells of a pose."""
    inside = np.abs(points) < _FARTHEST_AWAY
    near: NDArray[np.bool_] = inside[:, 0] & inside[:, 1]
    return near


def without_places(scene: SceneView) -> bool:
    """Tell whether nothing is known of where anything is.

    Args:
        scene: what there is.
    """
    if scene.arena is not None:
        return False
    seen = [robot.pose for robot in scene.robots] + [task.place for task in scene.tasks]
    return not scene.bodies and all(place is None for place in seen)


def draw_floor(canvas: Canvas, place: ArenaMap, obstacles: Sequence[Obstacle]) -> None:
    """Draw what never moves: floor, grid, axes, walls if there are any, obstacles.

    Args:
        canvas: drawn upon.
        place: where things are.
        obstacles: fixed bodies.
    """
    floor, box = place.floor, place.box
    canvas.fill(box, FAINT)
    for x in ticks(floor.min_x, floor.max_x, 12 if box.width > 300 else 7):
        column = place(x, 0.0)[0]
        canvas.fill(Box(round(column), box.top, round(column) + 1, box.bottom), GRID)
        canvas.text(column, box.bottom + 13, number(x), SMALL, MUTED, WHITE, anchor=0.5)
    for y in ticks(floor.min_y, floor.max_y, 9 if box.height > 200 else 5):
        row = place(0.0, y)[1]
        canvas.fill(Box(box.left, round(row), box.right, round(row) + 1), GRID)
        canvas.text(box.left - 8, row, number(y), SMALL, MUTED, WHITE, anchor=1.0)
    canvas.text(box.centre[0], box.bottom + 27, "x [m]", SMALL, MUTED, WHITE, anchor=0.5)
    canvas.upright_text(box.left - 36, box.centre[1], "y [m]", SMALL, colour=MUTED, ground=WHITE)
    sub = canvas.part(box)
    for obstacle in obstacles:
        _draw_obstacle(sub, place, obstacle)
    if floor.wall_height > 0.0:
        canvas.frame(Box(box.left - 3, box.top - 3, box.right + 3, box.bottom + 3), mix(INK, WHITE, 0.25), 3)
    else:
        canvas.frame(box, FRAME)


def _draw_obstacle(canvas: Canvas, place: ArenaMap, obstacle: Obstacle) -> None:
    left, top = place.box.left, place.box.top
    x, y = place(obstacle.pose.x, obstacle.pose.y)
    edge = mix(OBSTACLE, INK, 0.45)
    if obstacle.shape == "cylinder":
        radius = obstacle.size[0] / 2.0 * place.scale
        canvas.disc((x - left, y - top), radius, OBSTACLE)
        canvas.ring((x - left, y - top), radius, edge)
        return
    cos, sin = math.cos(obstacle.pose.yaw), math.sin(obstacle.pose.yaw)
    corners = []
    for along, across in ((0.5, 0.5), (-0.5, 0.5), (-0.5, -0.5), (0.5, -0.5)):
        dx, dy = along * obstacle.size[0], across * obstacle.size[1]
        x, y = place(obstacle.pose.x + cos * dx - sin * dy, obstacle.pose.y + sin * dx + cos * dy)
        corners.append((x - left, y - top))
    canvas.polygon(corners, OBSTACLE)
    canvas.line(corners, edge, closed=True)


def _snapped(values: Sequence[float]) -> Tuple[float, float]:
    low = _SNAP * math.floor((min(values) - 0.5) / _SNAP)
    return low, _SNAP * math.ceil((max(values) + 0.5) / _SNAP)


def _drawable(arena: Arena) -> Arena:
    if not math.isfinite(arena.max_x - arena.min_x + arena.max_y - arena.min_y):
        return _UNKNOWN
    longest = max(arena.max_x - arena.min_x, arena.max_y - arena.min_y, _SMALLEST)
    (min_x, max_x), (min_y, max_y) = (
        _widened(low, high, longest) for low, high in ((arena.min_x, arena.max_x), (arena.min_y, arena.max_y))
    )
    return Arena(min_x, min_y, max_x, max_y, arena.wall_height)


def _widened(low: float, high: float, longest: float) -> Tuple[float, float]:
    # Far from the origin a length may be lost in rounding.
    least = max(_THINNEST * longest, 1e-9 * max(abs(low), abs(high)))
    if high - low >= least:
        return low, high
    return (low + high - least) / 2.0, (low + high + least) / 2.0
