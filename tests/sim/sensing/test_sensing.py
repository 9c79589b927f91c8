"""Sensors on robots: who is asked when, rays cast together, and sensors and answers that cannot be."""

from __future__ import annotations

import math

import numpy as np
import pytest

from rqt_mrta_py.errors import SimError
from rqt_mrta_py.hooks import Outgoing, RayPattern, SensorContext, TeamOutgoing
from rqt_mrta_py.model import Arena, Pose, RobotSetup, ScenarioEvent, ScenarioEventKind, ScenarioSpec, SensorSetup
from rqt_mrta_py.sim import Simulation
from rqt_mrta_py.sim.plugin import mrta_register_robot_models, mrta_register_team_sensors
from rqt_mrta_py.sim.robot_models import DIFF_DRIVE
from rqt_mrta_py.sim.sensing.mount import Carrier, mount_alone
from rqt_mrta_py.sim.sensing.rays import cast_together
from tests.sim.doubles import StillWorld
from tests.sim.expanding import by_robot

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


class Thermometers:
    """A stranger's sensor of many robots, which answers what it was told to."""

    rays = None

    def __init__(self, contexts, answer=None):
        self.contexts = contexts
        self.answer = answer
        self.moments = []

    def sense(self, moment):
        self.moments.append(moment)
        if self.answer is not None:
            return self.answer
        robots = tuple(self.contexts[member].robot_id for member in moment.members)
        return [TeamOutgoing("warmth", "sensor_msgs/Temperature", robots, {"temperature": moment.truth[:, 0] + 20.0})]


def simulation(robots, world, *events, extra=None, team=None, seed=0):
    scenario = ScenarioSpec(Arena(-9.0, -9.0, 9.0, 9.0), (), tuple(robots), tuple(events), world="counting")
    return Simulation(
        scenario=scenario,
        models=mrta_register_robot_models(),
        sensors=extra or {},
        team_sensors={**mrta_register_team_sensors(), **(team or {})},
        worlds={"counting": lambda: world},
        generators={robot.id: np.random.default_rng([seed, int(robot.id[-1])]) for robot in robots},
    )


def robot(number, *sensors):
    return RobotSetup(f"robot{number}", "diff_drive", Pose(float(number), 0.0), sensors or (SCAN,))


def mounted(rays, name="robot1"):
    context = SensorContext(name, DIFF_DRIVE, SensorSetup("lidar", "seen", 10.0), Pose(0.0, 0.0), None)
    return mount_alone(Carrier(0, context), lambda _: Lidar(rays), 20)


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
    asked = [(["robot1", "robot3"], 4, 4.0), (["robot2"], 4, 6.0), (["robot3"], 5, 4.0)]
    assert sorted(world.asked) == sorted(asked)


def test_world_is_asked_once_for_equal_rays_of_sensors_that_differ():
    world = CountingWorld()
    noisy = SensorSetup("range_finder", "scan", 10.0, {"rays": 4, "noise": 0.1})
    list(simulation([robot(1, noisy), robot(2)], world).sense(0, 1.0))
    assert [(sorted(robots), rays, reach) for robots, rays, reach in world.asked] == [(["robot1", "robot2"], 4, 4.0)]


def test_each_sensor_is_handed_the_row_of_its_robot():
    lidar = SensorSetup("lidar", "seen", 10.0)
    extra = {"lidar": lambda context: Lidar(RayPattern(np.array([0.0, 1.0]), 9.0))}
    said = by_robot(simulation([robot(1, lidar), robot(2, lidar)], CountingWorld(), extra=extra).sense(0, 1.0))
    handed = {robot_id: messages[0].fields["data"] for robot_id, messages in said.items()}
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
        said = by_robot(many.sense(tick, 1.0 + tick / 20))
        for robot_id, messages in by_robot(few.sense(tick, 1.0 + tick / 20)).items():
            assert said[robot_id] == messages


def test_rays_that_are_handed_out_cannot_be_changed():
    one = mounted(RayPattern(np.zeros(2), 4.0))
    (rows,) = cast_together("counting", CountingWorld(), [one]).values()
    with pytest.raises(ValueError, match="read-only"):
        rows[0, 0] = 1.0


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
        cast_together("careless", Careless(), due)


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


def test_sensor_of_many_robots_is_made_once_for_those_that_are_set_up_alike():
    made = []
    team = {"thermometer": lambda contexts: made.append(Thermometers(contexts)) or made[-1]}
    often, seldom = SensorSetup("thermometer", "warmth", 20.0), SensorSetup("thermometer", "warmth", 5.0)
    simulated = simulation([robot(1, often), robot(2, seldom), robot(3, often)], CountingWorld(), team=team)
    for tick in range(2):
        list(simulated.sense(tick, 1.0 + tick / 20))
    asked = {
        tuple(context.robot_id for context in sensor.contexts): [moment.members.tolist() for moment in sensor.moments]
        for sensor in made
    }
    assert asked == {("robot1", "robot3"): [[0, 1], [0, 1]], ("robot2",): [[0]]}


def test_robot_that_carries_two_sensors_alike_has_both():
    made = []
    team = {"thermometer": lambda contexts: made.append(Thermometers(contexts)) or made[-1]}
    setup = SensorSetup("thermometer", "warmth", 20.0)
    simulated = simulation([robot(1, setup, setup), robot(2, setup)], CountingWorld(), team=team)
    assert {name: len(said) for name, said in by_robot(simulated.sense(0, 1.0)).items()} == {"robot1": 2, "robot2": 1}
    assert [[context.robot_id for context in sensor.contexts] for sensor in made] == [["robot1", "robot2"], ["robot1"]]


