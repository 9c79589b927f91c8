from __future__ import annotations

import math
from dataclasses import replace

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from rqt_mrta_py.errors import SimError
from rqt_mrta_py.hooks import Heard
from rqt_mrta_py.model import (
    Arena,
    Obstacle,
    Pose,
    RobotSetup,
    ScenarioEvent,
    ScenarioEventKind,
    ScenarioSpec,
    SensorSetup,
    Twist,
)
from rqt_mrta_py.sim import PerfectLink, Simulation
from rqt_mrta_py.sim.plugin import mrta_register_robot_models, mrta_register_sensors, mrta_register_worlds
from tests.sim.doubles import StillWorld

STOPS, RETURNS = ScenarioEventKind.ROBOT_STOPS, ScenarioEventKind.ROBOT_RETURNS
RATE = 20
SENSORS = (SensorSetup("odometry", "odom", 10.0), SensorSetup("localiser", "pose", 10.0))


def scenario(*events, **changes):
    robots = tuple(RobotSetup(f"robot{i}", "diff_drive", Pose(float(i), 0.0), SENSORS) for i in (1, 2))
    spec = ScenarioSpec(Arena(-5.0, -5.0, 5.0, 5.0), (), robots, tuple(events), world="still", control_rate=RATE)
    return replace(spec, **changes)


def simulation(spec, world=None, **changes):
    known = {
        "models": mrta_register_robot_models(),
        "sensors": mrta_register_sensors(),
        "worlds": {"still": lambda: StillWorld() if world is None else world, **mrta_register_worlds()},
        "generators": {robot.id: np.random.default_rng(index) for index, robot in enumerate(spec.robots)},
    }
    return Simulation(scenario=spec, **{**known, **changes})


def play(simulated, ticks):
    """Give for each tick the events that happened and who spoke."""
    played = []
    for tick in range(ticks):
        now = tick / RATE + 1
        happened = simulated.begin_tick(tick, now)
        speakers = [robot_id for robot_id, _ in simulated.sense(tick, now)]
        simulated.act(now)
        simulated.step()
        played.append((list(happened), speakers))
    return played


def test_simulation_builds_its_world_from_the_scenario():
    world = StillWorld()
    rock = Obstacle("rock", Pose(0.0, 3.0), (1.0, 1.0, 0.5))
    simulated = simulation(scenario(obstacles=(rock,)), world)
    assert world.setup.tick == pytest.approx(0.05)
    assert world.setup.obstacles == (rock,)
    assert [robot.id for robot in world.setup.robots] == ["robot1", "robot2"]
    assert list(simulated.robots) == ["robot1", "robot2"]
    assert simulated.world is world


def test_simulation_gives_what_robots_say_in_the_order_of_the_scenario():
    simulated = simulation(scenario())
    said = simulated.sense(0, 1.0)
    assert [robot_id for robot_id, _ in said] == ["robot1", "robot2"]
    assert [outgoing.topic for outgoing in said[1][1]] == ["odom", "pose", "/tf"]
    assert simulated.sense(1, 1.05) == []


def test_simulation_commands_the_world_what_robots_heard():
    world = StillWorld()
    simulated = simulation(scenario(), world)
    ((subscription, hear),) = simulated.robots["robot2"].listeners()
    fields = {"linear/x": 0.3, "linear/y": 0.0, "angular/z": 0.1}
    hear(Heard("/robot2/cmd_vel", subscription.type, 1.0, fields))
    simulated.act(1.0)
    simulated.step()
    assert world.commands == {"robot1": Twist(), "robot2": Twist(0.3, 0.0, 0.1)}
    assert world.steps == 1


def test_simulation_of_no_robots_runs_and_says_nothing():
    simulated = simulation(scenario(robots=(), world="bullet"))
    try:
        assert play(simulated, 3) == [([], []), ([], []), ([], [])]
    finally:
        simulated.close()


def test_event_happens_at_its_tick_or_at_the_next_one():
    first, second = ScenarioEvent(0.05, STOPS, "robot1"), ScenarioEvent(0.11, STOPS, "robot2")
    played = play(simulation(scenario(first, second)), 5)
    assert [happened for happened, _ in played] == [[], [first], [], [second], []]


