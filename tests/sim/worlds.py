"""What the tests of worlds share: the worlds under contract, a small robot yard, a crowd that bumps about."""

from __future__ import annotations

import hashlib
import math
from typing import Callable, Mapping, Sequence

from rqt_mrta_py.hooks import PlacedRobot, World, WorldSetup
from rqt_mrta_py.model import Arena, Obstacle, Pose, Twist
from rqt_mrta_py.sim import plugin
from rqt_mrta_py.sim.robot_models import DIFF_DRIVE

TICK = 0.05
ARENA = Arena(-3.0, -3.0, 3.0, 3.0)

WORLDS: Mapping[str, Callable[[], World]] = plugin.mrta_register_worlds()
"""Every world of the room passes the same contract."""


def setup(
    *starts: Pose, obstacles: Sequence[Obstacle] = (), arena: Arena = ARENA, tick: float = TICK, model=DIFF_DRIVE
) -> WorldSetup:
    """Place robots r0, r1, ... at their start poses."""
    robots = tuple(PlacedRobot(f"r{index}", model, start) for index, start in enumerate(starts))
    return WorldSetup(arena, tuple(obstacles), robots, tick)


def run(world: World, seconds: float) -> None:
    """Let time pass."""
    for _ in range(round(seconds / TICK)):
        world.step()


def crowd_setup() -> WorldSetup:
    """Five robots around an obstacle, all about to meet."""
    starts = [
        Pose(math.cos(0.4 * math.pi * i), math.sin(0.4 * math.pi * i), 0.4 * math.pi * i + math.pi) for i in range(5)
    ]
    return setup(*starts, obstacles=[Obstacle("post", Pose(0.0, 0.0), (0.4, 0.4, 0.4), "cylinder")])


def crowd_hash(world: World, *, observed: bool = False) -> str:
    """Drive the crowd for five seconds through contacts and a freeze; hash every pose of every tick."""
    world.reset(crowd_setup())
    digest = hashlib.sha256()
    touched = set()
    for tick in range(100):
        if tick in (40, 70):
            world.freeze("r1", tick == 40)
        for index in range(5):
            world.command(f"r{index}", "base", Twist(0.4, 0.0, math.sin(0.1 * tick + index)))
        world.step()
        if observed or tick == 99:
            touched.update(world.contacts())
            world.ranges(["r0"], world.poses()[:, 2], 4.0)[0]
        digest.update(world.poses().tobytes())
    assert touched, "the crowd must touch, or equal hashes say little"
    return digest.hexdigest()


if __name__ == "__main__":
    import sys

    fresh = WORLDS[sys.argv[1]]()
    sys.stdout.write(crowd_hash(fresh))
    fresh.close()
