"""How the robot with mecanum wheels and an arm moves in BulletWorld, and what it runs into."""

from __future__ import annotations

import math

import numpy as np
import pytest

from rqt_mrta_py.errors import SimError
from rqt_mrta_py.hooks import Body, Contact
from rqt_mrta_py.model import Obstacle, Pose, Twist
from rqt_mrta_py.sim.bullet import BulletWorld
from rqt_mrta_py.sim.robot_models import MECANUM_ARM
from tests.sim.worlds import run, setup

ARM = MECANUM_ARM.arm
BLOCK = (0.18, 0.07, 0.07)
MASS = 0.06


@pytest.fixture
def world():
    built = BulletWorld()
    yield built
    built.close()


def builders(*starts, obstacles=()):
    return setup(*starts, obstacles=obstacles, model=MECANUM_ARM)


@pytest.mark.parametrize("yaw", [0.0, 1.0, -2.5])
def test_robot_drives_ahead_and_sideways_as_commanded_from_where_it_is_put(world, yaw):
    world.reset(builders(Pose(0.5, -0.5, yaw)))
    assert world.poses()[0] == pytest.approx([0.5, -0.5, yaw])
    world.command("r0", "base", Twist(0.03, 0.04, 0.0))
    run(world, 0.5)
    before = world.poses()[0]
    run(world, 2.0)
    x, y, turn = world.poses()[0] - before
    ahead, left = math.cos(yaw) * x + math.sin(yaw) * y, math.cos(yaw) * y - math.sin(yaw) * x
    assert (ahead, left, turn) == pytest.approx((0.06, 0.08, 0.0), abs=2e-4)


def test_robot_turns_on_the_spot(world):
    world.reset(builders(Pose(1.0, 1.0)))
    world.command("r0", "base", Twist(wz=0.08))
    run(world, 10.0)
    assert world.poses()[0] == pytest.approx([1.0, 1.0, 0.8], abs=2e-3)


def test_robot_that_shall_drive_and_turn_too_fast_does_both_slower_by_one_share(world):
    """At 0.2 m/s ahead and 1 rad/s, two wheels would have to do 0.2 + 0.19 m/s; they do 0.2: a share of 20 / 39."""
    world.reset(builders(Pose(0.0, 0.0)))
    world.command("r0", "base", Twist(0.2, 0.0, 1.0))
    run(world, 1.0)
    before = world.poses()[0]
    run(world, 0.05)
    x, y, turn = world.poses()[0] - before
    assert turn == pytest.approx(0.05 * 20.0 / 39.0, rel=1e-3)
    assert math.hypot(x, y) == pytest.approx(0.01 * 20.0 / 39.0, rel=1e-2)


def test_robot_stands_still_to_a_hair_without_a_command(world):
    world.reset(builders(Pose(0.0, 0.0, 0.3)))
    run(world, 20.0)
    assert world.poses()[0] == pytest.approx([0.0, 0.0, 0.3], abs=1e-4)


def test_arm_goes_to_its_angle_at_its_rate_and_stays_there(world):
    world.reset(builders(Pose(0.0, 0.0)))
    assert world.arm_angles() == {"r0": pytest.approx(math.pi / 2)}
    world.command("r0", "arm", 0.0)
    run(world, 1.0)
    assert world.arm_angles()["r0"] == pytest.approx(math.pi / 2 - ARM.rate, abs=0.02)
    run(world, 3.0)
    assert world.arm_angles()["r0"] == pytest.approx(0.0, abs=1e-4)
    world.command("r0", "arm", -9.0)
    run(world, 3.0)
    assert world.arm_angles()["r0"] == pytest.approx(ARM.lowest, abs=1e-4)


@pytest.mark.parametrize("angle", [math.nan, math.inf, Twist(), True])
def test_arm_refuses_what_is_no_angle(world, angle):
    world.reset(builders(Pose(0.0, 0.0)))
    with pytest.raises(SimError, match=r"^robot r0: arm takes a finite angle \[rad\] \(got "):
        world.command("r0", "arm", angle)


