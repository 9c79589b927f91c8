"""What robots see in BulletWorld, against the rays of PyBullet itself."""

from __future__ import annotations

import math
from dataclasses import replace

import numpy as np
import pytest

from rqt_mrta_py.hooks import Body
from rqt_mrta_py.model import Obstacle, Pose, Twist
from rqt_mrta_py.sim.bullet import BulletWorld
from rqt_mrta_py.sim.robot_models import DIFF_DRIVE
from tests.sim.worlds import run, setup

BEARINGS = np.linspace(-math.pi, math.pi, 90, endpoint=False)
TOLERANCE = 6e-3
"""What rays of PyBullet are off where they graze a face [m]; a few graze an edge that only one hits."""


@pytest.fixture
def world():
    built = BulletWorld()
    yield built
    built.close()


def bullet_rays(world, robot, height, max_range):
    """Ask PyBullet; rays that end at a part of the robot itself give nan."""
    engine, body = world._engine, world._robots[robot].body
    x, y, yaw = world.poses()[list(world._robots).index(robot)]
    angles = yaw + BEARINGS
    starts = np.tile((x, y, height), (len(angles), 1))
    ends = starts + max_range * np.stack((np.cos(angles), np.sin(angles), np.zeros_like(angles)), axis=1)
    seen = []
    for hit, _, fraction, _, _ in engine.bullet.rayTestBatch(starts, ends, physicsClientId=engine.client):
        seen.append(math.nan if hit == body else fraction * max_range if hit >= 0 else math.inf)
    return np.array(seen)


@pytest.mark.parametrize("height", [0.03, 0.05, 0.08, 0.12, 0.22])
def test_robots_see_what_the_rays_of_pybullet_hit(world, height):
    """Boxes, pillars, walls, wheels, casters, and blocks that fell on their edges, from heights that cut each."""
    random = np.random.default_rng(5)
    obstacles = [
        Obstacle("box", Pose(1.8, 0.4, 0.7), (0.5, 0.3, 0.4)),
        Obstacle("kerb", Pose(-1.5, 1.8, -0.2), (0.6, 0.3, 0.06)),
        Obstacle("post", Pose(0.3, -2.0), (0.4, 0.4, 0.3), "cylinder"),
        Obstacle("stub", Pose(2.2, 2.2), (0.5, 0.5, 0.1), "cylinder"),
    ]
    starts = [Pose(0.8 * (i % 3) - 0.9, 0.8 * (i // 3) - 0.7, 2.4 * i) for i in range(9)]
    world.reset(setup(*starts, obstacles=obstacles, model=replace(DIFF_DRIVE, sensor_height=height)))
    for index in range(4):
        above_edges = (1.55 + 0.15 * index, 0.25 + 0.15 * index, 0.6 + 0.4 * index)
        world.add_body(Body(f"block{index}", above_edges, 0.5 * index, (0.3, 0.25, 0.2 + 0.05 * index), 0.5))
    for _ in range(8):
        for index in range(9):
            world.command(f"r{index}", "base", Twist(random.uniform(-0.5, 0.5), 0.0, random.uniform(-2.0, 2.0)))
        run(world, 0.25)
    leaning = [
        state for state in world.bodies().values() if abs(state.orientation[0]) + abs(state.orientation[1]) > 0.1
    ]
    assert leaning, "blocks must tumble"
    robots = [f"r{index}" for index in range(9)]
    mine = world.ranges(robots, BEARINGS, 3.5)
    theirs = np.array([bullet_rays(world, robot, height, 3.5) for robot in robots])
    compared = ~np.isnan(theirs)
    both = compared & np.isfinite(mine) & np.isfinite(theirs)
    with np.errstate(invalid="ignore"):
        alike = np.where(both, np.abs(mine - theirs) < TOLERANCE, np.isinf(mine) & np.isinf(theirs))
    assert compared.sum() > 400
    assert len(np.unique(theirs[both].round(1))) > 15, "a scene with little in it says little"
    assert np.mean(alike[compared]) > 0.98


def test_tumbled_block_is_seen_as_it_lies(world):
    """A cube of 0.4 m on its edge, seen at 0.12 m from the edge's side: its face recedes at 45 degrees."""
    world.reset(setup(Pose(0.0, 0.0)))
    world.add_body(Body("cube", (1.5, 0.0, 0.3), 0.0, (0.4, 0.4, 0.4), 1.0))
    engine = world._engine
    height = 0.2 * math.sqrt(2.0)
    on_edge = (0.0, math.sin(math.pi / 8), 0.0, math.cos(math.pi / 8))
    (number,) = world._loose._bodies.values()
    engine.bullet.resetBasePositionAndOrientation(number, (1.5, 0.0, height), on_edge, physicsClientId=engine.client)
    (seen,) = world.ranges(["r0"], np.zeros(1), 4.0)
    assert seen[0] == pytest.approx(1.5 - DIFF_DRIVE.sensor_height, abs=1e-6)


def test_team_sees_as_each_of_it_alone(world):
    starts = [Pose(0.7 * (i % 4) - 1.2, 0.7 * (i // 4) - 1.2, i) for i in range(12)]
    world.reset(setup(*starts))
    robots = [f"r{index}" for index in (7, 2, 11, 0)]
    together = world.ranges(robots, BEARINGS, 4.0)
    alone = np.concatenate([world.ranges([robot], BEARINGS, 4.0) for robot in robots])
    np.testing.assert_array_equal(together, alone)


def test_crowd_with_many_rays_is_cast_in_parts_without_a_seam(world, monkeypatch):
    starts = [Pose(0.7 * (i % 4) - 1.2, 0.7 * (i // 4) - 1.2, i) for i in range(12)]
    world.reset(setup(*starts))
    robots = [f"r{index}" for index in range(12)]
    whole = world.ranges(robots, BEARINGS, 4.0)
    monkeypatch.setattr("rqt_mrta_py.sim.bullet.range_rays._AT_ONCE", 5000)
    np.testing.assert_array_equal(world.ranges(robots, BEARINGS, 4.0), whole)


def test_nobody_sees_nothing(world):
    world.reset(setup(Pose(0.0, 0.0)))
    assert world.ranges([], BEARINGS, 4.0).shape == (0, 90)
