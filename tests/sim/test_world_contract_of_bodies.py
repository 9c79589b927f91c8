"""What every world promises of loose bodies, whatever is behind it."""

from __future__ import annotations

import math
from dataclasses import replace

import numpy as np
import pytest

from rqt_mrta_py.errors import SimError
from rqt_mrta_py.hooks import Body, Contact, World
from rqt_mrta_py.model import Obstacle, Pose, Twist
from rqt_mrta_py.sim.robot_models import CARRIER, DIFF_DRIVE, STRONG_CARRIER
from tests.sim.worlds import run, setup

FRONT = DIFF_DRIVE.length / 2
BLOCK = Body("block", (0.3, 0.0, 0.1), 0.0, (0.2, 0.2, 0.2), 0.5)


def relative(world: World, robot: int, body_id: str) -> np.ndarray:
    """Give where a body is as seen by a robot [m]."""
    x, y, yaw = world.poses()[robot]
    bx, by, _ = world.bodies()[body_id].position
    dx, dy = bx - x, by - y
    return np.array([math.cos(yaw) * dx + math.sin(yaw) * dy, math.cos(yaw) * dy - math.sin(yaw) * dx])


def test_loose_body_is_seen_where_it_is_and_over_its_top(world):
    world.reset(setup(Pose(-1.0, 0.0)))
    world.add_body(replace(BLOCK, position=(0.0, 0.0, 0.1)))
    assert world.ranges(["r0"], np.zeros(1), 4.0)[0][0] == pytest.approx(1.0 - 0.1, abs=3e-3)
    world.remove_body("block")
    world.add_body(replace(BLOCK, position=(0.0, 0.0, 0.05), size=(0.2, 0.2, 0.1)))
    assert world.ranges(["r0"], np.zeros(1), 4.5)[0][0] == pytest.approx(4.0, abs=3e-3)


def test_body_is_pushed_ahead_of_a_robot(world):
    world.reset(setup(Pose(0.0, 0.0)))
    world.add_body(BLOCK)
    world.command("r0", "base", Twist(0.3, 0.0, 0.0))
    run(world, 2.0)
    assert world.bodies()["block"].position[0] > 0.5
    assert relative(world, 0, "block")[0] > FRONT + 0.1 - 0.01


def test_attached_body_travels_with_its_robot_and_stays_when_let_go(world):
    world.reset(setup(Pose(0.0, 0.0)))
    world.add_body(BLOCK)
    world.attach("r0", "block")
    held = relative(world, 0, "block")
    world.command("r0", "base", Twist(0.2, 0.0, 0.5))
    run(world, 2.0)
    np.testing.assert_allclose(relative(world, 0, "block"), held, atol=0.01)
    assert world.poses()[0, 2] > 0.7
    world.command("r0", "base", Twist())
    run(world, 0.5)
    world.detach("block")
    world.command("r0", "base", Twist(-0.3, 0.0, 0.0))
    left = world.bodies()["block"].position
    run(world, 2.0)
    np.testing.assert_allclose(world.bodies()["block"].position, left, atol=0.02)


def test_bodies_are_listed_in_the_order_of_their_adding_until_removed(world):
    world.reset(setup(Pose(-2.0, 0.0)))
    for index, name in enumerate(["b", "a", "c"]):
        world.add_body(replace(BLOCK, id=name, position=(index * 0.5, 0.0, 0.1)))
    assert list(world.bodies()) == ["b", "a", "c"]
    world.attach("r0", "a")
    world.remove_body("a")
    assert list(world.bodies()) == ["b", "c"]
    world.add_body(replace(BLOCK, id="a"))
    assert list(world.bodies()) == ["b", "c", "a"]


def test_body_cannot_take_an_id_in_use(world):
    world.reset(setup(Pose(-2.0, 0.0), obstacles=[Obstacle("rock", Pose(1.0, 1.0), (0.2, 0.2, 0.2))]))
    world.add_body(BLOCK)
    for taken in ("block", "r0", "rock", "wall"):
        with pytest.raises(SimError, match=rf"body {taken}: the id is taken"):
            world.add_body(replace(BLOCK, id=taken))


@pytest.mark.parametrize(
    "change", [{"mass": 0.0}, {"size": (0.1, -0.1, 0.1)}, {"position": (0.0, math.nan, 0.0)}, {"friction": -1.0}]
)
def test_body_of_impossible_numbers_is_refused(world, change):
    world.reset(setup())
    with pytest.raises(SimError, match="body block: size and mass must be above 0"):
        world.add_body(replace(BLOCK, **change))
    assert world.bodies() == {}


def test_unknown_body_is_refused_by_name(world):
    world.reset(setup(Pose(-2.0, 0.0)))
    world.add_body(BLOCK)
    for call in (world.remove_body, world.detach, lambda name: world.attach("r0", name)):
        with pytest.raises(SimError, match=r"body brick: there is no such body; there are: block"):
            call("brick")


