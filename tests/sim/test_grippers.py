"""What robots with grippers take hold of, keep and let go."""

from __future__ import annotations

import math
from dataclasses import replace

import pytest

from rqt_mrta_py.errors import SimError
from rqt_mrta_py.hooks import TeamHeard
from rqt_mrta_py.model import LooseBody, Pose, RobotSetup, ScenarioEvent, ScenarioEventKind
from rqt_mrta_py.sim.grippers import can_grip
from rqt_mrta_py.sim.robot_models import CARRIER
from tests.sim.scenarios import RATE, scenario, simulation

STOPS, RETURNS = ScenarioEventKind.ROBOT_STOPS, ScenarioEventKind.ROBOT_RETURNS
SIZE = (0.1, 0.1, 0.1)
AHEAD = CARRIER.radius + 0.1


def can(name, x, y=0.0, mass=0.2):
    return LooseBody(name, Pose(x, y), SIZE, mass, "can")


class Yard:
    """Carriers in a planar world, told by hand what to do with their grippers."""

    def __init__(self, *starts, bodies=(), events=(), models=()):
        robots = [
            RobotSetup(f"r{number}", model, start)
            for number, (start, model) in enumerate(zip(starts, [*models, *["carrier"] * len(starts)]), 1)
        ]
        changes = {"robots": tuple(robots), "bodies": tuple(bodies), "world": "planar"}
        self.simulated = simulation(scenario(*events, **changes))
        names = self.simulated.grippers.robots
        self._rows = {name: row for row, name in enumerate(names)}
        self._hear = self.simulated.grippers.listener(names)[1]
        self._tick = 0
        self.told = []

    def tick(self, **commands):
        """Let a tick pass in which robots hear commands; note what grippers say."""
        now = 1.0 + self._tick / RATE
        self.simulated.begin_tick(self._tick, now)
        for said in self.simulated.sense(self._tick, now):
            for message in getattr(said, "messages", ()):
                if message.topic == "gripper/state":
                    self.told.append((self._tick, said.robot, message.fields["data"]))
        rows = [self._rows[name] for name in commands]
        self._hear(TeamHeard(rows, [now] * len(rows), [{"data": value} for value in commands.values()]))
        self.simulated.act(now)
        self.simulated.step()
        self._tick += 1

    @property
    def held(self):
        return dict(self.simulated.grippers.held)


@pytest.fixture
def yard():
    built = []

    def build(*starts, **setup):
        built.append(Yard(*starts, **setup))
        return built[-1]

    yield build
    for each in built:
        each.simulated.close()


@pytest.mark.parametrize(
    ("distance", "bearing", "reaches"),
    [
        (0.38, 0.0, True),  # circle of 0.19 m and reach of 0.20 m make 0.39 m
        (0.40, 0.0, False),
        (0.38, 29.0, True),
        (0.38, -29.0, True),
        (0.38, 31.0, False),
        (0.38, 180.0, False),
        (0.01, 0.0, True),
    ],
)
def test_gripper_reaches_what_lies_close_ahead(distance, bearing, reaches):
    angle = math.radians(bearing)
    assert can_grip(CARRIER, distance * math.cos(angle), distance * math.sin(angle)) is reaches


@pytest.mark.parametrize("command", [0.51, 1.0, math.inf])
def test_robot_takes_the_nearest_body_before_it(yard, command):
    bodies = [can("far", AHEAD + 0.05, 0.1), can("near", AHEAD), can("behind", -AHEAD)]
    world = yard(Pose(0.0, 0.0), bodies=bodies)
    world.tick(r1=command)
    assert world.held == {"near": "r1"}


def test_of_equally_near_bodies_the_first_by_id_is_taken(yard):
    world = yard(Pose(0.0, 0.0), bodies=[can("b", AHEAD, 0.1), can("a", AHEAD, -0.1)])
    world.tick(r1=1.0)
    assert world.held == {"a": "r1"}


@pytest.mark.parametrize("command", [0.5, 0.0, -1.0, math.nan])
def test_robot_that_is_not_told_to_takes_nothing(yard, command):
    world = yard(Pose(0.0, 0.0), bodies=[can("near", AHEAD)])
    world.tick(r1=command)
    world.tick()
    assert world.held == {}


def test_robot_takes_what_it_can_bear_and_leaves_what_is_too_heavy(yard):
    bodies = [can("safe", AHEAD, mass=0.51), can("bag", AHEAD + 0.05, 0.1, mass=0.5)]
    world = yard(Pose(0.0, 0.0), bodies=bodies)
    world.tick(r1=1.0)
    assert world.held == {"bag": "r1"}


def test_strong_carrier_takes_what_a_carrier_cannot(yard):
    bodies = [can("left", AHEAD, 0.0, mass=4.0), can("right", AHEAD + 0.1, 2.0, mass=4.0)]
    world = yard(Pose(0.0, 0.0), Pose(0.0, 2.0), bodies=bodies, models=["carrier", "strong_carrier"])
    world.tick(r1=1.0, r2=1.0)
    assert world.held == {"right": "r2"}


