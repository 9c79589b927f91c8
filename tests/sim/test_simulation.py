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
    RadioSetup,
    RobotSetup,
    ScenarioEvent,
    ScenarioEventKind,
    ScenarioSpec,
    SensorSetup,
    Twist,
)
from rqt_mrta_py.sim import Simulation
from rqt_mrta_py.sim.plugin import (
    mrta_register_links,
    mrta_register_robot_models,
    mrta_register_sensors,
    mrta_register_team_sensors,
    mrta_register_worlds,
)
from rqt_mrta_py.sim.robot_models import DIFF_DRIVE
from tests.sim.doubles import StillWorld
from tests.sim.expanding import by_robot

KIND = ScenarioEventKind
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
        "team_sensors": mrta_register_team_sensors(),
        "worlds": {"still": lambda: StillWorld() if world is None else world, **mrta_register_worlds()},
        "links": mrta_register_links(),
        "link_random": lambda sender, receiver: np.random.default_rng([*f"{sender} {receiver}".encode()]),
        "generators": {robot.id: np.random.default_rng(index) for index, robot in enumerate(spec.robots)},
    }
    return Simulation(scenario=spec, **{**known, **changes})


def play(simulated, ticks):
    """Give for each tick the events that happened and who spoke."""
    played = []
    for tick in range(ticks):
        now = tick / RATE + 1
        happened = simulated.begin_tick(tick, now)
        speakers = list(by_robot(simulated.sense(tick, now)))
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
    said = by_robot(simulated.sense(0, 1.0))
    assert list(said) == ["robot1", "robot2"]
    assert [outgoing.topic for outgoing in said["robot2"]] == ["pose", "odom", "/tf"]
    assert list(simulated.sense(1, 1.05)) == []


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
    ((subscription, hear),) = simulated.robots["robot1"].listeners()
    driven = []
    for tick in range(3):
        now = tick / RATE + 1
        simulated.begin_tick(tick, now)
        hear(Heard("/robot1/cmd_vel", subscription.type, now, {"linear/x": 0.4, "linear/y": 0.0, "angular/z": 1.0}))
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
    ((subscription, hear),) = simulated.robots["robot1"].listeners()
    driven = []
    for tick in range(4):
        now = tick / RATE + 1
        simulated.begin_tick(tick, now)
        if tick != 2:
            receipt = now + simulated.clock_offset("robot1")
            fields = {"linear/x": 0.3, "linear/y": 0.0, "angular/z": 0.0}
            hear(Heard("/robot1/cmd_vel", subscription.type, receipt, fields))
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


