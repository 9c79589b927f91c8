"""What befalls robots and radio while a scenario is under way."""

from __future__ import annotations

from dataclasses import replace

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from rqt_mrta_py.model import (
    Obstacle,
    Pose,
    RadioSetup,
    RobotSetup,
    ScenarioEvent,
    ScenarioEventKind,
    SensorSetup,
    Twist,
)
from tests.sim.doubles import StillWorld
from tests.sim.expanding import by_robot
from tests.sim.scenarios import RATE, RETURNS, STOPS, play, scenario, simulation, tell

KIND = ScenarioEventKind


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
    said = by_robot(simulated.sense(0, 1.0))
    assert list(said) == ["robot1", "robot2"]
    assert [outgoing.topic for outgoing in said["robot2"]] == ["pose", "odom", "/tf"]
    assert list(simulated.sense(1, 1.05)) == []


def test_simulation_commands_the_world_what_robots_heard():
    world = StillWorld()
    simulated = simulation(scenario(), world)
    tell(simulated, "robot2", 1.0, 0.3, wz=0.1)
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


def test_stuck_robot_stands_still_but_is_heard():
    world = StillWorld()
    events = (ScenarioEvent(0.1, KIND.ROBOT_STICKS, "robot1"), ScenarioEvent(0.3, KIND.ROBOT_COMES_FREE, "robot1"))
    simulated = simulation(scenario(*events), world)
    assert all(speakers in ([], ["robot1", "robot2"]) for _, speakers in play(simulated, 9))
    assert world.frozen == [("robot1", True), ("robot1", False)]


def test_robot_moves_again_only_when_it_is_neither_stopped_nor_stuck():
    world = StillWorld()
    order = [STOPS, KIND.ROBOT_STICKS, RETURNS, KIND.ROBOT_STICKS, KIND.ROBOT_COMES_FREE, KIND.ROBOT_COMES_FREE]
    events = [ScenarioEvent(number / RATE, kind, "robot1") for number, kind in enumerate(order)]
    simulated = simulation(scenario(*events), world)
    stopped, frozen = [], []
    for tick in range(len(order)):
        simulated.begin_tick(tick, tick / RATE + 1)
        stopped.append(simulated.stopped("robot1"))
        frozen.append(world.frozen[-1])
    assert stopped == [True, True, False, False, False, False]
    assert frozen == [("robot1", True)] * 5 + [("robot1", False)]
    assert len(world.frozen) == 2


def test_slow_robot_drives_at_a_share_of_what_it_is_commanded():
    world = StillWorld()
    events = [
        ScenarioEvent(number / RATE, KIND.ROBOT_SLOWS, "robot1", parameters={"factor": factor})
        for number, factor in enumerate([0.25, 0.0, 1.0])
    ]
    simulated = simulation(scenario(*events), world)
    driven = []
    for tick in range(3):
        now = tick / RATE + 1
        simulated.begin_tick(tick, now)
        tell(simulated, "robot1", now, 0.4, wz=1.0)
        simulated.act(now)
        driven.append(world.commands["robot1"])
    assert driven == [Twist(0.1, 0.0, 0.25), Twist(), Twist(0.4, 0.0, 1.0)]


def test_robot_stamps_what_it_measures_by_its_own_clock():
    event = ScenarioEvent(0.1, KIND.ROBOT_CLOCK_SHIFTS, "robot1", parameters={"offset": 5.0})
    simulated = simulation(scenario(event))
    stamps = {}
    for tick in (0, 2):
        simulated.begin_tick(tick, tick / RATE + 1)
        for robot_id, outgoing in by_robot(simulated.sense(tick, tick / RATE + 1)).items():
            stamps[robot_id, tick] = {message.fields["header"]["stamp"] for message in outgoing[:2]}
            stamps[robot_id, tick].add(outgoing[2].fields["transforms"][0]["header"]["stamp"])
    assert stamps == {
        ("robot1", 0): {1.0},
        ("robot2", 0): {1.0},
        ("robot1", 2): {6.1},
        ("robot2", 2): {1.1},
    }
    assert (simulated.clock_offset("robot1"), simulated.clock_offset("robot2")) == (5.0, 0.0)


def test_robot_judges_the_age_of_a_command_by_its_own_clock():
    """What it heard by its old clock is too old for a clock that was set forward, until the next command."""
    world = StillWorld()
    event = ScenarioEvent(0.1, KIND.ROBOT_CLOCK_SHIFTS, "robot1", parameters={"offset": 5.0})
    simulated = simulation(scenario(event), world)
    driven = []
    for tick in range(4):
        now = tick / RATE + 1
        simulated.begin_tick(tick, now)
        if tick != 2:
            tell(simulated, "robot1", now + simulated.clock_offset("robot1"), 0.3)
        simulated.act(now)
        driven.append(world.commands["robot1"].vx)
    assert driven == [0.3, 0.3, 0.0, 0.3]


def test_clock_set_back_is_right_after_twice_the_time():
    event = ScenarioEvent(0.0, KIND.ROBOT_CLOCK_SHIFTS, "robot1", parameters={"offset": -0.05})
    simulated = simulation(scenario(event))
    offsets = []
    for tick in range(4):
        simulated.begin_tick(tick, tick / RATE + 1)
        offsets.append(simulated.clock_offset("robot1"))
    assert offsets == pytest.approx([0.0, -0.025, -0.05, -0.05])


