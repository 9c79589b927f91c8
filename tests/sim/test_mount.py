"""Sensors on robots: rays cast together, and what is wrong with those that cannot be."""

from __future__ import annotations

import math

import numpy as np
import pytest

from rqt_mrta_py.errors import SimError
from rqt_mrta_py.hooks import Outgoing, RayPattern, SensorContext
from rqt_mrta_py.model import Arena, Pose, RobotSetup, ScenarioEvent, ScenarioEventKind, ScenarioSpec, SensorSetup
from rqt_mrta_py.sim import Simulation
from rqt_mrta_py.sim.mount import cast_together, mount
from rqt_mrta_py.sim.plugin import mrta_register_robot_models, mrta_register_sensors
from rqt_mrta_py.sim.robot_models import DIFF_DRIVE
from tests.sim.doubles import StillWorld

SCAN = SensorSetup("range_finder", "scan", 10.0, {"rays": 4})


class CountingWorld(StillWorld):
    """Sees its row and column as a distance, and remembers who was cast for."""

    def __init__(self, **changes):
        super().__init__(seen=[1.0], **changes)
        self.asked = []

    def ranges(self, robots, bearings, max_range):
        self.asked.append((list(robots), bearings.size, max_range))
        return np.array([[0.5 + int(robot[-1]) + 0.01 * ray for ray in range(bearings.size)] for robot in robots])


class Lidar:
    """A stranger's sensor that publishes what it was handed."""

    def __init__(self, rays):
        self.rays = rays

    def sense(self, moment):
        seen = None if moment.ranges is None else moment.ranges.tolist()
        return (Outgoing("seen", "std_msgs/Float64MultiArray", {"data": seen}),)


def simulation(robots, world, *events, extra=None, seed=0):
    scenario = ScenarioSpec(Arena(-9.0, -9.0, 9.0, 9.0), (), tuple(robots), tuple(events), world="counting")
    return Simulation(
        scenario=scenario,
        models=mrta_register_robot_models(),
        sensors={**mrta_register_sensors(), **(extra or {})},
        worlds={"counting": lambda: world},
        generators={robot.id: np.random.default_rng([seed, int(robot.id[-1])]) for robot in robots},
    )


def robot(number, *sensors):
    return RobotSetup(f"robot{number}", "diff_drive", Pose(float(number), 0.0), sensors or (SCAN,))


def mounted(rays, name="robot1"):
    context = SensorContext(name, DIFF_DRIVE, SensorSetup("lidar", "seen", 10.0), Pose(0.0, 0.0), None)
    return mount(context, lambda _: Lidar(rays), 20)


def test_world_is_asked_once_a_tick_for_all_robots_that_want_equal_rays():
    world = CountingWorld()
    simulated = simulation([robot(1), robot(2), robot(3)], world)
    list(simulated.sense(0, 1.0))
    list(simulated.sense(1, 1.05))
    list(simulated.sense(2, 1.1))
    assert world.asked == [(["robot1", "robot2", "robot3"], 4, 4.0)] * 2


def test_world_is_asked_apart_for_rays_that_differ():
    world = CountingWorld()
    longer = SensorSetup("range_finder", "scan", 10.0, {"rays": 4, "max_range": 6.0})
    more = SensorSetup("range_finder", "scan", 5.0, {"rays": 5})
    list(simulation([robot(1), robot(2, longer), robot(3, more, SCAN)], world).sense(0, 1.0))
    assert world.asked == [(["robot1", "robot3"], 4, 4.0), (["robot2"], 4, 6.0), (["robot3"], 5, 4.0)]


def test_each_sensor_is_handed_the_row_of_its_robot():
    lidar = SensorSetup("lidar", "seen", 10.0)
    extra = {"lidar": lambda context: Lidar(RayPattern(np.array([0.0, 1.0]), 9.0))}
    said = list(simulation([robot(1, lidar), robot(2, lidar)], CountingWorld(), extra=extra).sense(0, 1.0))
    handed = {robot_id: messages[0].fields["data"] for robot_id, messages in said}
    assert handed == {"robot1": [1.5, 1.51], "robot2": [2.5, 2.51]}