def test_sensor_of_many_robots_is_handed_their_poses_and_clocks_but_of_those_that_are_stopped():
    made = []
    team = {"thermometer": lambda contexts: made.append(Thermometers(contexts)) or made[-1]}
    events = (
        ScenarioEvent(0.0, ScenarioEventKind.ROBOT_STOPS, "robot2"),
        ScenarioEvent(0.0, ScenarioEventKind.ROBOT_CLOCK_SHIFTS, "robot3", parameters={"offset": 5.0}),
        ScenarioEvent(0.1, ScenarioEventKind.ROBOT_RETURNS, "robot2"),
    )
    robots = [robot(number, SensorSetup("thermometer", "warmth", 10.0)) for number in (1, 2, 3)]
    simulated = simulation(robots, CountingWorld(), *events, team=team)
    for tick in (0, 2):
        simulated.begin_tick(tick, 1.0 + tick / 20)
        list(simulated.sense(tick, 1.0 + tick / 20))
    first, second = made[0].moments
    assert (first.members.tolist(), first.now.tolist()) == ([0, 2], [1.0, 6.0])
    assert first.truth.tolist() == [[1.0, 0.0, 0.0], [3.0, 0.0, 0.0]]
    assert (second.members.tolist(), second.now.tolist()) == ([0, 1, 2], [1.1, 1.1, 6.1])
    assert second.ranges is None


def test_kind_that_is_known_for_one_robot_too_is_taken_from_there():
    class Own:
        rays = None

        def __init__(self, context):
            self.name = context.robot_id

        def sense(self, moment):
            return [Outgoing("scan", "std_msgs/String", {"data": f"{self.name} at {moment.truth.x}"})]

    said = by_robot(simulation([robot(1), robot(2)], CountingWorld(), extra={"range_finder": Own}).sense(0, 1.0))
    assert {name: messages[0].fields["data"] for name, messages in said.items()} == {
        "robot1": "robot1 at 1.0",
        "robot2": "robot2 at 2.0",
    }


def test_transforms_follow_from_odometry_of_one_robot_as_from_that_of_many():
    class Own:
        rays = None

        def __init__(self, context):
            pass

        def sense(self, moment):
            pose = {"position": {"x": 0.25}, "orientation": {"w": 1.0}}
            return [Outgoing("odom", "nav_msgs/Odometry", {"pose": {"pose": pose}})]

    sensors = (SensorSetup("own", "odom", 10.0), SensorSetup("localiser", "pose", 10.0, {"position_noise": 0.0}))
    said = by_robot(simulation([robot(1, *sensors)], CountingWorld(), extra={"own": Own}).sense(0, 1.0))["robot1"]
    assert [outgoing.topic for outgoing in said] == ["pose", "odom", "/tf"]
    origin, base = said[-1].fields["transforms"]
    assert (origin["header"]["frame_id"], origin["transform"]["translation"]["x"]) == (
        "map",
        pytest.approx(0.75, abs=0.01),
    )
    assert base["transform"]["translation"]["x"] == 0.25


@pytest.mark.parametrize(
    ("answer", "message"),
    [
        (3, "answered 3; accepted is a sequence of TeamOutgoing"),
        (
            TeamOutgoing("a", "b", (), {}),
            "answered TeamOutgoing(topic='a', type='b', robots=(), columns={}); accepted is a sequence of TeamOutgoing",
        ),
        (["x"], "answered 'x'; accepted is TeamOutgoing"),
        (
            [TeamOutgoing(None, "b", (), {})],
            "answered a TeamOutgoing on None of type 'b'; accepted are two texts",
        ),
        (
            [TeamOutgoing("a", "b", ("robot1",), 3)],
            "answered a TeamOutgoing on 'a' with columns 3; accepted is a mapping",
        ),
        *(
            (
                [TeamOutgoing("a", "b", robots, {})],
                f"answered a TeamOutgoing on 'a' of robots {robots!r}; accepted is a tuple of those that measured, in "
                "order, each once: ('robot1', 'robot2')",
            )
            for robots in [("robot2", "robot1"), ("robot1", "robot1"), ("robot3",), ["robot1"], None]
        ),
        *(
            (
                [TeamOutgoing("a", "b", ("robot1", "robot2"), {"x": 1.0, "data": column})],
                f"answered a TeamOutgoing on 'a' with {rows} rows of 'data' for 2 robots; accepted are one row a "
                "robot, or one value for all",
            )
            for rows, column in [(3, np.zeros(3)), (1, np.zeros((1, 2))), (1, ["x"])]
        ),
    ],
)
def test_answer_of_a_sensor_of_many_robots_that_does_not_fit_is_refused_by_kind_and_topic(answer, message):
    team = {"thermometer": lambda contexts: Thermometers(contexts, answer)}
    robots = [robot(number, SensorSetup("thermometer", "warmth", 10.0)) for number in (1, 2)]
    with pytest.raises(SimError) as caught:
        list(simulation(robots, CountingWorld(), team=team).sense(0, 1.0))
    assert str(caught.value) == f"team sensor thermometer on warmth: {message}"


@pytest.mark.parametrize(
    "answer",
    [
        [],
        [TeamOutgoing("a", "b", ("robot2",), {"data": np.zeros((1, 5)), "name": "x", "number": 2, "text": ["y"]})],
        [TeamOutgoing("a", "b", ("robot1", "robot2"), {"number": np.float64(2.0)})] * 2,
    ],
)
def test_sensor_of_many_robots_may_speak_for_some_and_more_than_once(answer):
    team = {"thermometer": lambda contexts: Thermometers(contexts, answer)}
    robots = [robot(number, SensorSetup("thermometer", "warmth", 10.0)) for number in (1, 2)]
    assert list(simulation(robots, CountingWorld(), team=team).sense(0, 1.0)) == answer