def test_radio_fails_as_often_as_it_returns():
    order = [KIND.RADIO_FAILS, KIND.RADIO_FAILS, KIND.RADIO_RETURNS, KIND.RADIO_RETURNS]
    simulated = simulation(scenario(*(ScenarioEvent(i / RATE, kind, "robot1") for i, kind in enumerate(order))))
    heard = []
    for tick in range(4):
        simulated.begin_tick(tick, tick / RATE + 1)
        heard.append(len(simulated.radio.deliveries("robot1", "robot2", tick / RATE + 1)))
    assert heard == [0, 0, 0, 1]


def test_radio_is_that_of_the_scenario_until_it_changes():
    events = (
        ScenarioEvent(2 / RATE, KIND.RADIO_CHANGES, parameters={"kind": "perfect"}),
        ScenarioEvent(1 / RATE, KIND.RADIO_CHANGES, parameters={"kind": "lossy", "delay": 0.5}),
        ScenarioEvent(3 / RATE, KIND.RADIO_PARTITIONS, parameters={"groups": [["robot1"]]}),
        ScenarioEvent(4 / RATE, KIND.RADIO_HEALS),
    )
    simulated = simulation(scenario(*events, radio=RadioSetup("lossy", {"delay": 0.25})))
    delays = []
    for tick in range(5):
        simulated.begin_tick(tick, tick / RATE + 1)
        delays.append(list(simulated.radio.deliveries("robot1", "robot2", tick / RATE + 1)))
    assert delays == [[0.25], [0.5], [0.0], [], [0.0]]


def test_radio_reaches_as_far_as_the_robots_are_apart_now():
    class Rails(StillWorld):
        """Robot 2 leaves at a metre a step."""

        def poses(self):
            poses = super().poses()
            poses[1, 0] += self.steps
            return poses

    simulated = simulation(scenario(radio=RadioSetup("lossy", {"range": 2.5})), Rails())
    reached = []
    for _ in range(4):
        reached.append(len(simulated.radio.deliveries("robot1", "robot2", 1.0)))
        simulated.step()
    assert reached == [1, 1, 0, 0]


def test_chance_of_a_pair_does_not_depend_on_the_other_robots():
    radio = RadioSetup("lossy", {"loss": 0.5, "jitter": 0.1})
    robots = (*scenario().robots, RobotSetup("robot3", "diff_drive", Pose(0.0, 2.0)))
    few, many = simulation(scenario(radio=radio)), simulation(scenario(radio=radio, robots=robots))
    for _ in range(50):
        many.radio.deliveries("robot3", "robot2", 1.0)
        assert few.radio.deliveries("robot1", "robot2", 1.0) == many.radio.deliveries("robot1", "robot2", 1.0)


def test_chance_of_a_pair_goes_on_when_the_radio_changes():
    """A generator made anew would repeat itself."""
    radio = RadioSetup("lossy", {"jitter": 0.1})
    change = ScenarioEvent(0.0, KIND.RADIO_CHANGES, parameters={"kind": "lossy", "jitter": 0.1})
    simulated = simulation(scenario(change, radio=radio))
    before = simulated.radio.deliveries("robot1", "robot2", 1.0)
    simulated.begin_tick(0, 1.0)
    assert simulated.radio.deliveries("robot1", "robot2", 1.0) != before


def test_what_happens_to_tasks_changes_nothing_in_the_world():
    world = StillWorld(lacks=["freeze"])
    events = (
        ScenarioEvent(0.0, KIND.TASK_APPEARS, None, "dig"),
        ScenarioEvent(0.0, KIND.TASK_REASSIGNED, "robot1", "dig"),
    )
    simulated = simulation(scenario(*events), world)
    ((happened, speakers),) = play(simulated, 1)
    assert happened == list(events)
    assert speakers == ["robot1", "robot2"]
    assert world.frozen == []


def test_each_sensor_measures_at_its_own_rate():
    sensors = (
        SensorSetup("odometry", "odom", 10.0),
        SensorSetup("range_finder", "scan", 5.0),
        SensorSetup("localiser", "pose", 20.0),
    )
    robots = (RobotSetup("robot1", "diff_drive", Pose(1.0, 0.0), sensors),)
    simulated = simulation(scenario(robots=robots), StillWorld(seen=[1.5]))
    heard = [
        [outgoing.topic for messages in by_robot(simulated.sense(tick, 1.0)).values() for outgoing in messages]
        for tick in range(5)
    ]
    full = ["pose", "odom", "scan", "/tf"]
    assert heard == [full, ["pose"], ["pose", "odom", "/tf"], ["pose"], full]


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


def test_simulation_in_bullet_freezes_a_driving_robot_and_lets_it_go():
    spec = scenario(ScenarioEvent(1.0, STOPS, "robot1"), ScenarioEvent(2.0, RETURNS, "robot1"), world="bullet")
    simulated = simulation(spec)
    xs = []
    try:
        for tick in range(60):
            now = tick / RATE + 1
            simulated.begin_tick(tick, now)
            list(simulated.sense(tick, now))
            tell(simulated, "robot1", now, 0.3)
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
        said = by_robot(both.sense(tick, tick / RATE + 1))
        assert {"robot1": said["robot1"]} == by_robot(alone.sense(tick, tick / RATE + 1))