def test_robot_is_stopped_by_walls_obstacles_and_frozen_robots_and_touches_them(world):
    rock = Obstacle("rock", Pose(0.0, 1.0), (0.4, 0.4, 0.4))
    world.reset(builders(Pose(2.6, 0.0), Pose(-0.5, 1.0), Pose(-1.0, -1.0), Pose(-0.5, -1.0), obstacles=[rock]))
    world.freeze("r3", True)
    for robot in ("r0", "r1", "r2", "r3"):
        world.command(robot, "base", Twist(0.2))
    run(world, 4.0)
    reach = ARM.reach_at(math.pi / 2)
    x = world.poses()[:, 0]
    assert x[0] == pytest.approx(3.0 - MECANUM_ARM.length / 2, abs=0.005)
    assert x[1] == pytest.approx(-0.2 - reach, abs=0.005)
    assert x[3] == pytest.approx(-0.5, abs=1e-4)
    assert world.contacts() == (Contact("r0", "wall"), Contact("r1", "rock"), Contact("r2", "r3"))
    world.freeze("r3", False)
    run(world, 1.0)
    assert world.poses()[3, 0] > -0.4


def test_robot_pushes_a_block_and_another_robot(world):
    world.reset(builders(Pose(0.0, 0.0), Pose(0.0, 1.0), Pose(0.6, 1.0)))
    world.add_body(Body("block", (0.4, 0.0, 0.035), math.pi / 2, BLOCK, MASS, 0.8))
    world.command("r0", "base", Twist(0.1))
    world.command("r1", "base", Twist(0.1))
    run(world, 5.0)
    assert world.contacts() == (Contact("block", "r0"), Contact("r1", "r2"))
    assert world.bodies()["block"].position[0] == pytest.approx(0.5 + 0.14 + 0.035, abs=0.03)
    assert world.poses()[2, 0] > 0.65


def test_lowered_arm_knocks_a_stack_over(world):
    """The magnet at the second of three blocks comes 4 cm too far."""
    world.reset(builders(Pose(0.0, 0.0)))
    world.command("r0", "arm", ARM.angle_at(0.175))
    run(world, 4.0)
    face = ARM.reach_at(ARM.angle_at(0.175))
    for level in range(3):
        world.add_body(Body(f"b{level}", (face + 0.06, 0.0, 0.035 + 0.07 * level), math.pi / 2, BLOCK, MASS, 0.8))
    run(world, 2.0)
    assert world.bodies()["b2"].position[2] == pytest.approx(0.175, abs=0.002)
    world.command("r0", "base", Twist(0.05))
    run(world, 3.0)
    assert world.bodies()["b2"].position[2] < 0.12


def test_carried_block_keeps_its_offset_on_the_way_up_and_around(world):
    world.reset(builders(Pose(0.0, 0.0)))
    angle = ARM.angle_at(0.035)
    world.command("r0", "arm", angle)
    run(world, 5.0)
    world.add_body(Body("block", (ARM.reach_at(angle) + 0.035, 0.0, 0.035), math.pi / 2, BLOCK, MASS, 0.8))
    world.attach("r0", "block")
    world.command("r0", "arm", math.pi / 2)
    run(world, 5.0)
    world.command("r0", "base", Twist(0.1, 0.05, 0.5))
    run(world, 3.0)
    world.command("r0", "base", Twist())
    run(world, 1.0)
    x, y, yaw = world.poses()[0]
    ahead = ARM.reach_at(math.pi / 2) + 0.035
    expected = (x + ahead * math.cos(yaw), y + ahead * math.sin(yaw), ARM.height_at(math.pi / 2))
    assert world.bodies()["block"].position == pytest.approx(expected, abs=1e-3)
    world.detach("block")
    run(world, 2.0)
    assert world.bodies()["block"].position[2] < 0.08


def test_range_finder_sees_a_mecanum_robot_and_not_its_own_chassis(world):
    world.reset(builders(Pose(0.0, 0.0), Pose(1.0, 0.0, math.pi)))
    seen = world.ranges(["r0"], np.array([0.0, math.pi / 2]), 10.0)[0]
    assert seen == pytest.approx([1.0 - MECANUM_ARM.length / 2, 3.0], abs=1e-3)