def test_sensor_that_wants_no_rays_is_handed_none():
    extra = {"lidar": lambda context: Lidar(None)}
    world = CountingWorld()
    ((_, (outgoing,)),) = simulation([robot(1, SensorSetup("lidar", "seen", 10.0))], world, extra=extra).sense(0, 1.0)
    assert outgoing.fields == {"data": None}
    assert world.asked == []


def test_stopped_robot_is_not_cast_for():
    world = CountingWorld()
    stops = ScenarioEvent(0.0, ScenarioEventKind.ROBOT_STOPS, "robot1")
    simulated = simulation([robot(1), robot(2)], world, stops)
    simulated.begin_tick(0, 1.0)
    list(simulated.sense(0, 1.0))
    assert world.asked == [(["robot2"], 4, 4.0)]


def test_robot_more_leaves_the_noise_of_the_others_alone():
    sensors = (SensorSetup("odometry", "odom", 10.0), SCAN, SensorSetup("localiser", "pose", 10.0))
    few = simulation([robot(1, *sensors), robot(2, *sensors)], CountingWorld())
    many = simulation([robot(3, *sensors), robot(1, *sensors), robot(4, *sensors), robot(2, *sensors)], CountingWorld())
    for tick in range(6):
        said = dict(many.sense(tick, 1.0 + tick / 20))
        for robot_id, messages in few.sense(tick, 1.0 + tick / 20):
            assert said[robot_id] == messages


def test_rays_that_are_handed_out_cannot_be_changed():
    one = mounted(RayPattern(np.zeros(2), 4.0))
    (row,) = cast_together(CountingWorld(), "counting", [one]).values()
    with pytest.raises(ValueError, match="read-only"):
        row[0] = 1.0


@pytest.mark.parametrize(
    ("rays", "message"),
    [
        (RayPattern(np.zeros(3601), 4.0), "its rays must be a row of at most 3600 finite bearings (got shape (3601,))"),
        (
            RayPattern(np.zeros((2, 2)), 4.0),
            "its rays must be a row of at most 3600 finite bearings (got shape (2, 2))",
        ),
        (
            RayPattern(np.array([np.nan]), 4.0),
            "its rays must be a row of at most 3600 finite bearings (got shape (1,))",
        ),
        (RayPattern(np.zeros(1), math.inf), "its rays must have a finite length above 0 m (got inf)"),
        (RayPattern(np.zeros(1), 0.0), "its rays must have a finite length above 0 m (got 0.0)"),
        (RayPattern(np.zeros(1), "4 m"), "its rays must have a finite length above 0 m (got '4 m')"),
        (RayPattern("ahead", 4.0), "its rays must have numbers for bearings (got 'ahead')"),
        (RayPattern([[0.0], 1.0], 4.0), "its rays must have numbers for bearings (got [[0.0], 1.0])"),
        ((np.zeros(1), 4.0, 1.0), "its rays must be a RayPattern or None (got (array([0.]), 4.0, 1.0))"),
        (3, "its rays must be a RayPattern or None (got 3)"),
    ],
)
def test_rays_that_cannot_be_cast_are_refused_by_robot_and_sensor(rays, message):
    with pytest.raises(SimError) as caught:
        mounted(rays)
    assert str(caught.value) == f"robot robot1: sensor lidar on seen: {message}"


def test_world_that_answers_other_rays_than_asked_for_is_named():
    class Careless(CountingWorld):
        def ranges(self, robots, bearings, max_range):
            return np.zeros((1, 1))

    due = [mounted(RayPattern(np.zeros(2), 4.0), name) for name in ("robot1", "robot2")]
    with pytest.raises(SimError, match=r"careless: ranges answered an array of shape \(1, 1\); accepted is \(2, 2\)"):
        cast_together(Careless(), "careless", due)


def test_world_without_ranges_is_no_world_for_sensors_that_want_rays():
    world = CountingWorld(lacks=["ranges"])
    odometry = SensorSetup("odometry", "odom", 10.0)
    with pytest.raises(SimError) as caught:
        simulation([robot(1), robot(2, odometry), robot(3, odometry, SCAN)], world)
    lacks = "world counting lacks ranges; it can do: contacts, drive:differential, freeze"
    assert str(caught.value).splitlines() == [
        f"robot robot1: sensor range_finder on scan: {lacks}",
        f"robot robot3: sensor range_finder on scan: {lacks}",
    ]
    assert world.closed == 1