def test_body_is_held_by_one_robot_at_a_time(world):
    world.reset(setup(Pose(0.0, 0.0), Pose(0.6, 0.0, math.pi)))
    world.add_body(BLOCK)
    with pytest.raises(SimError, match="body block: not attached to any robot"):
        world.detach("block")
    world.attach("r0", "block")
    with pytest.raises(SimError, match="body block: attached to r0 already"):
        world.attach("r1", "block")


@pytest.mark.parametrize(("model", "mass"), [(CARRIER, 0.5), (STRONG_CARRIER, 4.0)], ids=["carrier", "strong_carrier"])
def test_robot_with_its_heaviest_load_turns_on_the_spot(world, model, mass):
    """What was dragged over the floor once kept its robot from turning in PyBullet."""
    world.reset(setup(Pose(0.0, 0.0), model=model))
    world.add_body(replace(BLOCK, position=(model.radius + 0.15, 0.0, 0.05), size=(0.1, 0.1, 0.1), mass=mass))
    world.attach("r0", "block")
    world.command("r0", "base", Twist(0.0, 0.0, 1.0))
    run(world, 3.0)
    x, y, yaw = world.poses()[0]
    assert yaw == pytest.approx(3.0, rel=0.1)
    assert math.hypot(x, y) < 0.05


@pytest.mark.parametrize("model", [CARRIER, STRONG_CARRIER], ids=lambda model: model.name)
def test_carried_body_does_not_push_its_robot_away(world, model):
    world.reset(setup(Pose(0.0, 0.0, 0.5), model=model))
    ahead = model.radius + 0.06
    place = (ahead * math.cos(0.5), ahead * math.sin(0.5), 0.05)
    world.add_body(replace(BLOCK, position=place, yaw=0.5, size=(0.1, 0.1, 0.1), mass=model.max_load))
    world.attach("r0", "block")
    held = relative(world, 0, "block")
    run(world, 5.0)
    np.testing.assert_allclose(world.poses(), [[0.0, 0.0, 0.5]], atol=5e-3)
    np.testing.assert_allclose(relative(world, 0, "block"), held, atol=5e-3)
    assert world.contacts() == ()


def test_what_is_taken_away_touches_nothing_any_more(world):
    world.reset(setup(Pose(0.0, 0.0), Pose(-1.0, 0.0)))
    world.add_body(BLOCK)
    for robot in ("r0", "r1"):
        world.command(robot, "base", Twist(0.3, 0.0, 0.0))
    run(world, 2.0)
    assert Contact("block", "r0") in world.contacts()
    world.remove_body("block")
    assert world.contacts() == ()
    world.command("r0", "base", Twist())
    run(world, 4.0)
    assert world.contacts() == (Contact("r0", "r1"),)
    world.remove_robot("r0")
    assert world.contacts() == ()


def test_body_let_go_is_hard_to_push_again(world):
    """Friction is off while a body is carried; a body that kept gliding would not lie where it was put down."""
    world.reset(setup(Pose(0.0, 0.0)))
    world.add_body(BLOCK)
    world.attach("r0", "block")
    world.command("r0", "base", Twist(0.4, 0.0, 0.0))
    run(world, 1.5)
    world.detach("block")
    world.command("r0", "base", Twist(-0.4, 0.0, 0.0))
    run(world, 0.5)
    before = world.bodies()["block"].position
    run(world, 1.0)
    np.testing.assert_allclose(world.bodies()["block"].position, before, atol=2e-3)


def test_robot_takes_over_what_another_lets_go(world):
    world.reset(setup(Pose(0.0, 0.0), Pose(0.6, 0.0, math.pi)))
    world.add_body(BLOCK)
    world.attach("r0", "block")
    world.detach("block")
    world.attach("r1", "block")
    world.command("r1", "base", Twist(-0.3, 0.0, 0.0))
    run(world, 2.0)
    assert world.bodies()["block"].position[0] > 0.75
    np.testing.assert_allclose(world.poses()[0], [0.0, 0.0, 0.0], atol=0.02)


def test_removed_robot_takes_along_what_it_holds_and_leaves_what_it_let_go(world):
    world.reset(setup(Pose(0.0, 0.0), Pose(0.0, 1.0)))
    world.add_body(BLOCK)
    world.add_body(replace(BLOCK, id="left", position=(0.3, 1.0, 0.1)))
    world.add_body(replace(BLOCK, id="other", position=(0.3, -1.0, 0.1)))
    world.attach("r0", "block")
    world.attach("r1", "left")
    world.step()
    world.remove_robot("r0")
    assert list(world.bodies()) == ["left", "other"]
    world.detach("left")
    world.remove_robot("r1")
    run(world, 0.5)
    assert list(world.bodies()) == ["left", "other"]
    assert world.contacts() == ()
    world.add_body(BLOCK)
    world.step()
    assert list(world.bodies()) == ["left", "other", "block"]
