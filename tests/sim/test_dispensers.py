"""Places where loose bodies come from."""

from __future__ import annotations

import math
from dataclasses import replace

import pytest

from rqt_mrta_py.hooks import Body, TeamHeard
from rqt_mrta_py.model import (
    Dispenser,
    LooseBody,
    Pose,
    RobotSetup,
    ScenarioEvent,
    ScenarioEventKind,
    SensorSetup,
    Twist,
)
from tests.sim.doubles import StillWorld
from tests.sim.scenarios import RATE, scenario, simulation

PLACE = Dispenser("sw3", Pose(0.0, 0.0, math.pi / 2), (0.18, 0.07, 0.07), 0.06, "block3", 0.8, stock=3)
REMOVED = ScenarioEventKind.ROBOT_REMOVED
LOOK = RATE // 2
"""So many ticks after another it is looked whether something was carried off."""


class Yard:
    """A scenario that nobody commands, in which a hand moves things."""

    def __init__(self, world, *robots, dispensers=(PLACE,), bodies=(), events=()):
        team = robots or (RobotSetup("r1", "diff_drive", Pose(2.0, 2.0)),)
        self.simulated = simulation(scenario(*events, robots=team, bodies=bodies, dispensers=dispensers, world=world))
        self.world = self.simulated.world
        self.tick = 0

    def look(self):
        """Let a second pass; give the bodies by their ids."""
        for _ in range(2 * LOOK):
            self.simulated.begin_tick(self.tick, self.tick / RATE)
            self.simulated.step()
            self.tick += 1
        return list(self.world.bodies())

    def take(self, name, robot="r1"):
        self.world.attach(robot, name)


@pytest.fixture(params=["planar", "bullet"])
def yard(request):
    built = []

    def build(*robots, **setup):
        built.append(Yard(request.param, *robots, **setup))
        return built[-1]

    yield build
    for each in built:
        each.simulated.close()


def carry_off(yard, name, seconds):
    """Let r1 take a body and drive backwards at 0.2 m/s."""
    yard.take(name)
    yard.world.command("r1", "base", Twist(-0.2, 0.0, 0.0))
    seen = [yard.look() for _ in range(seconds)]
    yard.world.command("r1", "base", Twist())
    return seen


def test_first_body_lies_there_at_the_start_and_no_other_comes_while_it_does(yard):
    site = yard()
    assert list(site.world.bodies()) == ["sw3_1"]
    assert site.look() == ["sw3_1"]
    x, y, z = site.world.bodies()["sw3_1"].position
    assert (x, y, z) == pytest.approx((0.0, 0.0, 0.035), abs=0.001)


def test_next_body_appears_once_the_last_is_farther_than_its_length_and_none_when_the_stock_is_out(yard):
    site = yard(RobotSetup("r1", "carrier", Pose(-0.3, 0.0)))
    after_one, after_two = carry_off(site, "sw3_1", 2)
    assert (after_one, after_two) == (["sw3_1"], ["sw3_1", "sw3_2"])
    assert site.world.bodies()["sw3_2"].position == pytest.approx((0.0, 0.0, 0.035), abs=0.001)
    site.world.remove_body("sw3_2")
    assert site.look() == ["sw3_1", "sw3_3"]
    site.world.remove_body("sw3_3")
    assert site.look() == ["sw3_1"]


def test_without_a_stock_there_are_as_many_as_are_needed(yard):
    site = yard(dispensers=(replace(PLACE, stock=None),))
    for number in range(1, 6):
        assert site.look() == [f"sw3_{number}"]
        site.world.remove_body(f"sw3_{number}")


@pytest.mark.parametrize(("x", "comes"), [(0.20, False), (0.25, True)])
def test_no_body_appears_where_a_robot_stands(yard, x, comes):
    """The robot's radius is 0.19 m; the body reaches 0.035 m towards it."""
    site = yard(RobotSetup("r1", "diff_drive", Pose(0.30, 0.0)))
    site.world.remove_body("sw3_1")
    site.world.command("r1", "base", Twist(-0.05, 0.0, 0.0))
    while float(site.world.poses()[0, 0]) > x:
        site.world.step()
    site.world.freeze("r1", True)
    assert site.look() == (["sw3_2"] if comes else [])


