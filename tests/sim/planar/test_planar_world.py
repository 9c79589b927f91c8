"""What PlanarWorld does beyond the contract of worlds."""

from __future__ import annotations

import hashlib
import math
import subprocess
import sys
from dataclasses import replace

import numpy as np
import pytest

from rqt_mrta_py.errors import SimError
from rqt_mrta_py.hooks import Body
from rqt_mrta_py.model import Arena, Obstacle, Pose, Twist
from rqt_mrta_py.sim.planar import PlanarWorld
from rqt_mrta_py.sim.robot_models import DIFF_DRIVE
from tests.sim.worlds import setup


def crowd_hash():
    """Let 60 robots press to the middle among bodies; hash poses, bodies, contacts and ranges."""
    starts = [Pose(0.7 * (i % 8) - 2.5, 0.7 * (i // 8) - 2.5, 0.9 * i) for i in range(60)]
    obstacles = [
        Obstacle("bar", Pose(0.35, 0.35, 0.4), (0.5, 0.04, 0.4)),
        Obstacle("post", Pose(-1.05, 0.35), (0.3, 0.3, 0.4), "cylinder"),
    ]
    world = PlanarWorld()
    world.reset(setup(*starts, obstacles=obstacles))
    for index in range(5):
        world.add_body(Body(f"b{index}", (0.7 * index - 1.4, -0.35, 0.1), 0.3, (0.15, 0.1, 0.2), 0.4))
    digest = hashlib.sha256()
    touched = 0
    for _ in range(60):
        for index, (x, y, yaw) in enumerate(world.poses().tolist()):
            turn = math.remainder(math.atan2(-y, -x) - yaw, 2 * math.pi)
            world.command(f"r{index}", "base", Twist(0.5, 0.0, 2 * turn))
        world.step()
        touched += len(world.contacts())
        digest.update(world.poses().tobytes())
        digest.update(world.ranges(["r3", "r40"], np.linspace(-3, 3, 20), 3.0).tobytes())
        digest.update(repr((world.contacts(), sorted(world.bodies().items()))).encode())
    return f"{touched > 200} {digest.hexdigest()}"


def test_crowd_in_a_press_repeats_bit_for_bit_in_other_processes(root):
    first = crowd_hash()
    assert first.startswith("True")
    assert crowd_hash() == first
    code = "from tests.sim.planar.test_planar_world import crowd_hash; print(crowd_hash())"
    done = subprocess.run([sys.executable, "-c", code], cwd=root, capture_output=True, text=True, check=True)
    assert done.stdout.strip() == first


def test_ten_thousand_robots_can_be_built_stepped_and_look_around():
    starts = [Pose(0.5 * (i % 100) - 24.75, 0.5 * (i // 100) - 24.75, 0.1 * i) for i in range(10_000)]
    world = PlanarWorld()
    world.reset(setup(*starts, arena=Arena(-25.0, -25.0, 25.0, 25.0)))
    for index in range(10_000):
        world.command(f"r{index}", "base", Twist(0.4, 0.0, 0.5))
    for _ in range(5):
        world.step()
    poses = world.poses()
    assert poses.shape == (10_000, 3)
    assert np.isfinite(poses).all()
    assert np.abs(poses[:, :2]).max() <= 25.0
    moved = np.hypot(*(poses[:, :2] - np.array([(start.x, start.y) for start in starts])).T)
    assert np.median(moved) > 0.05
    seen = world.ranges([f"r{index}" for index in range(10_000)], np.linspace(-3.0, 3.0, 8), 2.0)
    assert np.isfinite(seen).mean() > 0.5
    assert seen.min() > 0.1


def test_command_counts_only_what_the_model_can_obey():
    world = PlanarWorld()
    world.reset(setup(Pose(0.0, 0.0)))
    world.command("r0", "base", Twist(0, 0, 0))
    world.command("r0", "base", Twist(1e308, 0.0, 0.0))
    for _ in range(20):
        world.step()
    assert world.poses()[0, 0] == pytest.approx(0.5 * (1.0 - 0.05), abs=1e-6)


@pytest.mark.parametrize(
    ("change", "message"),
    [
        (
            {"starts": [Pose(math.nan, 0.0)]},
            r"robot r0: world planar builds from finite numbers only \(got \(nan, 0.0, 0.0\)\)",
        ),
        ({"obstacles": [Obstacle("rock", Pose(0.0, math.inf), (1.0, 1.0, 1.0))]}, "obstacle rock: world planar builds"),
        ({"arena": Arena(-1.0, -1.0, math.inf, 1.0)}, "arena: world planar builds from finite numbers only"),
        ({"tick": math.inf}, r"world planar: a tick must last a finite time above 0 s \(got inf\)"),
    ],
)
def test_setup_of_impossible_numbers_is_refused_by_name(change, message):
    starts = change.pop("starts", [Pose(0.0, 0.0)])
    with pytest.raises(SimError, match=message):
        PlanarWorld().reset(setup(*starts, **change))


def test_setup_that_is_refused_leaves_the_world_as_it_was():
    world = PlanarWorld()
    world.reset(setup(Pose(0.5, 0.0)))
    with pytest.raises(SimError):
        world.reset(setup(Pose(0.0, 0.0), model=replace(DIFF_DRIVE, drive="rail")))
    world.step()
    assert world.poses().tolist() == [[0.5, 0.0, 0.0]]


def test_closed_world_knows_nobody():
    world = PlanarWorld()
    world.reset(setup(Pose(0.0, 0.0)))
    world.close()
    with pytest.raises(SimError, match="robot r0: not in this world; there are: none"):
        world.command("r0", "base", Twist())
    with pytest.raises(SimError, match="call reset first"):
        world.poses()
