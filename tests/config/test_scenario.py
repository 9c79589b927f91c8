"""scenario.yaml."""

from __future__ import annotations

from typing import List

import pytest

from rqt_mrta_py.config.scenario.event_form import EVENT
from rqt_mrta_py.config.scenario.form import SCENARIO_FILE
from rqt_mrta_py.config.scenario.scenario_file import read_scenario
from rqt_mrta_py.config.tasks.tasks_file import TASKS_FILE
from rqt_mrta_py.config.yaml.schema import Key, Table, ValueType
from rqt_mrta_py.errors import ConfigError
from rqt_mrta_py.model import (
    Arena,
    Dispenser,
    LooseBody,
    MapKnowledge,
    Obstacle,
    Pose,
    RadioSetup,
    RobotSetup,
    ScenarioEvent,
    ScenarioEventKind,
    ScenarioSpec,
    SensorSetup,
)

MINIMAL = """
arena: {min_x: -3, min_y: -3, max_x: 3, max_y: 3}
robots:
  - {id: robot1, start: {x: 0, y: 0}}
"""


def test_scenario_that_says_the_least_takes_defaults() -> None:
    assert read_scenario(MINIMAL, "s.yaml") == ScenarioSpec(
        arena=Arena(-3.0, -3.0, 3.0, 3.0, 0.3),
        obstacles=(),
        robots=(RobotSetup("robot1", "diff_drive", Pose(0.0, 0.0)),),
        world="bullet",
        duration=60.0,
        control_rate=20,
        picture_period=1.0,
        radio=RadioSetup("perfect"),
        planner="astar",
    )


def test_scenario_is_read_whole() -> None:
    text = """
world: planar
planner: theta_star
radio: {kind: lossy, loss: 0.1}
duration: 12.5
control_rate: 10
picture_period: 0
arena: {min_x: 0, min_y: 0, max_x: 4, max_y: 2, wall_height: 0.5}
obstacles:
  - {id: crate, x: 1, y: 1, yaw: 0.5, size: [1, 0.5, 0.4]}
  - {id: tank, shape: cylinder, x: 3, y: 1, size: [0.6, 0.6, 0.8]}
robot_defaults:
  model: rover
  sensors: [{kind: range_finder, topic: scan, rate: 5, rays: 36, range: {min: 0.1}}]
robots:
  - {id: /r1, start: {x: 0.5, y: 0.5, yaw: 1.5}}
  - {id: r2, start: {x: 3.5, y: 1.5}, model: crawler, sensors: [], capabilities: [lift], map: known}
events:
  - {time: 9, kind: robot_returns, robot: r1}
  - {time: 3, kind: robot_stops, robot: /r1}
  - {time: 3, kind: robot_stops, robot: r2}
"""

    scan = SensorSetup("range_finder", "scan", 5.0, {"rays": 36, "range": {"min": 0.1}})
    stops = ScenarioEventKind.ROBOT_STOPS
    assert read_scenario(text, "s.yaml", ["r1", "r2"]) == ScenarioSpec(
        arena=Arena(0.0, 0.0, 4.0, 2.0, 0.5),
        obstacles=(
            Obstacle("crate", Pose(1.0, 1.0, 0.5), (1.0, 0.5, 0.4)),
            Obstacle("tank", Pose(3.0, 1.0), (0.6, 0.6, 0.8), "cylinder"),
        ),
        robots=(
            RobotSetup("r1", "rover", Pose(0.5, 0.5, 1.5), (scan,)),
            RobotSetup("r2", "crawler", Pose(3.5, 1.5), (), ("lift",)),
        ),
        events=(
            ScenarioEvent(3.0, stops, "r1"),
            ScenarioEvent(3.0, stops, "r2"),
            ScenarioEvent(9.0, ScenarioEventKind.ROBOT_RETURNS, "r1"),
        ),
        world="planar",
        duration=12.5,
        control_rate=10,
        picture_period=0.0,
        radio=RadioSetup("lossy", {"loss": 0.1}),
        planner="theta_star",
    )


