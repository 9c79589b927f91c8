from __future__ import annotations

from dataclasses import replace
from typing import Optional

import pytest

from rqt_mrta_py.hooks.manager import PluginManager
from rqt_mrta_py.model import (
    Allocation,
    MissionRecord,
    Outcome,
    RobotInterval,
    RobotRecord,
    RobotState,
    TaskInterval,
    TaskRecord,
    TaskState,
    Taxonomy,
)
from rqt_mrta_py.supervisor import plugin
from rqt_mrta_py.supervisor.statistics import STATISTICS


def record(start: Optional[float] = 100.0, end: Optional[float] = 120.0, empty: bool = False) -> MissionRecord:
    """Twenty seconds of two robots and three tasks, made by hand."""
    robots = (
        RobotRecord(
            "robot1",
            (
                RobotInterval(RobotState.OFFLINE, 100.0, 102.0),
                RobotInterval(RobotState.BUSY, 102.0, 112.0),
                RobotInterval(RobotState.IDLE, 112.0, 116.0),
                RobotInterval(RobotState.BUSY, 116.0, 120.0),
            ),
        ),
        RobotRecord("robot2", (RobotInterval(RobotState.OFFLINE, 100.0, 120.0),)),
    )
    tasks = (
        TaskRecord("patrol", (TaskInterval(TaskState.WAITING, 100.0, 120.0),)),
        TaskRecord("inspect", (TaskInterval(TaskState.WAITING, 104.0, 120.0),)),
        TaskRecord("report", (TaskInterval(TaskState.WAITING, 100.0, 120.0),)),
    )
    allocations = (
        Allocation("patrol", "robot1", 102.0, 110.0, Outcome.GAVE_UP),
        Allocation("patrol", "robot2", 106.0, 108.0, Outcome.YIELDED),
        Allocation("inspect", "robot1", 109.0, 110.0, Outcome.LOST),
        Allocation("patrol", "robot2", 109.0, 114.0, Outcome.DONE),
        Allocation("patrol", "robot1", 118.0, 120.0, Outcome.OPEN),
    )
    return MissionRecord(
        "yard",
        "mrta_mini",
        Taxonomy(),
        None,
        start,
        end,
        () if empty else robots,
        () if empty else tasks,
        () if empty else allocations,
        (),
        (),
    )


@pytest.mark.parametrize(
    ("name", "value"),
    [
        ("utilisation", {"robot1": 14.0 / 20.0, "robot2": 0.0}),
        ("availability", {"robot1": 18.0 / 20.0, "robot2": 0.0}),
        # robot1 works for 14 s, robot2 never: 14^2 / (2 * 14^2).
        ("fairness", 0.5),
        ("makespan", None),
        # patrol is held from 102 to 114 and from 118 to 120, partly by two robots.
        ("coverage", {"patrol": 14.0 / 20.0, "inspect": 1.0 / 20.0, "report": 0.0}),
        (
            "allocations_by_outcome",
            {"done": 1, "failed": 0, "yielded": 1, "gave_up": 1, "lost": 1, "preempted": 0, "open": 1},
        ),
        # patrol goes from robot1 to robot2, stays there, and goes back.
        ("reallocations", 2),
        ("time_to_first_allocation", {"patrol": 2.0, "inspect": 5.0, "report": None}),
    ],
)
def test_statistic_is_what_the_hand_says(name: str, value: object) -> None:
    assert STATISTICS[name](record()) == value


@pytest.mark.parametrize("name", ["utilisation", "availability", "coverage"])
def test_share_of_a_mission_without_length_is_unknown(name: str) -> None:
    found = STATISTICS[name](record(end=100.0))
    assert set(found.values()) == {None}


@pytest.mark.parametrize(
    ("name", "value"),
    [
        ("utilisation", {}),
        ("availability", {}),
        ("coverage", {}),
        ("fairness", None),
        ("makespan", None),
        ("reallocations", 0),
        ("time_to_first_allocation", {}),
    ],
)
def test_statistic_of_nothing_is_empty(name: str, value: object) -> None:
    assert STATISTICS[name](record(None, None, empty=True)) == value


def test_work_spread_evenly_is_fair() -> None:
    busy = (RobotInterval(RobotState.BUSY, 100.0, 107.0),)
    robots = (RobotRecord("robot1", busy), RobotRecord("robot2", busy), RobotRecord("robot3", busy))
    assert STATISTICS["fairness"](replace(record(), robots=robots)) == pytest.approx(1.0)


def test_makespan_is_told_once_every_task_is_over() -> None:
    tasks = tuple(
        TaskRecord(name, (TaskInterval(TaskState.WAITING, 100.0, end), TaskInterval(state, end, 120.0)))
        for name, state, end in (
            ("patrol", TaskState.DONE, 112.0),
            ("inspect", TaskState.DONE, 109.0),
            ("report", TaskState.WITHDRAWN, 118.0),
        )
    )
    assert STATISTICS["makespan"](replace(record(), tasks=tasks)) == 12.0
    assert STATISTICS["makespan"](replace(record(), tasks=tasks[2:])) is None


def test_rules_and_statistics_come_through_the_hooks_that_everybody_uses() -> None:
    manager = PluginManager()
    manager.register(plugin, "supervisor")
    rules = manager.registered("mrta_register_incident_rules")
    assert list(rules) == [
        "busy_without_task",
        "duration_overrun",
        "flipping_allocation",
        "illegal_state_change",
        "message_from_the_future",
        "message_from_the_past",
        "robot_silent_with_task",
        "robot_with_two_tasks",
        "task_completed_twice",
        "task_held_by_nobody",
        "task_held_by_two_robots",
        "topic_gap",
        "unequal_share",
        "unknown_robot",
        "unknown_task",
    ]
    assert all(rule.causes.endswith(".") for rule in rules.values())
    assert manager.registered("mrta_register_statistics") == STATISTICS
