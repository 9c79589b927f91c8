"""Part of a team."""

from __future__ import annotations

from rqt_mrta_py.app.selection import with_robots
from rqt_mrta_py.model import (
    ApplicationRobot,
    ApplicationSpec,
    ArchitectureSpec,
    Arena,
    Mission,
    Pose,
    RobotSetup,
    ScenarioEvent,
    ScenarioEventKind,
    ScenarioSpec,
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