def test_robots_that_map_say_so_themselves_or_by_the_defaults() -> None:
    text = """
arena: {min_x: 0, min_y: 0, max_x: 4, max_y: 2}
robot_defaults:
  map: unknown
  sensors: [{kind: localiser, topic: pose, rate: 10}, {kind: range_finder, topic: scan, rate: 10}]
robots:
  - {id: r1, start: {x: 0.5, y: 0.5}}
  - {id: r2, start: {x: 3.5, y: 1.5}, map: known}
"""

    robots = read_scenario(text, "s.yaml").robots

    assert [robot.map for robot in robots] == [MapKnowledge.UNKNOWN, MapKnowledge.KNOWN]


def test_a_robot_that_cannot_map_is_told_of_with_the_line_that_wants_it_to() -> None:
    text = """
arena: {min_x: 0, min_y: 0, max_x: 4, max_y: 2}
robot_defaults:
  map: unknown
robots:
  - {id: r1, start: {x: 0.5, y: 0.5}}
"""

    with pytest.raises(ConfigError) as caught:
        read_scenario(text, "s.yaml")

    assert str(caught.value) == (
        "s.yaml:4: robot_defaults/map: r1 has no sensor on the topic pose nor on scan, by which it could map; "
        "give it sensors on pose and scan, or let the map be known"
    )


def test_bodies_of_a_scenario_are_read_in_file_order() -> None:
    text = f"""{MINIMAL}
bodies:
  - {{id: /can2, kind: can, x: 1, y: -1, yaw: 0.5, size: [0.1, 0.08, 0.06], mass: 0.3}}
  - {{id: can1, x: 2, y: 0, size: [0.1, 0.1, 0.1]}}
"""

    assert read_scenario(text, "s.yaml").bodies == (
        LooseBody("can2", Pose(1.0, -1.0, 0.5), (0.1, 0.08, 0.06), 0.3, "can"),
        LooseBody("can1", Pose(2.0, 0.0), (0.1, 0.1, 0.1), 0.2, "thing"),
    )


def test_bodies_that_can_be_none_are_told_all_at_once() -> None:
    text = f"""{MINIMAL}
bodies:
  - {{id: can, x: 1, y: -1, size: [0.1, 0, 0.1]}}
  - {{id: can, x: 2, y: 0, size: [0.1, 0.1, 0.1], mass: 0}}
"""

    with pytest.raises(ConfigError) as caught:
        read_scenario(text, "s.yaml")

    assert str(caught.value) == (
        "s.yaml:7: bodies[0]/size: must be above 0 m in each direction (got [0.1, 0.0, 0.1])\n"
        "s.yaml:8: bodies[1]/id: 'can' names two bodies; the first one is in line 7\n"
        "s.yaml:8: bodies[1]/mass: must be a number above 0 kg (got 0)"
    )


def test_friction_of_bodies_and_dispensers_are_read() -> None:
    text = f"""{MINIMAL}
bodies:
  - {{id: b1, x: 1, y: -1, size: [0.18, 0.07, 0.07], friction: 0.8}}
dispensers:
  - {{id: sw3, kind: block3, x: 0.2, y: 0.2, yaw: 0.785, size: [0.18, 0.07, 0.07],
      mass: 0.06, friction: 0.8, stock: 22}}
  - {{id: /se1, x: 2, y: 0.2, size: [0.06, 0.07, 0.07]}}
"""

    scenario = read_scenario(text, "s.yaml")

    assert scenario.bodies == (LooseBody("b1", Pose(1.0, -1.0), (0.18, 0.07, 0.07), friction=0.8),)
    assert scenario.dispensers == (
        Dispenser("sw3", Pose(0.2, 0.2, 0.785), (0.18, 0.07, 0.07), 0.06, "block3", 0.8, 22),
        Dispenser("se1", Pose(2.0, 0.2), (0.06, 0.07, 0.07), 0.2, "thing", 0.5, None),
    )
    assert [body.id for body in scenario.first_bodies] == ["b1", "sw3_1", "se1_1"]


