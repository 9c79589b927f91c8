"""Which blocks are fixed where they lie, and what sets them free."""

from __future__ import annotations

import math

import numpy as np
import pytest

from rqt_mrta_py.errors import SimError
from rqt_mrta_py.hooks import Body, Contact
from rqt_mrta_py.model import Pose, Twist
from rqt_mrta_py.sim.bullet import BulletWorld
from rqt_mrta_py.sim.robot_models import MECANUM_ARM
from tests.sim.worlds import run, setup

ARM = MECANUM_ARM.arm
MASS = 0.06
LONG, SHORT = (0.18, 0.07, 0.07), (0.06, 0.07, 0.07)
SETTLED = 2.0


@pytest.fixture
def world():
    built = BulletWorld()
    built.reset(setup(Pose(-1.0, 0.0), model=MECANUM_ARM))
    yield built
    built.close()


def block(name, x, level=1, size=LONG, yaw=0.0):
    return Body(name, (x, 0.0, 0.035 + 0.07 * (level - 1)), yaw, size, MASS, 0.8)


def place(world, name):
    return np.array(world.bodies()[name].position)


def is_fixed(world, name):
    """What is fixed has no mass to the engine."""
    engine = world._engine
    mass = engine.bullet.getDynamicsInfo(world._bodies.number(name), -1, physicsClientId=engine.client)[0]
    return mass == 0.0


def test_block_that_lies_still_is_fixed_and_one_that_falls_is_not(world):
    world.add_body(block("lying", 1.0))
    world.add_body(block("falling", 1.5, level=20))
    world.step()
    assert not is_fixed(world, "falling")
    run(world, SETTLED)
    assert is_fixed(world, "lying")
    assert is_fixed(world, "falling")
    assert place(world, "falling")[2] == pytest.approx(0.035, abs=1e-3)


def test_wall_stands_where_it_was_put_and_tells_its_contacts(world):
    names = []
    for level in (1, 2, 3):
        for number in range(2):
            names.append(f"b{level}{number}")
            world.add_body(block(names[-1], 1.0 + 0.24 * number + 0.04 * (level % 2), level))
    run(world, SETTLED)
    before = world.bodies()
    run(world, 20.0)
    assert world.bodies() == before
    assert world.contacts() == tuple(Contact(f"b{level}{n}", f"b{level + 1}{n}") for level in (1, 2) for n in (0, 1))


def test_block_in_the_middle_that_is_carried_away_takes_along_what_stands_on_it(world):
    for level in (1, 2, 3):
        world.add_body(block(f"b{level}", 0.0, level, size=SHORT, yaw=-math.pi / 2))
    run(world, SETTLED)
    angle = ARM.angle_at(0.105)
    world.command("r0", "arm", angle)
    run(world, 5.0)
    world.command("r0", "base", Twist(0.1))
    while float(world.poses()[0, 0]) < -0.035 - ARM.reach_at(angle) - 0.003:
        world.step()
    world.command("r0", "base", Twist())
    run(world, 0.5)
    world.attach("r0", "b2")
    world.command("r0", "base", Twist(-0.05))
    run(world, 4.0)
    assert place(world, "b2")[0] < -0.15
    assert place(world, "b3") == pytest.approx(place(world, "b2") + [0.0, 0.0, 0.07], abs=5e-3)
    assert place(world, "b1") == pytest.approx([0.0, 0.0, 0.035], abs=1e-3)


def test_block_that_a_robot_runs_into_is_pushed_and_falls_off_what_bears_it(world):
    for level in (1, 2):
        world.add_body(block(f"b{level}", 0.0, level, yaw=math.pi / 2))
    run(world, SETTLED)
    world.command("r0", "arm", ARM.angle_at(0.105))
    run(world, 5.0)
    world.command("r0", "base", Twist(0.05))
    run(world, 16.0)
    assert place(world, "b2")[2] == pytest.approx(0.035, abs=5e-3)


def test_pushed_block_pushes_the_next(world):
    world.add_body(block("b1", 0.0, yaw=math.pi / 2))
    world.add_body(block("b2", 0.1, yaw=math.pi / 2))
    run(world, SETTLED)
    world.command("r0", "base", Twist(0.1))
    run(world, 12.0)
    first, second = place(world, "b1"), place(world, "b2")
    assert first[0] == pytest.approx(float(world.poses()[0, 0]) + 0.14 + 0.035, abs=0.01)
    assert second[0] == pytest.approx(first[0] + 0.07, abs=0.01)


@pytest.mark.parametrize(("x", "tips"), [(1.02, False), (1.07, True)])
def test_load_beyond_what_bears_a_block_tips_it(world, x, tips):
    """A long block on a short one that ends at 1.03 m: a load at 1.07 m turns it by twice what its own weight holds."""
    world.add_body(block("short", 1.0, size=SHORT))
    world.add_body(block("long", 1.0, level=2))
    run(world, SETTLED)
    assert is_fixed(world, "long")
    world.add_body(Body("load", (x, 0.0, 0.176), 0.0, SHORT, 0.15, 0.8))
    run(world, SETTLED)
    assert bool(place(world, "load")[2] < 0.12) is tips


def test_light_load_beyond_what_bears_a_block_does_not_tip_it_and_all_rests_again(world):
    world.add_body(block("short", 1.0, size=SHORT))
    world.add_body(block("long", 1.0, level=2))
    run(world, SETTLED)
    world.add_body(Body("load", (1.07, 0.0, 0.176), 0.0, SHORT, 0.01, 0.8))
    run(world, SETTLED)
    assert place(world, "load")[2] == pytest.approx(0.175, abs=2e-3)
    assert is_fixed(world, "long")
    assert is_fixed(world, "load")


def test_block_on_a_robot_is_not_fixed(world):
    world.add_body(Body("rider", (-1.05, 0.0, 0.145 + 0.035), 0.0, SHORT, MASS, 0.8))
    run(world, SETTLED)
    assert not is_fixed(world, "rider")


def test_removed_block_frees_what_stood_on_it_and_that_what_stood_on_that(world):
    for level in (1, 2, 3):
        world.add_body(block(f"b{level}", 1.0, level))
    run(world, SETTLED)
    world.remove_body("b1")
    run(world, SETTLED)
    assert [place(world, name)[2] for name in ("b2", "b3")] == pytest.approx([0.035, 0.105], abs=1e-3)
    assert world.contacts() == (Contact("b2", "b3"),)


def test_bodies_that_come_after_a_robot_was_removed_come_to_rest(world):
    """PyBullet gives the numbers of bodies that are gone to new ones."""
    world.reset(setup(Pose(-1.0, 0.0), Pose(-1.0, 1.0), model=MECANUM_ARM))
    world.add_body(block("b1", 1.0))
    run(world, SETTLED)
    world.remove_robot("r1")
    assert list(world.arm_angles()) == ["r0"]
    world.command("r1", "arm", 0.5)
    for number in (2, 3, 4):
        world.add_body(block(f"b{number}", 1.0, number))
    run(world, SETTLED)
    assert all(is_fixed(world, f"b{number}") for number in (1, 2, 3, 4))
    assert world.contacts() == tuple(Contact(f"b{number}", f"b{number + 1}") for number in (1, 2, 3))
    with pytest.raises(SimError, match="robot r1: arm takes a finite angle"):
        world.command("r1", "arm", math.inf)
