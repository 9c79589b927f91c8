from __future__ import annotations

import math
from dataclasses import replace

import numpy as np
import pytest

from rqt_mrta_py.model import Pose, Twist
from rqt_mrta_py.sim.planar import PlanarWorld
from rqt_mrta_py.sim.planar.drive import LAG, Drive
from rqt_mrta_py.sim.robot_models import DIFF_DRIVE, OMNI_DRIVE
from tests.sim.worlds import run, setup

NOBODY = np.zeros(1, dtype=bool)


def driven(model, twist, seconds, parts=1, yaw=0.0):
    """Drive one robot from rest at the origin; give x, y, yaw."""
    drive, poses = Drive([model]), np.array([[0.0], [0.0], [yaw]])
    drive.command(0, twist)
    for _ in range(parts):
        drive.advance(poses, NOBODY, seconds / parts)
    return poses[:, 0]


@pytest.mark.parametrize("parts", [1, 7])
def test_speed_comes_up_to_the_command_with_the_lag_of_motors(parts):
    """The integral of v = u (1 - exp(-t / LAG)) from 0 to t is u (t - LAG (1 - exp(-t / LAG)))."""
    expected = 0.4 * (0.3 - LAG * (1.0 - math.exp(-0.3 / LAG)))
    x, y, yaw = driven(DIFF_DRIVE, Twist(0.4, 0.0, 0.0), 0.3, parts)
    assert (x, y, yaw) == (pytest.approx(expected, rel=1e-12), 0.0, 0.0)


@pytest.mark.parametrize("parts", [1, 20])
def test_robot_on_a_circle_stays_on_it_whatever_the_step(parts):
    """From rest speed and turn rate keep their ratio, so the circle of 0.4 / 0.8 = 0.5 m around (0, 0.5) is exact."""
    x, y, yaw = driven(DIFF_DRIVE, Twist(0.4, 0.0, 0.8), 1.0, parts)
    assert math.hypot(x, y - 0.5) == pytest.approx(0.5, abs=1e-12)
    assert yaw == pytest.approx(0.8 * (1.0 - LAG * (1.0 - math.exp(-1.0 / LAG))), rel=1e-12)


def test_commands_beyond_the_limits_are_obeyed_within_them():
    fast = driven(DIFF_DRIVE, Twist(7.0, 0.0, -9.0), 0.5)
    assert fast.tolist() == driven(DIFF_DRIVE, Twist(0.5, 0.0, -2.0), 0.5).tolist()


def test_command_of_any_finite_size_is_driven_at_full_speed_in_its_direction():
    x, y, _ = driven(OMNI_DRIVE, Twist(1.7e308, -1.7e308, 0.0), 2.0)
    assert math.atan2(y, x) == pytest.approx(-math.pi / 4)
    assert math.hypot(x, y) == pytest.approx(0.5 * (2.0 - LAG), rel=1e-9)


@pytest.mark.parametrize("speed", [0.0, 5e-324, 2e-309])
def test_command_too_small_to_divide_by_is_no_trouble(speed):
    x, y, _ = driven(DIFF_DRIVE, Twist(speed, 0.0, 0.0), 1.0)
    assert (x, y) == (pytest.approx(0.0, abs=1e-300), 0.0)


def test_omni_drive_goes_sideways_keeping_its_heading():
    x, y, yaw = driven(OMNI_DRIVE, Twist(0.0, 0.3, 0.0), 2.0, yaw=math.pi / 2)
    assert (x, y) == (pytest.approx(-0.3 * (2.0 - LAG), rel=1e-9), pytest.approx(0.0, abs=1e-9))
    assert yaw == math.pi / 2


def test_yaw_stays_within_half_a_turn_to_either_side():
    drive, poses = Drive([DIFF_DRIVE]), np.array([[0.0], [0.0], [3.1]])
    drive.command(0, Twist(0.0, 0.0, 2.0))
    yaws = []
    for _ in range(200):
        drive.advance(poses, NOBODY, 0.05)
        yaws.append(poses[2, 0])
    assert max(yaws) <= math.pi
    assert min(yaws) > -math.pi
    turned = 2.0 * (10.0 - LAG)
    assert math.remainder(yaws[-1] - 3.1 - turned, 2 * math.pi) == pytest.approx(0.0, abs=1e-9)


def test_robot_that_was_held_up_starts_from_rest():
    """A wall must not store speed: backing off begins as if from a stand."""
    world = PlanarWorld()
    world.reset(setup(Pose(2.8, 0.0)))
    world.command("r0", "base", Twist(0.5, 0.0, 0.0))
    run(world, 2.0)
    at_wall = world.poses()[0, 0]
    world.command("r0", "base", Twist(-0.5, 0.0, 0.0))
    run(world, 0.1)
    from_rest = 0.5 * (0.1 - LAG * (1.0 - math.exp(-0.1 / LAG)))
    assert at_wall - world.poses()[0, 0] == pytest.approx(from_rest, rel=1e-6)


def test_slow_model_is_slow():
    world = PlanarWorld()
    world.reset(setup(Pose(0.0, 0.0), model=replace(DIFF_DRIVE, max_speed=0.1)))
    world.command("r0", "base", Twist(0.5, 0.0, 0.0))
    run(world, 2.0)
    assert world.poses()[0, 0] == pytest.approx(0.1 * (2.0 - LAG), rel=1e-6)