def test_dispensers_that_can_be_none_are_told_all_at_once() -> None:
    text = f"""{MINIMAL}
dispensers:
  - {{id: a, x: 1, y: -1, size: [0.1, 0.1, -1], friction: -0.5}}
  - {{id: a, x: 2, y: 0, size: [0.1, 0.1, 0.1], stock: 0}}
"""

    with pytest.raises(ConfigError) as caught:
        read_scenario(text, "s.yaml")

    assert str(caught.value) == (
        "s.yaml:7: dispensers[0]/friction: must be a number from 0 N/N (got -0.5)\n"
        "s.yaml:7: dispensers[0]/size: must be above 0 m in each direction (got [0.1, 0.1, -1.0])\n"
        "s.yaml:8: dispensers[1]/id: 'a' names two dispensers; the first one is in line 7\n"
        "s.yaml:8: dispensers[1]/stock: must be a whole number from 1 (got 0)"
    )


def test_scenario_has_the_robots_of_the_application() -> None:
    with pytest.raises(ConfigError) as caught:
        read_scenario(MINIMAL, "s.yaml", ["robot2", "robot3"])

    assert str(caught.value) == (
        "s.yaml:3: robots: the application also has robot2, robot3; say where they start\n"
        "s.yaml:4: robots[0]/id: 'robot1' is no robot of the application; nearest is 'robot3'"
    )


EVERY_KIND = """
arena: {min_x: -3, min_y: -3, max_x: 3, max_y: 3}
robots:
  - {id: r1, start: {x: 0, y: 0}}
  - {id: r2, start: {x: 1, y: 0}}
events:
  - {time: 1, kind: robot_stops, robot: r1}
  - {time: 2, kind: robot_returns, robot: r1}
  - {time: 3, kind: robot_sticks, robot: r1}
  - {time: 4, kind: robot_comes_free, robot: r1}
  - {time: 5, kind: robot_slows, robot: r1, parameters: {factor: 0.5}}
  - {time: 6, kind: robot_clock_shifts, robot: r1, parameters: {offset: -2}}
  - {time: 7, kind: radio_fails, robot: r1}
  - {time: 8, kind: radio_returns, robot: r1}
  - {time: 9, kind: radio_partitions, parameters: {groups: [[/r1], [r2]]}}
  - {time: 10, kind: radio_heals}
  - {time: 11, kind: radio_changes, parameters: {kind: lossy, loss: 0.2}}
  - {time: 12, kind: task_appears, task: dig}
  - {time: 13, kind: task_reassigned, task: /dig, robot: r2}
  - {time: 14, kind: task_withdrawn, task: dig}
  - {time: 15, kind: robot_removed, robot: r1}
"""


def test_event_of_every_kind_is_read() -> None:
    kind = ScenarioEventKind
    assert read_scenario(EVERY_KIND, "s.yaml", ["r1", "r2"], ["dig", "fill"]).events == (
        ScenarioEvent(1.0, kind.ROBOT_STOPS, "r1"),
        ScenarioEvent(2.0, kind.ROBOT_RETURNS, "r1"),
        ScenarioEvent(3.0, kind.ROBOT_STICKS, "r1"),
        ScenarioEvent(4.0, kind.ROBOT_COMES_FREE, "r1"),
        ScenarioEvent(5.0, kind.ROBOT_SLOWS, "r1", None, {"factor": 0.5}),
        ScenarioEvent(6.0, kind.ROBOT_CLOCK_SHIFTS, "r1", None, {"offset": -2.0}),
        ScenarioEvent(7.0, kind.RADIO_FAILS, "r1"),
        ScenarioEvent(8.0, kind.RADIO_RETURNS, "r1"),
        ScenarioEvent(9.0, kind.RADIO_PARTITIONS, None, None, {"groups": [["r1"], ["r2"]]}),
        ScenarioEvent(10.0, kind.RADIO_HEALS),
        ScenarioEvent(11.0, kind.RADIO_CHANGES, None, None, {"kind": "lossy", "loss": 0.2}),
        ScenarioEvent(12.0, kind.TASK_APPEARS, None, "dig"),
        ScenarioEvent(13.0, kind.TASK_REASSIGNED, "r2", "dig"),
        ScenarioEvent(14.0, kind.TASK_WITHDRAWN, None, "dig"),
        ScenarioEvent(15.0, kind.ROBOT_REMOVED, "r1"),
    )


