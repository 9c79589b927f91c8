"""Part of a team, and what it knows of the map."""

from __future__ import annotations

import dataclasses

import pytest

from rqt_mrta_py.app.selection import with_map, with_robots
from rqt_mrta_py.errors import UsageError
from rqt_mrta_py.model import (
    ApplicationRobot,
    ApplicationSpec,
    ArchitectureSpec,
    Arena,
    MapKnowledge,
    Mission,
    Pose,
    RobotSetup,
    ScenarioEvent,
    ScenarioEventKind,
    ScenarioSpec,
    SensorSetup,
    Task,
    Taxonomy,
)

KIND = ScenarioEventKind


def mission(*events: ScenarioEvent) -> Mission:
    robots = ("r1", "r2", "r3")
    setups = tuple(RobotSetup(name, "diff_drive", Pose(float(index), 0.0)) for index, name in enumerate(robots))
    return Mission(
        application=ApplicationSpec("yard", "Yard", "auction", tuple(ApplicationRobot(name) for name in robots)),
        architecture=ArchitectureSpec("auction", "Auction", Taxonomy()),
        tasks=(Task("dig", "dig_hole"),),
        parameters={name: {"bid": 1.0} for name in robots},
        scenario=ScenarioSpec(Arena(-5.0, -5.0, 5.0, 5.0), (), setups, events),
        later_tasks=(Task("fill", "fill_hole"),),
    )


def events_of(part: Mission) -> list[ScenarioEvent]:
    assert part.scenario is not None
    return list(part.scenario.events)


def test_whole_team_is_the_mission_itself() -> None:
    whole = mission()
    assert with_robots(whole, ["r3", "r2", "r1", "r9"]) is whole


def test_part_of_a_team_keeps_its_robots_and_all_tasks() -> None:
    part = with_robots(mission(), ["r3", "r1"])
    assert [robot.id for robot in part.application.robots] == ["r1", "r3"]
    assert part.scenario is not None
    assert [robot.id for robot in part.scenario.robots] == ["r1", "r3"]
    assert list(part.parameters) == ["r1", "r3"]
    assert [task.id for task in (*part.tasks, *part.later_tasks)] == ["dig", "fill"]


def test_part_of_a_team_has_no_events_of_robots_that_are_left_out() -> None:
    stays = [
        ScenarioEvent(1.0, KIND.ROBOT_SLOWS, "r1", None, {"factor": 0.5}),
        ScenarioEvent(2.0, KIND.RADIO_CHANGES, None, None, {"kind": "lossy"}),
        ScenarioEvent(3.0, KIND.TASK_APPEARS, None, "fill"),
        ScenarioEvent(4.0, KIND.TASK_REASSIGNED, "r1", "fill"),
    ]
    goes = [
        ScenarioEvent(1.0, KIND.ROBOT_STOPS, "r2"),
        ScenarioEvent(2.0, KIND.RADIO_FAILS, "r3"),
        ScenarioEvent(5.0, KIND.TASK_REASSIGNED, "r2", "fill"),
    ]
    assert events_of(with_robots(mission(*stays, *goes), ["r1"])) == stays


def test_partition_of_a_part_of_a_team_names_its_robots_only() -> None:
    event = ScenarioEvent(1.0, KIND.RADIO_PARTITIONS, None, None, {"groups": [["r1", "r2"], ["r2"], ["r3"]]})
    (left,) = events_of(with_robots(mission(event), ["r1", "r3"]))
    assert left.parameters == {"groups": [["r1"], ["r3"]]}


def test_without_a_word_robots_know_of_the_map_what_the_scenario_says() -> None:
    whole = mission()
    assert with_map(whole, None) is whole


def test_all_robots_know_the_map_or_none() -> None:
    sensors = tuple(SensorSetup(kind, topic, 10.0) for kind, topic in (("localiser", "pose"), ("range_finder", "scan")))
    whole = mission()
    assert whole.scenario is not None
    able = tuple(dataclasses.replace(robot, sensors=sensors) for robot in whole.scenario.robots)
    whole = dataclasses.replace(whole, scenario=dataclasses.replace(whole.scenario, robots=able))
    for knowledge in (MapKnowledge.UNKNOWN, MapKnowledge.KNOWN):
        whole = with_map(whole, knowledge)
        assert whole.scenario is not None
        assert [robot.map for robot in whole.scenario.robots] == [knowledge] * 3


def test_a_robot_without_the_sensors_cannot_be_asked_to_map() -> None:
    with pytest.raises(UsageError) as caught:
        with_map(mission(), MapKnowledge.UNKNOWN)
    assert str(caught.value) == (
        "--map unknown: r1 has no sensor on the topic pose nor on scan, by which it could map; "
        "give it sensors on pose and scan, or let the map be known"
    )
