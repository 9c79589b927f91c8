"""What every world of this room refuses, in the same words."""

from __future__ import annotations

import dataclasses
import math
from typing import List, Sequence, Tuple, Union

from rqt_mrta_py.errors import SimError
from rqt_mrta_py.hooks import Body, WorldSetup
from rqt_mrta_py.model import Twist

__all__ = ["WALL", "check_angle", "check_body", "check_drives", "check_ids", "check_numbers", "check_twist"]

WALL = "wall"
"""The name of every wall in contacts."""


def check_ids(setup: WorldSetup) -> None:
    """Refuse a setup that gives an id twice.

    Raises:
        SimError: naming the id.
    """
    taken = {WALL}
    for kind, id_ in [("obstacle", o.id) for o in setup.obstacles] + [("robot", r.id) for r in setup.robots]:
        if id_ in taken:
            raise SimError(f"{kind} {id_}: the id is taken by a wall, an obstacle or another robot; give it its own")
        taken.add(id_)


def check_numbers(setup: WorldSetup, world: str) -> None:
    """Refuse a setup with numbers that nothing can be built from, whoever let them through.

    Args:
        setup: to be built.
        world: its name.

    Raises:
        SimError: naming the thing and showing its numbers.
    """
    if not (math.isfinite(setup.tick) and setup.tick > 0):
        raise SimError(f"world {world}: a tick must last a finite time above 0 s (got {setup.tick!r})")
    things: List[Tuple[str, Sequence[float]]] = [("arena", dataclasses.astuple(setup.arena))]
    things.extend((f"obstacle {o.id}", (*dataclasses.astuple(o.pose), *o.size)) for o in setup.obstacles)
    things.extend((f"robot {r.id}", dataclasses.astuple(r.start)) for r in setup.robots)
    for name, numbers in things:
        if not all(map(math.isfinite, numbers)):
            raise SimError(f"{name}: world {world} builds from finite numbers only (got {numbers})")


def check_drives(setup: WorldSetup, world: str, drives: Sequence[str]) -> None:
    """Refuse robots whose drives a world cannot build.

    Args:
        setup: with the robots.
        world: its name.
        drives: that it can build.

    Raises:
        SimError: naming the robot and the drives.
    """
    for robot in setup.robots:
        if robot.model.drive not in drives:
            raise SimError(
                f"robot {robot.id}: world {world} cannot build drive {robot.model.drive!r} of model "
                f"{robot.model.name}; it can build: {', '.join(drives)}"
            )


def check_body(body: Body) -> None:
    """Refuse a body whose numbers make none.

    Raises:
        SimError: showing them.
    """
    numbers = (*body.position, body.yaw, *body.size, body.mass, body.friction)
    if not all(map(math.isfinite, numbers)) or min(*body.size, body.mass) <= 0 or body.friction < 0:
        raise SimError(
            f"body {body.id}: size and mass must be above 0, friction at least 0, everything finite (got {body})"
        )


def check_twist(robot: str, actuator: str, value: Union[Twist, float], world: str) -> Twist:
    """Give the command to a robot's base; refuse other actuators and values that are no finite twist.

    Raises:
        SimError: naming the actuator or showing the value.
    """
    if actuator != "base":
        raise SimError(f"robot {robot}: no actuator {actuator!r} in world {world}; there is: base")
    if not isinstance(value, Twist) or not math.isfinite(value.vx + value.vy + value.wz):
        raise SimError(f"robot {robot}: base takes a Twist of finite numbers (got {value!r})")
    return value


def check_angle(robot: str, value: Union[Twist, float]) -> float:
    """Give the command to a robot's arm; refuse what is no finite angle.

    Raises:
        SimError: showing the value.
    """
    if isinstance(value, (int, float)) and not isinstance(value, bool) and math.isfinite(value):
        return float(value)
    raise SimError(f"robot {robot}: arm takes a finite angle [rad] (got {value!r})")