def test_every_kind_of_event_has_a_form() -> None:
    assert set(EVENT.variants) == {kind.value for kind in ScenarioEventKind}


def said(events: str) -> List[str]:
    head = EVERY_KIND[: EVERY_KIND.index("events:")].lstrip("\n")
    with pytest.raises(ConfigError) as caught:
        read_scenario(f"{head}events:\n{events}", "s", ["r1", "r2"], ["dig", "fill"])
    return [str(problem) for problem in caught.value.problems]


@pytest.mark.parametrize(
    ("event", "message"),
    [
        (
            "{time: 1, kind: robot_slows, robot: r1}",
            "parameters: is missing; give a mapping of known keys (factor)",
        ),
        (
            "{time: 1, kind: robot_slows, robot: r1, parameters: {factor: 1.5}}",
            "parameters/factor: must be a number from 0 to 1 (got 1.5)",
        ),
        (
            "{time: 1, kind: robot_slows, robot: r1, parameters: {factor: half}}",
            "parameters/factor: must be a number from 0 to 1 (got 'half'); YAML takes this for a text: no quotes, and "
            "a dot before an exponent, such as 1.0e-3",
        ),
        (
            "{time: 1, kind: robot_slows, robot: r1, parameters: {factor: 0.5, unit: m}}",
            "parameters/unit: is not known; accepted: factor",
        ),
        (
            "{time: 1, kind: robot_clock_shifts, robot: r1, parameters: {offset: 1.0e+300}}",
            "parameters/offset: must be a number from -1e+06 to 1e+06 s (got 1e+300)",
        ),
        (
            "{time: 1, kind: robot_clock_shifts, robot: r1, parameters: {ofset: 1}}",
            "parameters/offset: is missing; give a number from -1e+06 to 1e+06 s",
        ),
        (
            "{time: 1, kind: radio_partitions, parameters: {groups: [r1, r2]}}",
            "parameters/groups: must be a list of lists of texts (got ['r1', 'r2'])",
        ),
        (
            "{time: 1, kind: radio_partitions, parameters: {groups: [[r1, r22]]}}",
            "parameters/groups: 'r22' is no robot of the scenario; nearest is 'r2'",
        ),
        (
            "{time: 1, kind: radio_partitions, robot: r1, parameters: {groups: []}}",
            "robot: does not go with kind radio_partitions; accepted: time, kind, parameters",
        ),
        ("{time: 1, kind: radio_changes, parameters: {loss: 0.5}}", "parameters/kind: is missing; give a text"),
        (
            "{time: 1, kind: robot_stops, robot: r1, task: dig}",
            "task: does not go with kind robot_stops; accepted: time, kind, robot",
        ),
        ("{time: 1, kind: task_appears}", "task: is missing; give a text"),
        ("{time: 1, kind: task_appears, task: dog}", "task: 'dog' is no task of the application; nearest is 'dig'"),
        ("{time: 1, kind: task_reassigned, task: dig}", "robot: is missing; give a text"),
        (
            "{time: 1, kind: task_reassigned, task: dig, robot: r22}",
            "robot: 'r22' is no robot of the scenario; nearest is 'r2'",
        ),
        ("{kind: radio_heals, robt: r1}", "robt: is not known; accepted: time, kind"),
        (
            "{time: 1, kind: robot_returns, robot: r1}",
            "kind: r1 is not stopped then; let it stop before, once for each return",
        ),
        (
            "{time: 1, kind: robot_comes_free, robot: r1}",
            "kind: r1 is not stuck then; let it stick before, once for each coming free",
        ),
        (
            "{time: 1, kind: radio_returns, robot: r2}",
            "kind: the radio of r2 works then; let it fail before, once for each return",
        ),
        ("{time: 1, kind: radio_heals}", "kind: the radio is not partitioned then; let it be partitioned before"),
    ],
)
def test_event_that_cannot_happen_is_refused(event: str, message: str) -> None:
    problems = said(f"  - {event}\n")
    assert f"s:6: events[0]/{message}" in problems