def test_body_appears_where_a_robot_stood_that_was_removed_with_the_last_one(yard):
    site = yard(RobotSetup("r1", "carrier", Pose(-0.3, 0.0)), events=(ScenarioEvent(1.0, REMOVED, "r1"),))
    site.simulated.grippers.listener(["r1"])[1](TeamHeard([0], [0.0], [{"data": 1.0}]))
    site.simulated.act(0.0)
    assert dict(site.simulated.grippers.held) == {"sw3_1": "r1"}
    assert site.look() == ["sw3_1"]
    assert site.look() == ["sw3_2"]
    assert dict(site.simulated.grippers.held) == {}


def test_no_body_appears_where_another_lies(yard):
    site = yard(bodies=(LooseBody("stone", Pose(1.0, 1.0), (0.1, 0.1, 0.1)),))
    site.world.remove_body("sw3_1")
    site.world.remove_body("stone")
    site.world.add_body(Body("stone", (0.08, 0.0, 0.05), 0.0, (0.1, 0.1, 0.1), 0.5))
    assert site.look() == ["stone"]
    site.world.remove_body("stone")
    site.world.add_body(Body("stone", (0.10, 0.0, 0.05), 0.0, (0.1, 0.1, 0.1), 0.5))
    assert site.look() == ["stone", "sw3_2"]


def test_no_body_appears_under_a_magnet():
    """With its arm up a builder's magnet is 0.18 m ahead, 0.37 m above the floor."""
    site = Yard("bullet", RobotSetup("r1", "mecanum_arm", Pose(-0.25, 0.0)), dispensers=(PLACE,))
    try:
        site.world.remove_body("sw3_1")
        assert site.look() == []
    finally:
        site.simulated.close()


def test_detector_and_labels_know_bodies_that_appear_later():
    eye = SensorSetup("detector", "detections", 2.0, {"position_noise": 0.0})
    site = Yard("planar", RobotSetup("r1", "diff_drive", Pose(-1.0, 0.0), (eye,)))
    try:
        site.world.remove_body("sw3_1")
        seen, labelled = [], []
        for tick in range(2 * LOOK):
            now = 1.0 + tick / RATE
            site.simulated.begin_tick(tick, now)
            for said in site.simulated.sense(tick, now):
                for message in getattr(said, "messages", ()):
                    seen += [each["kind"] for each in message.fields["detections"] if each["id"] == "sw3_2"]
            for label in site.simulated.labels(tick, now):
                labelled += [each["id"] for each in label.fields["detections"]]
            site.simulated.step()
        assert seen == ["block3"] * 2
        assert labelled == ["sw3_2"] * 2
    finally:
        site.simulated.close()


class Books(StillWorld):
    """Takes note of the bodies that it is given."""

    def __init__(self):
        super().__init__()
        self.capabilities |= {"bodies"}
        self.given = []

    def add_body(self, body):
        self.given.append((body.id, body.friction))


def test_world_is_told_how_bodies_rub():
    stone = LooseBody("stone", Pose(3.0, 1.0), (0.1, 0.1, 0.1), friction=0.3)
    world = Books()
    simulation(scenario(bodies=(stone,), dispensers=(PLACE,)), world).close()
    assert world.given == [("stone", 0.3), ("sw3_1", 0.8)]


@pytest.mark.parametrize(
    ("name", "known"),
    [("sw3_1", True), ("sw3_3", True), ("sw3_4", False), ("sw3_0", False), ("sw3_01", False), ("sw3", False),
     ("sw_3", False), ("sw3_x", False), ("sw3_" + "1" * 5000, False)],
)  # fmt: skip
def test_dispenser_knows_the_names_of_its_bodies(name, known):
    assert PLACE.gives(name) is known