def test_robot_goes_on_trying_until_something_is_in_reach(yard):
    world = yard(Pose(0.0, 0.0), Pose(1.0, 0.0, math.pi), bodies=[can("shared", 0.35)])
    world.tick(r1=1.0)
    world.tick(r2=1.0)
    assert world.held == {"shared": "r1"}
    world.tick(r1=0.0)
    assert world.held == {}
    pose, place = world.simulated.world.poses()[1], world.simulated.world.bodies()["shared"].position
    assert math.dist(pose[:2], place[:2]) > CARRIER.radius + CARRIER.reach
    world.tick(r1=1.0)
    assert world.held == {"shared": "r1"}


def test_robot_holds_one_body_and_keeps_it_without_being_told_again(yard):
    world = yard(Pose(0.0, 0.0), bodies=[can("a", AHEAD), can("b", AHEAD + 0.05, 0.1)])
    world.tick(r1=1.0)
    for _ in range(30):
        world.tick()
    world.tick(r1=1.0)
    assert world.held == {"a": "r1"}


def test_body_lies_where_it_was_let_go(yard):
    world = yard(Pose(0.0, 0.0), bodies=[can("a", AHEAD)])
    world.tick(r1=1.0)
    before = world.simulated.world.bodies()["a"].position
    world.tick(r1=0.0)
    world.tick()
    assert world.simulated.world.bodies()["a"].position == pytest.approx(before, abs=1e-9)
    assert world.held == {}


def test_nobody_takes_a_body_from_a_robot_at_work(yard):
    world = yard(Pose(0.0, 0.0), Pose(0.6, 0.0, math.pi), bodies=[can("a", 0.3)])
    world.tick(r1=1.0)
    world.tick(r2=1.0)
    assert world.held == {"a": "r1"}


def test_stopped_robot_keeps_what_it_holds_until_another_takes_it(yard):
    events = [ScenarioEvent(0.2, STOPS, "r1"), ScenarioEvent(2.0, RETURNS, "r1")]
    world = yard(Pose(0.0, 0.0), Pose(0.6, 0.0, math.pi), bodies=[can("a", 0.3)], events=events)
    world.tick(r1=1.0)
    for _ in range(9):
        world.tick(r1=0.0 if world._tick > 4 else 1.0)
    assert world.held == {}
    with pytest.raises(SimError, match="attached to r1 already"):
        world.simulated.world.attach("r2", "a")
    world.tick(r2=1.0)
    assert world.held == {"a": "r2"}
    while world._tick < 45:
        world.tick(r2=1.0)
    assert world.held == {"a": "r2"}
    assert [said for said in world.told if said[1] == "r1"][-1] == (40, "r1", "")


def test_robot_that_comes_back_still_holds_what_nobody_took(yard):
    events = [ScenarioEvent(0.2, STOPS, "r1"), ScenarioEvent(0.5, RETURNS, "r1")]
    world = yard(Pose(0.0, 0.0), bodies=[can("a", 0.3)], events=events)
    world.tick(r1=1.0)
    for _ in range(12):
        world.tick()
    assert world.held == {"a": "r1"}
    assert [said[0] for said in world.told if 4 <= said[0] < 10] == []


def test_robot_says_what_it_holds_at_once_and_else_twice_a_second(yard):
    world = yard(Pose(0.0, 0.0), bodies=[can("a", AHEAD)])
    for tick in range(25):
        world.tick(r1=1.0 if 3 <= tick < 14 else 0.0)
    assert world.told == [
        (0, "r1", ""),
        (4, "r1", "a"),
        (10, "r1", "a"),
        (15, "r1", ""),
        (20, "r1", ""),
    ]


def test_robots_without_grippers_say_and_hear_nothing_of_them(yard):
    world = yard(Pose(0.0, 0.0), Pose(2.0, 0.0), models=["diff_drive"])
    assert world.simulated.grippers.robots == ("r2",)
    world.tick()
    assert [robot for _, robot, _ in world.told] == ["r2"]


def test_command_of_the_gripper_is_heard_in_the_robots_namespace(yard):
    subscription, _ = yard(Pose(0.0, 0.0)).simulated.grippers.listener(["r1"])
    assert subscription[:3] == ("gripper/command", "std_msgs/Float64", ("data",))


@pytest.mark.parametrize("world_name", ["bullet", "planar"])
def test_bodies_of_a_scenario_stand_on_the_floor_of_both_worlds(world_name):
    bodies = (LooseBody("tall", Pose(1.0, 2.0, 0.5), (0.1, 0.2, 0.3)), can("flat", -1.0))
    spec = replace(scenario(), bodies=bodies, world=world_name)
    simulated = simulation(spec)
    try:
        states = simulated.world.bodies()
        assert list(states) == ["tall", "flat"]
        assert states["tall"].position == pytest.approx((1.0, 2.0, 0.15))
        assert states["tall"].orientation == pytest.approx((0.0, 0.0, math.sin(0.25), math.cos(0.25)))
        assert states["flat"].position == pytest.approx((-1.0, 0.0, 0.05))
    finally:
        simulated.close()