def test_events_are_checked_in_the_order_of_time() -> None:
    assert said(
        """
  - {time: 9, kind: robot_stops, robot: r1}
  - {time: 5, kind: robot_returns, robot: r1}
  - {time: 3, kind: robot_stops, robot: r2}
  - {time: 5, kind: robot_returns, robot: r2}
  - {time: 5, kind: robot_returns, robot: r2}
  - {time: 7, kind: robot_comes_free, robot: r2}
  - {time: 1, kind: radio_partitions, parameters: {groups: [[r1]]}}
  - {time: 2, kind: radio_partitions, parameters: {groups: [[r2]]}}
  - {time: 3, kind: radio_heals}
  - {time: 4, kind: radio_heals}
"""
    ) == [
        "s:8: events[1]/kind: r1 is not stopped then; let it stop before, once for each return",
        "s:11: events[4]/kind: r2 is not stopped then; let it stop before, once for each return",
        "s:12: events[5]/kind: r2 is not stuck then; let it stick before, once for each coming free",
        "s:16: events[9]/kind: the radio is not partitioned then; let it be partitioned before",
    ]


def test_nothing_happens_to_a_robot_after_it_was_removed() -> None:
    """What was begun before need not end, and operators may still name it."""
    assert said(
        """
  - {time: 1, kind: robot_stops, robot: r1}
  - {time: 9, kind: robot_returns, robot: r1}
  - {time: 5, kind: robot_removed, robot: r1}
  - {time: 6, kind: robot_removed, robot: r1}
  - {time: 7, kind: task_reassigned, task: dig, robot: r1}
  - {time: 8, kind: robot_removed, robot: r2}
"""
    ) == [
        f"s:{line}: events[{number}]/robot: 'r1' was removed for good at 5 s; let nothing happen to it afterwards"
        for line, number in ((8, 1), (10, 3))
    ]


def test_task_is_there_from_its_appearance_until_it_is_withdrawn() -> None:
    """One that is reassigned before it appears is there all the time."""
    assert said(
        """
  - {time: 4, kind: task_appears, task: dig}
  - {time: 5, kind: task_appears, task: dig}
  - {time: 6, kind: task_withdrawn, task: dig}
  - {time: 7, kind: task_withdrawn, task: dig}
  - {time: 7, kind: task_reassigned, task: dig, robot: r1}
  - {time: 7, kind: task_appears, task: dig}
  - {time: 8, kind: task_reassigned, task: dig, robot: r1}
  - {time: 8, kind: task_reassigned, task: fill, robot: r1}
  - {time: 9, kind: task_appears, task: fill}
"""
    ) == [
        "s:8: events[1]/task: 'dig' is there already; let it be withdrawn before it appears again",
        "s:10: events[3]/task: 'dig' was withdrawn at 6 s; let it appear again before",
        "s:11: events[4]/task: 'dig' was withdrawn at 6 s; let it appear again before",
        "s:15: events[8]/task: 'fill' is there already; let it be withdrawn before it appears again",
    ]


def tables(table: Table) -> list[Table]:
    inner = [key.table for key in table.keys if key.table is not None]
    return [table, *(found for child in (*inner, *table.variants.values()) for found in tables(child))]


@pytest.mark.parametrize("table", [*tables(SCENARIO_FILE), *tables(TASKS_FILE)], ids=lambda table: table.name)
def test_form_documents_every_key_with_a_sentence_and_every_number_with_a_unit(table: Table) -> None:
    def complete(key: Key) -> bool:
        is_ratio = (key.minimum, key.maximum) == (0, 1)
        return key.summary.endswith(".") and (bool(key.unit) or is_ratio or key.type is not ValueType.NUMBER)

    assert table.summary.endswith(".")
    assert [key.name for key in table.keys if not complete(key)] == []
