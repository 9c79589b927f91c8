"""A supervisor that comes late begins with what another one tells, for as long as that counts."""

from __future__ import annotations

from typing import Any, Dict, List, Mapping, Tuple

import pytest

from rqt_mrta_py.hooks import Heard
from rqt_mrta_py.supervisor import Standing, standing_of
from tests.supervisor.mini import Stream, allocations, history, mission, of_kind, states

TOLD = ("/mrta/team_state", "rqt_mrta_py/TeamState")


def team_state(
    stamp: float, robots: Mapping[str, int], tasks: Mapping[str, int], holds: List[Tuple[str, str]]
) -> Dict[str, Any]:
    """Make the fields of a TeamState; codes are those of RobotState.msg and TaskState.msg."""
    return {
        "header": {"stamp": stamp},
        "robots": [{"robot_id": robot, "state": state} for robot, state in robots.items()],
        "tasks": [{"task_id": task, "state": state} for task, state in tasks.items()],
        "allocations": [{"robot_id": robot, "task_id": task} for robot, task in holds],
    }


PATROL = team_state(9.5, {"robot1": 2, "robot2": 1}, {"patrol": 2, "inspect": 0, "report": 3}, [("robot1", "patrol")])


def told(stream: Stream, now: float, fields: Mapping[str, Any]) -> Standing:
    return stream.supervisor.assume(standing_of(fields), Heard(*TOLD, now, {}, caller="/supervisor"))


def test_late_supervisor_knows_at_once_what_the_other_one_tells_and_nothing_happens_by_that() -> None:
    stream = Stream()
    taken = told(stream, 10.0, PATROL)
    assert [(robot, state.value) for robot, state in taken.robots] == [("robot1", "busy"), ("robot2", "idle")]
    assert taken.holds == (("robot1", "patrol"),)
    assert sorted((task, state.value) for task, state in taken.tasks) == [("patrol", "executing"), ("report", "done")]
    record = stream.supervisor.record()
    assert allocations(record) == [("robot1", "patrol", 10.0, 10.0, "open")]
    assert [robot.last_heard for robot in record.robots] == [None, None]
    assert stream.events == []
    assert stream.supervisor.news() == []


def test_what_the_team_says_goes_on_from_there() -> None:
    """A busy message keeps an allocation going for 2 s."""
    stream = Stream()
    told(stream, 10.0, PATROL)
    stream.busy(10.5, "robot1", "patrol")
    stream.busy(12.0, "robot1", "inspect")
    stream.busy(13.9, "robot1", "inspect")
    record = stream.finish()
    assert allocations(record) == [
        ("robot1", "patrol", 10.0, 12.5, "preempted"),
        ("robot1", "inspect", 12.0, 13.9, "open"),
    ]
    assert history(record, "report") == [("done", 10.0, 13.9)]
    assert [event.task for event in of_kind(stream.events, "allocation_started")] == ["inspect"]


def test_what_nobody_says_again_ends_when_it_would_for_whoever_had_heard_it() -> None:
    """It was told at 9.5 s and counts for 2 s."""
    stream = Stream()
    told(stream, 10.0, PATROL)
    stream.tick(20.0)
    record = stream.finish()
    assert states(record, "robot1") == [("busy", 10.0, 11.5), ("offline", 11.5, 20.0)]
    assert allocations(record) == [("robot1", "patrol", 10.0, 11.5, "lost")]


def test_of_what_was_told_long_ago_only_ends_of_tasks_count() -> None:
    stream = Stream()
    taken = told(stream, 60.0, PATROL)
    assert not taken.robots
    assert not taken.holds
    assert [(task, state.value) for task, state in taken.tasks] == [("report", "done")]


def test_robots_that_have_spoken_know_better() -> None:
    stream = Stream()
    stream.busy(9.9, "robot1", "inspect")
    taken = told(stream, 10.0, PATROL)
    assert [robot for robot, _ in taken.robots] == ["robot2"]
    assert not taken.holds
    assert allocations(stream.supervisor.record()) == [("robot1", "inspect", 9.9, 10.0, "open")]


def test_of_another_team_nothing_is_taken_over() -> None:
    stream = Stream()
    assert not told(stream, 10.0, team_state(9.9, {"robot9": 2}, {"report": 3}, [("robot9", "patrol")]))
    assert not told(stream, 10.0, team_state(9.9, {}, {}, []))
    assert [task.state.value for task in stream.supervisor.record().tasks] == ["waiting"] * 3


def test_where_nothing_is_listed_robots_and_tasks_are_admitted() -> None:
    stream = Stream(mission(robots=(), tasks=()))
    told(stream, 10.0, PATROL)
    record = stream.supervisor.record()
    assert [robot.id for robot in record.robots] == ["robot1", "robot2"]
    assert [task.id for task in record.tasks] == ["patrol", "inspect", "report"]


@pytest.mark.parametrize("field", ["robots", "tasks"])
def test_states_that_nobody_has_defined_are_left_out(field: str) -> None:
    fields = team_state(9.5, {"robot1": 99}, {"patrol": 99}, [])
    assert getattr(standing_of(fields), field) == ()
