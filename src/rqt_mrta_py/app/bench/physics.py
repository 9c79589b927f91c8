"""How long the physics of a building robot takes: idle, on its way, and while it puts a block among others."""

from __future__ import annotations

import argparse
import math
import time
from typing import Iterator, NamedTuple, Tuple

from rqt_mrta_py.errors import UsageError
from rqt_mrta_py.hooks import BenchmarkTable, Body, PlacedRobot, World, WorldSetup
from rqt_mrta_py.model import Arena, Pose, Twist
from rqt_mrta_py.sim.plugin import mrta_register_robot_models, mrta_register_worlds

__all__ = ["add_arguments", "measure"]

_ARENA = Arena(0.0, 0.0, 2.2, 2.2)
_SIZE = (0.18, 0.07, 0.07)
_MASS, _FRICTION = 0.06, 0.8
_START = Pose(0.3, 1.0)
_COLUMNS_OF_WALL = 8
_SETTLED = 4.0
"""By then everything that was put somewhere lies still [s]."""
_TRAVEL_SPEED, _TURN_RATE = 0.03, 0.08
_PLACE_SPEED = 0.01


class _Scene(NamedTuple):
    """A robot at something: what it is, its twist, and whether it holds a block between two others."""

    name: str
    twist: Twist
    is_at_work: bool = False


_SCENES = (
    _Scene("idle", Twist()),
    _Scene("travelling", Twist(_TRAVEL_SPEED, 0.0, _TURN_RATE)),
    _Scene("at work", Twist(_PLACE_SPEED), is_at_work=True),
)


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Say what the benchmark takes."""
    parser.add_argument("--blocks", metavar="N", type=int, default=30, help="that stand in a wall (default: 30)")
    parser.add_argument(
        "--seconds", metavar="S", type=float, default=10.0, help="of each scene in the world (default: 10)"
    )
    parser.add_argument("--rate", metavar="HZ", type=int, default=10, help="control rate (default: 10)")


def measure(options: argparse.Namespace) -> BenchmarkTable:
    """Play the scenes.

    Raises:
        UsageError: an option is not above 0, or there are no blocks to work among.
    """
    if options.blocks < 2 or not 0.0 < options.seconds < math.inf or not 1 <= options.rate <= 1000:
        raise UsageError("--blocks takes at least 2, --seconds a number above 0, --rate 1 to 1000")
    return BenchmarkTable(
        f"Physics of one builder and a wall of {options.blocks} blocks in the world bullet",
        ("scene", "ms per mission second", "mission seconds per second"),
        tuple(_played(scene, options.blocks, options.seconds, options.rate) for scene in _SCENES),
        ("World alone: no sensors, no agent, nobody who records.",),
    )


def _played(scene: _Scene, blocks: int, seconds: float, rate: int) -> Tuple[str, float, float]:
    world = mrta_register_worlds()["bullet"]()
    ticks = max(1, round(seconds * rate))
    try:
        _build(world, blocks, rate)
        if scene.is_at_work:
            _take_up(world, rate)
        world.command("builder", "base", scene.twist)
        began = time.perf_counter()
        for _ in range(ticks):
            world.step()
        taken = time.perf_counter() - began
    finally:
        world.close()
    lasted = ticks / rate
    return scene.name, round(1000.0 * taken / lasted, 3), round(lasted / taken, 1)


def _build(world: World, blocks: int, rate: int) -> None:
    """Let a builder stand before a wall that has come to rest."""
    model = mrta_register_robot_models()["mecanum_arm"]
    world.reset(WorldSetup(_ARENA, (), (PlacedRobot("builder", model, _START),), 1.0 / rate))
    for body in _wall(blocks):
        world.add_body(body)
    _wait(world, _SETTLED, rate)


def _wall(blocks: int) -> Iterator[Body]:
    """Give blocks in columns that leave a slot in the middle, level on level."""
    for number in range(blocks):
        level, column = divmod(number, _COLUMNS_OF_WALL)
        side = 1.0 if column % 2 else -1.0
        place = (1.0, 1.0 + side * 0.2 * (1 + column // 2), 0.035 + 0.07 * level)
        yield Body(f"block{number}", place, math.pi / 2, _SIZE, _MASS, _FRICTION)


def _take_up(world: World, rate: int) -> None:
    """Let the builder hold a block between the two columns in the middle of the wall, a little before its slot."""
    arm = mrta_register_robot_models()["mecanum_arm"].arm
    if arm is None:
        raise ValueError("the builder has no arm")
    low = arm.angle_at(0.04)
    world.command("builder", "arm", low)
    _wait(world, (arm.highest - low) / arm.rate + 1.0, rate)
    place = (_START.x + arm.reach_at(low) + 0.035, _START.y, arm.height_at(low))
    world.add_body(Body("held", place, -math.pi / 2, _SIZE, _MASS, _FRICTION))
    world.attach("builder", "held")
    world.command("builder", "base", Twist(0.1))
    _wait(world, (1.0 - 0.08 - place[0]) / 0.1, rate)


def _wait(world: World, seconds: float, rate: int) -> None:
    for _ in range(math.ceil(seconds * rate)):
        world.step()
