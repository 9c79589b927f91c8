"""What is wrong with a scenario is told before anything moves, and all of it."""

from __future__ import annotations

import math

import pytest

from rqt_mrta_py.errors import SimError
from rqt_mrta_py.model import Pose, RadioSetup, RobotSetup, ScenarioEvent, ScenarioEventKind, SensorSetup
from rqt_mrta_py.sim.robot_models import DIFF_DRIVE
from tests.sim.doubles import StillWorld
from tests.sim.scenarios import RETURNS, STOPS, scenario, simulation

KIND = ScenarioEventKind


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
