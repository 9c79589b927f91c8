"""What magnets on arms take hold of, hold and let go, and what arms are told and tell."""

from __future__ import annotations

import math

import pytest

from rqt_mrta_py.errors import SimError
from rqt_mrta_py.hooks import BodyState, TeamHeard
from rqt_mrta_py.model import LooseBody, Pose, RobotSetup, ScenarioEvent, ScenarioEventKind
from rqt_mrta_py.sim.magnets import is_at_face
from rqt_mrta_py.sim.robot_models import MECANUM_ARM
from tests.sim.scenarios import RATE, scenario, simulation

STOPS = ScenarioEventKind.ROBOT_STOPS
ARM = MECANUM_ARM.arm
SIZE = (0.18, 0.07, 0.07)
LOW = ARM.angle_at(0.035)
FACE = ARM.reach_at(LOW)
AHEAD = -math.pi / 2
"""The yaw of a body whose rear face looks at a robot that looks along x [rad]."""


def block(name, gap, y=0.0, mass=0.06, turned=0.0):
    """Lay a block so that its rear face lies a gap before the lowered magnet of a robot at the origin."""
    return LooseBody(name, Pose(FACE + gap + SIZE[1] / 2, y, AHEAD + turned), SIZE, mass, "block")


START = (Pose(-0.08, 0.0),)


class Site:
    """Builders in BulletWorld, told by hand what to do."""

    def __init__(self, bodies=(), events=(), starts=START):
        robots = tuple(RobotSetup(f"r{number}", "mecanum_arm", start) for number, start in enumerate(starts, 1))
        self.simulated = simulation(scenario(*events, robots=robots, bodies=tuple(bodies), world="bullet"))
        self._ears = {ear.wish.topic: ear for ear in self.simulated.ears([robot.id for robot in robots])}
        self._tick = 0
        self.told = []

    def approach(self, magnet=1.0):
        """Lower the arm of r1, switch its magnet on, and drive the 8 cm to the origin."""
        self.tick(5 * RATE, arm=LOW)
        self.tick(4 * RATE, vx=0.02, magnet=magnet)
        self.tick(RATE)

    def tick(self, count=1, vx=0.0, **commands):
        """Let ticks pass in which r1 drives; in the first of them it hears commands by actuator."""
        drive = {"linear/x": vx, "linear/y": 0.0, "angular/z": 0.0}
        for _ in range(count):
            now = 1.0 + self._tick / RATE
            self.simulated.begin_tick(self._tick, now)
            for said in self.simulated.sense(self._tick, now):
                self.told.extend((self._tick, m.topic, m.fields["data"]) for m in getattr(said, "messages", ()))
            self._ears["cmd_vel"].hear(TeamHeard([0], [now], [drive]))
            for actuator, value in commands.items():
                self._ears[f"{actuator}/command"].hear(TeamHeard([0], [now], [{"data": value}]))
            commands = {}
            self.simulated.act(now)
            self.simulated.step()
            self._tick += 1

    @property
    def held(self):
        return dict(self.simulated.magnets.held)


@pytest.fixture
def site():
    built = []

    def build(*bodies, **setup):
        built.append(Site(bodies, **setup))
        return built[-1]

    yield build
    for each in built:
        each.simulated.close()


def state(gap, *, beside=0.0, above=0.0, turned=0.0):
    yaw = AHEAD + turned
    return BodyState(
        (FACE + gap + SIZE[1] / 2, beside, 0.035 + above), (0.0, 0.0, math.sin(yaw / 2), math.cos(yaw / 2))
    )


@pytest.mark.parametrize(
    ("body", "holds"),
    [
        (state(0.0, turned=math.pi), False),
        (state(0.0), True),
        (state(0.009), True),
        (state(0.011), False),
        (state(-0.006), False),
        (state(0.0, turned=math.radians(9.0)), True),
        (state(0.0, turned=math.radians(11.0)), False),
        (state(0.0, beside=0.089), True),
        (state(0.0, beside=0.091), False),
        (state(0.0, above=0.034), True),
        (state(0.0, above=0.036), False),
    ],
)
def test_magnet_holds_a_rear_face_within_a_centimetre_about_parallel_and_not_beside_it(body, holds):
    """A body with yaw -90 degrees looks back at the robot with its rear; turned round, with its front."""
    assert is_at_face(ARM, Pose(0.0, 0.0), LOW, body, SIZE) is holds


