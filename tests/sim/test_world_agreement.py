"""Worlds drive alike and see alike: a mission may choose the one that is quick or the one that is true."""

from __future__ import annotations

import math

import numpy as np
import pytest

from rqt_mrta_py.hooks import Body
from rqt_mrta_py.model import Obstacle, Pose, Twist
from tests.sim.worlds import TICK, WORLDS, setup


@pytest.fixture
def worlds():
    made = {name: factory() for name, factory in sorted(WORLDS.items())}
    yield made
    for world in made.values():
        world.close()


@pytest.mark.parametrize(
    ("twist", "metres", "radians"),
    [
        (Twist(0.4, 0.0, 0.0), 0.02, 0.005),
        (Twist(-0.3, 0.0, 0.0), 0.02, 0.005),
        (Twist(0.0, 0.0, 1.0), 0.01, 0.08),
        (Twist(0.4, 0.0, 0.6), 0.06, 0.08),
        (Twist(0.3, 0.0, -1.5), 0.06, 0.08),
    ],
    ids=["straight", "backwards", "spin", "circle to the left", "circle to the right"],
)
def test_worlds_drive_the_same_path_from_rest_to_rest(worlds, twist, metres, radians):
    paths = []
    for world in worlds.values():
        world.reset(setup(Pose(0.0, 0.0, 0.7)))
        path = []
        for tick in range(80):
            world.command("r0", "base", twist if tick < 60 else Twist())
            world.step()
            path.append(world.poses()[0])
        paths.append(np.array(path))
    off = paths[1] - paths[0]
    assert np.hypot(off[:, 0], off[:, 1]).max() < metres
    assert np.abs(np.arctan2(np.sin(off[:, 2]), np.cos(off[:, 2]))).max() < radians
    travelled = np.hypot(*np.diff(paths[0][:, :2], axis=0).T).sum()
    assert travelled == pytest.approx(60 * TICK * abs(twist.vx), abs=0.05)


def test_worlds_see_the_same(worlds):
    obstacles = [
        Obstacle("wedge", Pose(0.9, 0.7, 0.6), (0.8, 0.1, 0.4)),
        Obstacle("post", Pose(-0.8, 0.9), (0.3, 0.3, 0.4), "cylinder"),
        Obstacle("kerb", Pose(0.0, -1.0), (2.0, 0.1, 0.1)),
    ]
    starts = [Pose(0.0, 0.0, 0.3), Pose(1.0, -0.6, 2.0), Pose(-1.5, -0.4, -1.1), Pose(-0.4, 2.0, 1.5)]
    robots = [f"r{index}" for index in range(len(starts))]
    bearings = np.linspace(-math.pi, math.pi, 120, endpoint=False)
    seen = []
    for world in worlds.values():
        world.reset(setup(*starts, obstacles=obstacles))
        world.add_body(Body("block", (0.3, 1.2, 0.1), 0.4, (0.2, 0.3, 0.2), 0.5))
        seen.append(world.ranges(robots, bearings, 2.5))
    assert 0.2 < np.isfinite(seen[0]).mean() < 0.9
    # A ray along an edge may hit in one world and miss in the other.
    agree = np.isclose(seen[0], seen[1], atol=3e-3)
    assert agree.mean() > 0.99
