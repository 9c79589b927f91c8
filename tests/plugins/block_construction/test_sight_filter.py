"""Looks at blocks, averaged as far as eyes err, against statistics and hand calculation."""

from __future__ import annotations

import math

import numpy as np
import pytest
from block_construction.building.sight_filter import Place, SightFilter

from rqt_mrta_py.model import Pose

HERE = Pose(1.0, 1.0, 0.0)
SIGHT = 0.003


def noisy(random, x, y, z=0.035):
    dx, dy = random.normal(0.0, SIGHT, 2)
    return {"b1": Place(x + dx, y + dy, z)}


def test_of_exact_eyes_the_newest_look_counts():
    eyes = SightFilter()
    for tick in range(10):
        there = {"b1": Place(0.5 - 0.001 * tick, 0.01, 0.035)}
        robot = Pose(1.0 + 0.001 * tick, 1.0, 0.0)
        assert eyes.take(there, robot, None)["b1"][:3] == pytest.approx(there["b1"][:3], abs=1e-12)
    assert eyes.noise == pytest.approx(0.0, abs=1e-12)


def test_looks_of_a_robot_that_stands_are_averaged():
    """Of 50 looks that are off by 3 mm, the mean is off by 3 mm / sqrt(50) = 0.42 mm; 30 x 2 draws tell it to 10 %."""
    random = np.random.default_rng(3)
    off, learnt = [], []
    for _ in range(30):
        eyes = SightFilter()
        for _ in range(50):
            place = eyes.take(noisy(random, 0.5, 0.1), HERE, HERE)["b1"]
        off += [place.x - 0.5, place.y - 0.1]
        learnt.append(eyes.noise)
    assert math.sqrt(np.mean(np.square(off))) == pytest.approx(0.00042, rel=0.3)
    assert np.mean(learnt) == pytest.approx(SIGHT, rel=0.05)


def test_robot_that_creeps_goes_by_its_wheels_and_not_by_where_it_believes_to_be():
    """It creeps 5 mm a look, while what it is told of its x jumps by 1 cm; wheels count in a frame of their own."""
    random = np.random.default_rng(4)
    eyes = SightFilter()
    for _ in range(40):
        eyes.take(noisy(random, 0.5, 0.0), HERE, Pose(7.0, 7.0, math.pi / 2))
    place = Place(0.0, 0.0, 0.0)
    for tick in range(1, 11):
        robot, wheels = Pose(1.0 + 0.005 * tick + 0.01 * (tick % 2), 1.0, 0.0), Pose(7.0, 7.0 + 0.005 * tick, 1.570796)
        place = eyes.take(noisy(random, 0.5 - 0.005 * tick, 0.0), robot, wheels)["b1"]
    assert (place.x, place.y) == pytest.approx((0.45, 0.0), abs=0.0018)


@pytest.mark.parametrize("there", [(0.53, 0.1, 0.035), (0.5, 0.1, 0.105)])
def test_block_that_is_moved_is_seen_at_once_where_it_lies_now(there):
    random = np.random.default_rng(5)
    eyes = SightFilter()
    for _ in range(50):
        eyes.take(noisy(random, 0.5, 0.1), HERE, HERE)
    assert eyes.take({"b1": Place(*there)}, HERE, HERE)["b1"][:3] == pytest.approx(there)
    assert eyes.noise < 0.004