def test_simulation_tells_the_problems_of_all_sensors_of_a_robot_at_once():
    sensors = (
        SensorSetup("odometry", "odom", 50.0),
        SensorSetup("localiser", "pose", 10.0, {"position_noise": -1}),
        SensorSetup("range_finder", "scan", 10.0, {"rays": 2.5}),
    )
    with pytest.raises(SimError) as caught:
        simulation(scenario(robots=(RobotSetup("robot1", "diff_drive", Pose(0.0, 0.0), sensors),)))
    assert str(caught.value).splitlines() == [
        "robot robot1: sensor localiser on pose: parameter position_noise: must be a number at least 0 (got -1)",
        "robot robot1: sensor odometry on odom: rate must be above 0, at most the control rate of 20 Hz (got 50.0)",
        "robot robot1: sensor range_finder on scan: parameter rays: must be a whole number from 1 to 3600 (got 2.5)",
    ]


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
    worlds = {"still": StillWorld, "bullet": StillWorld}
    with pytest.raises(SimError) as caught:
        simulation(scenario(robots=robots, world="bulet"), worlds=worlds, models={"diff_drive": DIFF_DRIVE})
    assert str(caught.value).splitlines() == [
        "scenario: no world 'bulet'; nearest is 'bullet'",
        "robot robot1: no robot model 'dif_drive'; nearest is 'diff_drive'",
        "robot robot1: no sensor 'range_findr' for scan; nearest is 'range_finder'",
        "robot robot2: no robot model 'hexapod'; accepted: diff_drive",
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
        (ScenarioEvent(-1.0, STOPS, "robot1"), "event robot_stops at -1 s: time: must be a number from 0 s (got -1.0)"),
        (
            ScenarioEvent(math.nan, STOPS, "robot1"),
            "event robot_stops at nan s: time: must be a number from 0 s (got nan)",
        ),
        (
            ScenarioEvent(1.0, STOPS, "robot9"),
            "event robot_stops at 1 s: robot: 'robot9' is no robot of the scenario; nearest is 'robot2'",
        ),
        (ScenarioEvent(1.0, STOPS), "event robot_stops at 1 s: robot: is missing; give a text"),
        (
            ScenarioEvent(1.0, RETURNS, "robot1"),
            "event robot_returns at 1 s: kind: robot1 is not stopped then; let it stop before, once for each return",
        ),
        (
            ScenarioEvent(1.0, KIND.ROBOT_SLOWS, "robot1", parameters={"factor": math.nan}),
            "event robot_slows at 1 s: parameters/factor: must be a number from 0 to 1 (got nan)",
        ),
        (
            ScenarioEvent(1.0, KIND.ROBOT_SLOWS, "robot1", parameters={"factor": 10**400}),
            "event robot_slows at 1 s: parameters/factor: must be a number from 0 to 1 (got "
            "100000000000000000000000000000000000000000000000000000000000...)",
        ),
        (
            ScenarioEvent(1.0, KIND.ROBOT_CLOCK_SHIFTS, "robot1", parameters={"offset": "late"}),
            "event robot_clock_shifts at 1 s: parameters/offset: must be a number from -1e+06 to 1e+06 s (got 'late'); "
            "YAML takes this for a text: no quotes, and a dot before an exponent, such as 1.0e-3",
        ),
        (
            ScenarioEvent(1.0, KIND.RADIO_HEALS, parameters={"at": 1}),
            "event radio_heals at 1 s: parameters: does not go with kind radio_heals; accepted: time, kind",
        ),
        (
            ScenarioEvent(1.0, KIND.RADIO_PARTITIONS, parameters={"groups": [["robot1", 2]]}),
            "event radio_partitions at 1 s: parameters/groups: must be a list of lists of texts (got [['robot1', 2]])",
        ),
        (
            ScenarioEvent(1.0, KIND.RADIO_CHANGES, parameters={"kind": "losy"}),
            "event radio_changes at 1 s: no radio 'losy'; nearest is 'lossy'",
        ),
        (
            ScenarioEvent(1.0, KIND.RADIO_CHANGES, parameters={"kind": "lossy", "loss": 2}),
            "event radio_changes at 1 s: loss: must be a number from 0 to 1 (got 2)",
        ),
    ],
)
def test_simulation_refuses_an_event_that_cannot_happen(event, message):
    with pytest.raises(SimError) as caught:
        simulation(scenario(event))
    assert str(caught.value) == message


def test_simulation_tells_what_is_wrong_with_all_radios_at_once():
    spec = scenario(
        ScenarioEvent(2.0, KIND.RADIO_CHANGES, parameters={"kind": "perfect", "loss": 0.1}),
        radio=RadioSetup("lossy", {"loss": -1, "range": 0}),
    )
    with pytest.raises(SimError) as caught:
        simulation(spec)
    assert str(caught.value).splitlines() == [
        "radio lossy: loss: must be a number from 0 to 1 (got -1)",
        "radio lossy: range: must be a number above 0 m (got 0)",
        "event radio_changes at 2 s: loss: is not known; there is none",
    ]


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
            list(simulated.sense(tick, now))
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
        said = by_robot(both.sense(tick, tick / RATE + 1))
        assert {"robot1": said["robot1"]} == by_robot(alone.sense(tick, tick / RATE + 1))