def test_events_of_one_tick_happen_in_time_then_file_order():
    events = [
        ScenarioEvent(0.1, STOPS, "robot2"),
        ScenarioEvent(0.09, STOPS, "robot1"),
        ScenarioEvent(0.1, RETURNS, "robot2"),
    ]
    played = play(simulation(scenario(*events)), 3)
    assert played[2][0] == [events[1], events[0], events[2]]


def test_stopped_robot_stands_still_and_is_silent_until_it_returns():
    world = StillWorld()
    events = (ScenarioEvent(0.1, STOPS, "robot1"), ScenarioEvent(0.3, RETURNS, "robot1"))
    simulated = simulation(scenario(*events), world)
    speakers = [names for _, names in play(simulated, 9)]
    assert speakers == [
        ["robot1", "robot2"],
        [],
        ["robot2"],
        [],
        ["robot2"],
        [],
        ["robot1", "robot2"],
        [],
        ["robot1", "robot2"],
    ]
    assert world.frozen == [("robot1", True), ("robot1", False)]


def test_robot_that_stopped_for_good_does_not_return_from_another_stop():
    world = StillWorld()
    events = (
        ScenarioEvent(0.0, STOPS, "robot1"),
        ScenarioEvent(0.1, STOPS, "robot1"),
        ScenarioEvent(0.2, RETURNS, "robot1"),
    )
    simulated = simulation(scenario(*events), world)
    play(simulated, 9)
    assert simulated.stopped("robot1")
    assert not simulated.stopped("robot2")
    assert world.frozen == [("robot1", True)]


@settings(max_examples=40, deadline=None)
@given(st.lists(st.tuples(st.integers(0, 30), st.integers(0, 30), st.sampled_from(["robot1", "robot2"])), max_size=6))
def test_robot_speaks_at_exactly_the_ticks_that_no_stop_covers(stops):
    """Each stop is an interval [from, to); overlapping ones of one robot add up."""
    spans = [(min(a, b), max(a, b) + 1, robot) for a, b, robot in stops]
    begins = [ScenarioEvent(begin / RATE, STOPS, robot) for begin, _, robot in spans]
    ends = [ScenarioEvent(end / RATE, RETURNS, robot) for _, end, robot in spans]
    simulated = simulation(scenario(*begins, *ends))
    for tick, (_, speakers) in enumerate(play(simulated, 35)):
        if tick % 2 == 0:
            silent = {robot for begin, end, robot in spans if begin <= tick < end}
            assert speakers == [robot for robot in ("robot1", "robot2") if robot not in silent]


def test_simulation_names_everything_that_is_missing_with_what_there_is():
    robots = (
        RobotSetup("robot1", "dif_drive", Pose(0.0, 0.0), (SensorSetup("range_findr", "scan", 10.0),)),
        RobotSetup("robot2", "hexapod", Pose(1.0, 0.0)),
    )
    with pytest.raises(SimError) as caught:
        simulation(scenario(robots=robots, world="bulet"))
    assert str(caught.value).splitlines() == [
        "scenario: no world 'bulet'; did you mean bullet? there are: bullet, still",
        "robot robot1: no robot model 'dif_drive'; did you mean diff_drive? there are: diff_drive",
        "robot robot1: no sensor 'range_findr' for scan; did you mean range_finder? "
        "there are: localiser, odometry, range_finder",
        "robot robot2: no robot model 'hexapod'; there are: diff_drive",
    ]


def test_simulation_names_the_capability_that_its_world_lacks():
    world = StillWorld(lacks=["freeze", "drive:differential"])
    with pytest.raises(SimError) as caught:
        simulation(scenario(ScenarioEvent(2.0, STOPS, "robot1")), world)
    assert str(caught.value).splitlines() == [
        "robot robot1: world still lacks drive:differential; it can do: contacts, ranges",
        "event robot_stops at 2 s: world still lacks freeze; it can do: contacts, ranges",
    ]
    assert world.closed == 1
    assert world.setup is None


