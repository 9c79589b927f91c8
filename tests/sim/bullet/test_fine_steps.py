"""When BulletWorld goes in fine steps, and what is built by them."""

from __future__ import annotations

import hashlib
import math

import numpy as np
import pytest

from rqt_mrta_py.hooks import Body, Contact
from rqt_mrta_py.model import Pose, Twist
from rqt_mrta_py.sim.bullet import BulletWorld
from rqt_mrta_py.sim.robot_models import MECANUM_ARM
from tests.sim.worlds import TICK, run, setup

ARM = MECANUM_ARM.arm
BLOCK = (0.18, 0.07, 0.07)
MASS = 0.06
COARSE, FINE = 2, 6
"""Steps in a tick of 0.05 s: of 1/40 s, and of 1/120 s."""
SETTLED = 3.0
"""What blocks that were put down take to settle [s]."""


@pytest.fixture
def world():
    built = BulletWorld()
    yield built
    built.close()


def block(name, x, z=0.035):
    return Body(name, (x, 0.0, z), -math.pi / 2, BLOCK, MASS, 0.8)


def steps(world):
    """Count the physics steps of the next tick."""
    engine, counted = world._engine, []
    inner = engine.bullet

    class Counting:
        def __getattr__(self, name):
            if name == "stepSimulation":
                counted.append(1)
            return getattr(inner, name)

    engine.bullet = Counting()
    world.step()
    engine.bullet = inner
    return len(counted)


def test_steps_are_fine_only_while_blocks_settle_or_a_robot_or_what_it_holds_is_close_to_them(world):
    """Close is 3 cm at this length of a tick; with its arm lowered the magnet reaches 0.36 m ahead, or 0.18 m."""
    world.reset(setup(Pose(0.0, 0.0), model=MECANUM_ARM))
    assert steps(world) == COARSE
    world.add_body(block("near", 0.42))
    world.add_body(block("far", 2.0))
    assert steps(world) == FINE
    run(world, SETTLED)
    assert steps(world) == COARSE
    world.command("r0", "arm", ARM.lowest)
    run(world, 5.0)
    assert steps(world) == FINE
    world.remove_body("near")
    run(world, SETTLED)
    assert steps(world) == COARSE
    world.command("r0", "arm", ARM.highest)
    run(world, 5.0)
    world.add_body(block("held", 0.18 + 0.035, ARM.height_at(ARM.highest)))
    world.attach("r0", "held")
    run(world, SETTLED)
    assert steps(world) == COARSE
    world.add_body(Body("tall", (0.31, 0.0, 0.2), 0.0, (0.07, 0.07, 0.4), 1.0))
    run(world, SETTLED)
    assert steps(world) == FINE


def drive(world, x, y=0.0):
    """Bring the robot to a place, heading along the x axis, at 3 cm/s, the last stretch slower."""
    for _ in range(4000):
        off_x, off_y, yaw = world.poses()[0] - [x, y, 0.0]
        if max(abs(off_x), abs(off_y), abs(yaw)) < 1e-5:
            break
        vx, vy = (max(-0.03, min(0.03, -off / TICK / 2)) for off in (off_x, off_y))
        world.command("r0", "base", Twist(vx, vy, -2.0 * yaw))
        world.step()
    world.command("r0", "base", Twist())
    run(world, 0.2)


def lift(world, angle):
    world.command("r0", "arm", angle)
    while abs(world.arm_angles()["r0"] - angle) > 1e-5:
        world.step()
    run(world, 0.2)


def put_up_a_stack(world, levels=5):
    """Put blocks on one another; give where the stack was meant to stand, and the hash of all poses on the way."""
    places = [(0.0, level) for level in range(levels)]
    return put_up(world, places)


def put_up(world, places):
    """Take blocks one by one from where one always lies, and put them up behind it, by commands to the world alone.

    Args:
        world: to build in.
        places: how far to the left each shall lie [m], and on which level, from 0.

    Returns:
        How far ahead they were meant to lie [m], and the hash of all poses on the way.
    """
    source, goal = 0.5, 1.0
    digest = hashlib.sha256()
    world.reset(setup(Pose(-0.2, 0.0), model=MECANUM_ARM))
    for number, (left, level) in enumerate(places):
        name = f"b{number}"
        grip = ARM.angle_at(0.035)
        lift(world, grip)
        world.add_body(block(name, source))
        drive(world, source - 0.035 - ARM.reach_at(grip))
        world.attach("r0", name)
        drive(world, world.poses()[0, 0] - 0.1)
        drive(world, world.poses()[0, 0], left)
        # Over what stands already, then down on it, which the arc of the arm brings forward meanwhile.
        above = ARM.angle_at(0.035 + 0.07 * level + 0.01)
        down = ARM.angle_at(0.035 + 0.07 * level)
        lift(world, above)
        drive(world, goal - 0.035 - ARM.reach_at(down), left)
        lift(world, down)
        world.detach(name)
        drive(world, world.poses()[0, 0] - 0.25, left)
        lift(world, ARM.highest)
        drive(world, -0.2)
        digest.update(world.poses().tobytes())
        digest.update(np.array([state.position for state in world.bodies().values()]).tobytes())
    return goal, digest.hexdigest()


def test_stack_of_five_blocks_stands_where_it_was_put(world):
    """What stands does not creep while more is put on it."""
    goal, _ = put_up_a_stack(world)
    run(world, 5.0)
    places = np.array([state.position for state in world.bodies().values()])
    errors = np.hypot(places[:, 0] - goal, places[:, 1])
    assert places[:, 2] == pytest.approx(0.035 + 0.07 * np.arange(5), abs=2e-3)
    assert errors.mean() < 1e-3
    assert errors.max() < 1e-3


def test_wall_of_blocks_side_by_side_stands_where_it_was_put(world):
    """Three beside one another with 1 cm between them, two over their joints."""
    lefts = (-0.19, 0.0, 0.19, -0.095, 0.095)
    levels = (0, 0, 0, 1, 1)
    goal, _ = put_up(world, list(zip(lefts, levels)))
    run(world, 5.0)
    places = np.array([state.position for state in world.bodies().values()])
    errors = np.hypot(places[:, 0] - goal, places[:, 1] - lefts)
    assert places[:, 2] == pytest.approx(0.035 + 0.07 * np.array(levels), abs=1e-3)
    assert errors.max() < 1e-3


def test_what_rests_stays_to_a_hair_and_falls_when_its_support_is_gone(world):
    world.reset(setup(Pose(0.0, 0.0), model=MECANUM_ARM))
    for level in range(3):
        world.add_body(block(f"b{level}", 1.0, 0.035 + 0.07 * level))
    run(world, 10.0)
    before = world.bodies()
    run(world, 60.0)
    assert world.bodies() == before
    assert world.contacts() == (Contact("b0", "b1"), Contact("b1", "b2"))
    world.remove_body("b0")
    run(world, 2.0)
    heights = [state.position[2] for state in world.bodies().values()]
    assert heights == pytest.approx([0.035, 0.105], abs=2e-3)


def test_building_twice_gives_the_same_bytes(world):
    assert put_up_a_stack(world, 2) == put_up_a_stack(world, 2)
