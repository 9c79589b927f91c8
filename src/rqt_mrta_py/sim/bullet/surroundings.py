"""What does not move: floor, walls and obstacles."""

from __future__ import annotations

import math
from typing import Any, Dict, Sequence, Tuple

from rqt_mrta_py.errors import SimError
from rqt_mrta_py.model import Arena, Obstacle
from rqt_mrta_py.sim.bullet.engine import Engine
from rqt_mrta_py.sim.world_checks import WALL

__all__ = ["LOOSE_GROUP", "build_surroundings"]

LOOSE_GROUP = 64
"""The collision group of loose bodies, which have a floor of their own."""

_ROBOT_GROUP = 1
"""PyBullet's for all that has a mass."""
_FIXED_GROUP = 2
"""PyBullet's for all that has none."""
_WALL_THICKNESS = 0.1
_FLOOR_THICKNESS = 0.01
_GROUND_DEPTH = 1.0
_FLOOR_FRICTION = 1.0
"""Bullet multiplies the frictions of what touches: with 1 here, a body on the floor slides by its own coefficient."""


def build_surroundings(engine: Engine, arena: Arena, obstacles: Sequence[Obstacle]) -> Dict[int, str]:
    """Build walls, floor and obstacles as bodies without mass.

    Args:
        engine: a client just reset.
        arena: inner faces of the walls, frame ``map``.
        obstacles: in the order of building.

    Returns:
        Name by body; the floor has none.

    Raises:
        SimError: an obstacle has a shape that cannot be built.
    """
    names: Dict[int, str] = {}
    # Walls come first: rendering by EGL crashes where a plane is the first body.
    for centre, half_extents in _walls(arena):
        shape = _shape(engine, engine.bullet.GEOM_BOX, halfExtents=half_extents)
        names[_fixed_body(engine, shape, centre, 0.0)] = WALL
    _build_floor(engine, arena)
    for obstacle in obstacles:
        length, width, height = obstacle.size
        if obstacle.shape == "box":
            shape = _shape(engine, engine.bullet.GEOM_BOX, halfExtents=(length / 2, width / 2, height / 2))
        elif obstacle.shape == "cylinder":
            shape = _shape(engine, engine.bullet.GEOM_CYLINDER, radius=length / 2, height=height)
        else:
            raise SimError(f"obstacle {obstacle.id}: no shape {obstacle.shape!r}; give box or cylinder")
        centre = (obstacle.pose.x, obstacle.pose.y, height / 2)
        names[_fixed_body(engine, shape, centre, obstacle.pose.yaw)] = obstacle.id
    return names


def _walls(arena: Arena) -> Tuple[Tuple[Tuple[float, float, float], Tuple[float, float, float]], ...]:
    """Give centre and half extents of the four walls, which meet outside the corners."""
    half = _WALL_THICKNESS / 2
    half_height = arena.wall_height / 2
    middle_x = (arena.min_x + arena.max_x) / 2
    middle_y = (arena.min_y + arena.max_y) / 2
    along_x = ((arena.max_x - arena.min_x) / 2 + _WALL_THICKNESS, half, half_height)
    along_y = (half, (arena.max_y - arena.min_y) / 2 + _WALL_THICKNESS, half_height)
    return (
        ((middle_x, arena.min_y - half, half_height), along_x),
        ((middle_x, arena.max_y + half, half_height), along_x),
        ((arena.min_x - half, middle_y, half_height), along_y),
        ((arena.max_x + half, middle_y, half_height), along_y),
    )


def _build_floor(engine: Engine, arena: Arena) -> None:
    """Build an endless plane for robots to drive on, seen as a slab, and ground for loose bodies to lie on.

    On a plane, Bullet gives a box one new point of contact a step, so that boxes sink and turn by themselves; on
    another box, it gives all four.
    """
    bullet, client = engine.bullet, engine.client
    slab = bullet.createVisualShape(
        bullet.GEOM_BOX,
        halfExtents=((arena.max_x - arena.min_x) / 2, (arena.max_y - arena.min_y) / 2, _FLOOR_THICKNESS / 2),
        visualFramePosition=(
            (arena.min_x + arena.max_x) / 2,
            (arena.min_y + arena.max_y) / 2,
            -_FLOOR_THICKNESS / 2,
        ),
        physicsClientId=client,
    )
    floor = bullet.createMultiBody(0, _shape(engine, bullet.GEOM_PLANE), slab, physicsClientId=client)
    _lay(engine, floor, _ROBOT_GROUP)
    half_sides = ((arena.max_x - arena.min_x) / 2, (arena.max_y - arena.min_y) / 2)
    ground = _shape(
        engine, bullet.GEOM_BOX, halfExtents=(*(half + _WALL_THICKNESS for half in half_sides), _GROUND_DEPTH / 2)
    )
    centre = ((arena.min_x + arena.max_x) / 2, (arena.min_y + arena.max_y) / 2, -_GROUND_DEPTH / 2)
    _lay(engine, _fixed_body(engine, ground, centre, 0.0), LOOSE_GROUP)


def _lay(engine: Engine, floor: int, group: int) -> None:
    """Make a body the floor of one collision group."""
    client = engine.client
    engine.bullet.changeDynamics(floor, -1, lateralFriction=_FLOOR_FRICTION, physicsClientId=client)
    engine.bullet.setCollisionFilterGroupMask(floor, -1, _FIXED_GROUP, group, physicsClientId=client)


def _shape(engine: Engine, kind: int, **dimensions: Any) -> int:
    shape: int = engine.bullet.createCollisionShape(kind, physicsClientId=engine.client, **dimensions)
    return shape


def _fixed_body(engine: Engine, shape: int, centre: Tuple[float, float, float], yaw: float) -> int:
    body: int = engine.bullet.createMultiBody(
        0,
        shape,
        basePosition=centre,
        baseOrientation=(0.0, 0.0, math.sin(yaw / 2), math.cos(yaw / 2)),
        physicsClientId=engine.client,
    )
    return body