def test_magnet_that_is_on_takes_what_comes_to_its_face_and_carries_it_up(site):
    world = site(block("b1", 0.005), block("b2", 0.3))
    world.approach(magnet=0.0)
    assert world.held == {}
    world.tick(2, magnet=1.0)
    assert world.held == {"b1": "r1"}
    world.tick(5 * RATE, arm=math.pi / 2)
    assert world.held == {"b1": "r1"}
    assert world.simulated.world.bodies()["b1"].position[2] == pytest.approx(ARM.height_at(math.pi / 2), abs=0.002)
    assert [name for _, topic, name in world.told if topic == "magnet/state"][-10:] == ["b1"] * 10
    world.tick(RATE, magnet=0.0)
    assert world.held == {}
    assert world.told[-1][1:] == ("magnet/state", "")


@pytest.mark.parametrize(
    "body", [block("far", 0.02), block("reversed", 0.005, turned=math.pi), block("safe", 0.005, mass=0.6)]
)
def test_magnet_leaves_what_is_too_far_shows_no_strip_or_is_too_heavy(site, body):
    world = site(body)
    world.approach()
    assert world.held == {}


def test_body_that_is_torn_from_a_magnet_is_held_no_more(site):
    world = site(block("b1", 0.002))
    world.approach()
    assert world.held == {"b1": "r1"}
    inner = world.simulated.world
    number = inner._bodies._bodies["b1"]
    client = inner._engine.client
    inner._engine.bullet.resetBasePositionAndOrientation(
        number, (2.0, 0.0, 0.035), (0.0, 0.0, 0.0, 1.0), physicsClientId=client
    )
    world.tick(RATE)
    assert world.held == {}


def test_stopped_robot_keeps_its_block_without_holding_it(site):
    world = site(block("b1", 0.005), events=[ScenarioEvent(11.0, STOPS, "r1")])
    world.approach()
    world.tick(RATE)
    assert world.held == {"b1": "r1"}
    world.tick()
    world.tick(RATE, magnet=0.0, arm=1.0)
    assert (world.held, list(world.simulated.magnets.kept)) == ({}, ["b1"])
    assert world.simulated.world.arm_angles()["r1"] == pytest.approx(LOW, abs=1e-3)


def test_robot_that_is_removed_takes_its_block_along_and_says_nothing_more(site):
    removed = ScenarioEvent(11.0, ScenarioEventKind.ROBOT_REMOVED, "r1")
    world = site(block("b1", 0.005), events=[removed])
    world.approach()
    world.tick(RATE)
    assert world.held == {"b1": "r1"}
    spoken = len(world.told)
    world.tick(RATE, arm=1.0, magnet=1.0, vx=0.1)
    assert len(world.told) == spoken
    assert (world.held, list(world.simulated.magnets.kept)) == ({}, [])
    assert dict(world.simulated.world.bodies()) == {}


def test_robot_tells_ten_times_a_second_where_its_arm_is(site):
    world = site()
    world.tick(RATE, arm=math.nan)
    angles = [value for _, topic, value in world.told if topic == "arm/state"]
    assert angles == [pytest.approx(math.pi / 2, abs=1e-6)] * 10
    world.tick(RATE, arm=1.0)
    angles = [value for _, topic, value in world.told if topic == "arm/state"][10:]
    assert angles == sorted(angles, reverse=True)
    assert angles[-1] == pytest.approx(math.pi / 2 - 0.9 * ARM.rate, abs=0.03)


def test_world_without_arms_is_refused():
    robots = (RobotSetup("r1", "mecanum_arm", Pose(0.0, 0.0)),)
    with pytest.raises(SimError, match="robot r1: world planar lacks drive:mecanum") as raised:
        simulation(scenario(robots=robots, world="planar"))
    assert "robot r1: world planar lacks arms" in str(raised.value)