def test_simulation_builds_no_world_for_misplaced_robots():
    robots = tuple(RobotSetup(f"robot{i}", "diff_drive", Pose(4.95, 0.0)) for i in (1, 2))
    with pytest.raises(SimError) as caught:
        simulation(scenario(robots=robots), worlds={"still": lambda: pytest.fail("the world was built")})
    lines = str(caught.value).splitlines()
    assert [line.split(" overlaps ")[0] for line in lines] == [
        "robot robot1: start pose (4.95, 0, 0)",
        "robot robot2: start pose (4.95, 0, 0)",
        "robot robot2: start pose (4.95, 0, 0)",
    ]
    assert "the wall" in lines[0]
    assert "robot1 by" in lines[2]


def test_simulation_tells_the_wrong_sensors_of_all_robots_at_once():
    wrong = (SensorSetup("localiser", "pose", 10.0, {"position_noise": -1.0}),)
    robots = tuple(RobotSetup(f"robot{i}", "diff_drive", Pose(float(i), 0.0), wrong) for i in (1, 2))
    with pytest.raises(SimError) as caught:
        simulation(scenario(robots=robots))
    assert [line.split(":")[0] for line in str(caught.value).splitlines()] == ["robot robot1", "robot robot2"]


@pytest.mark.parametrize(
    ("event", "message"),
    [
        (ScenarioEvent(-1.0, STOPS, "robot1"), "event robot_stops at -1 s: time must be finite and at least 0 s"),
        (ScenarioEvent(math.nan, STOPS, "robot1"), "event robot_stops at nan s: time must be finite and at least 0 s"),
        (ScenarioEvent(1.0, STOPS, "robot9"), "event robot_stops at 1 s: no robot 'robot9'; there are: robot1, robot2"),
        (ScenarioEvent(1.0, STOPS), "event robot_stops at 1 s: names no robot; there are: robot1, robot2"),
        (
            ScenarioEvent(1.0, RETURNS, "robot1"),
            "event robot_returns at 1 s: robot1 is not stopped then; let it stop before, once for each return",
        ),
    ],
)
def test_simulation_refuses_an_event_that_cannot_happen(event, message):
    with pytest.raises(SimError) as caught:
        simulation(scenario(event))
    assert str(caught.value) == message


def test_simulation_refuses_a_control_rate_of_nothing():
    with pytest.raises(SimError, match=r"scenario: control_rate must be at least 1 Hz \(got 0\)"):
        simulation(scenario(control_rate=0))


def test_simulation_closes_its_world_when_that_cannot_be_built():
    class Fragile(StillWorld):
        def reset(self, setup):
            raise SimError("world still: broken")

    world = Fragile()
    with pytest.raises(SimError, match="world still: broken"):
        simulation(scenario(), world)
    assert world.closed == 1


def test_simulation_in_bullet_freezes_a_driving_robot_and_lets_it_go():
    spec = scenario(ScenarioEvent(1.0, STOPS, "robot1"), ScenarioEvent(2.0, RETURNS, "robot1"), world="bullet")
    simulated = simulation(spec)
    xs = []
    try:
        ((subscription, hear),) = simulated.robots["robot1"].listeners()
        for tick in range(60):
            now = tick / RATE + 1
            simulated.begin_tick(tick, now)
            simulated.sense(tick, now)
            fields = {"linear/x": 0.3, "linear/y": 0.0, "angular/z": 0.0}
            hear(Heard("/robot1/cmd_vel", subscription.type, now, fields))
            simulated.act(now)
            simulated.step()
            xs.append(simulated.world.poses()[0, 0])
    finally:
        simulated.close()
        simulated.close()
    assert xs[19] - 1.0 == pytest.approx(0.29, abs=0.02)
    assert xs[39] - xs[20] == pytest.approx(0.0, abs=0.01)
    assert xs[59] - xs[39] == pytest.approx(0.29, abs=0.02)


def test_noise_of_a_robot_does_not_depend_on_the_other_robots():
    both = simulation(scenario())
    alone = simulation(replace(scenario(), robots=scenario().robots[:1]))
    for tick in range(0, 20, 2):
        assert both.sense(tick, tick / RATE + 1)[0] == alone.sense(tick, tick / RATE + 1)[0]


def test_perfect_link_delivers_once_and_at_once():
    assert list(PerfectLink().deliveries("robot1", "robot2", 3.0)) == [0.0]
    assert list(PerfectLink().deliveries("", "robot2", 3.0)) == [0.0]
