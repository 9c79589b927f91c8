"""What the tables of a mission hold; times count from its stream's start, and a column's name ends in its unit."""

from __future__ import annotations

from enum import Enum
from typing import Any, Dict, Iterable, List, Mapping, Sequence, Tuple

from csv_tables.table import seconds

from rqt_mrta_py.model import Incident, MissionRecord

__all__ = ["Column", "Kind", "Table", "mission_tables", "pose_table"]


class Kind(Enum):
    """What the cells of a column are."""

    TEXT = "text"
    NUMBER = "number"
    TEXTS = "texts"
    EVIDENCE = "evidence"


Column = Tuple[Kind, List[Any]]
"""Cells of one kind; None where nothing is known."""

Table = Mapping[str, Column]
"""Columns of equal length by name, in their order."""


def mission_tables(record: MissionRecord) -> Dict[str, Table]:
    """Give the tables of a finished mission.

    Args:
        record: everything known of it.

    Returns:
        By name: robots, tasks, allocations, incidents with their evidence, events.
    """
    start = record.start or 0.0
    robots = [(robot.id, each) for robot in record.robots for each in robot.states]
    tasks = [(task.id, each) for task in record.tasks for each in task.history]
    return {
        "robots": {
            "robot": _texts(robot for robot, _ in robots),
            "state": _texts(each.state.value for _, each in robots),
            **_interval([(each.start, each.end) for _, each in robots], start),
        },
        "tasks": {
            "task": _texts(task for task, _ in tasks),
            "state": _texts(each.state.value for _, each in tasks),
            **_interval([(each.start, each.end) for _, each in tasks], start),
        },
        "allocations": {
            "task": _texts(each.task for each in record.allocations),
            "robot": _texts(each.robot for each in record.allocations),
            **_interval([(each.start, each.end) for each in record.allocations], start),
            "outcome": _texts(each.outcome.value for each in record.allocations),
        },
        "incidents": {
            "rule": _texts(each.rule for each in record.incidents),
            "severity": _texts(each.severity.value for each in record.incidents),
            **_interval([(each.start, each.end) for each in record.incidents], start),
            "robots": (Kind.TEXTS, [list(each.robots) for each in record.incidents]),
            "tasks": (Kind.TEXTS, [list(each.tasks) for each in record.incidents]),
            "text": _texts(each.text for each in record.incidents),
            "evidence": (Kind.EVIDENCE, [_evidence(each, start) for each in record.incidents]),
            "causes": _texts(each.causes for each in record.incidents),
        },
        "events": {
            "time_s": _times((each.time for each in record.events), start),
            "kind": _texts(each.kind for each in record.events),
            "severity": _texts(each.severity.value for each in record.events),
            "robot": (Kind.TEXT, [each.robot for each in record.events]),
            "task": (Kind.TEXT, [each.task for each in record.events]),
            "state": (Kind.TEXT, [each.state for each in record.events]),
            "text": _texts(each.text for each in record.events),
        },
    }


def pose_table(poses: Iterable[Tuple[str, float, float, float, float]], start: float) -> Table:
    """Give the table of where robots were.

    Args:
        poses: robot, time [s], x [m], y [m] and yaw [rad] of each, in the frame ``map``.
        start: of the mission [s].
    """
    names: List[str] = []
    columns: Tuple[List[float], ...] = ([], [], [], [])
    for robot, *values in poses:
        names.append(robot)
        for column, value in zip(columns, values):
            column.append(value)
    times, x, y, yaw = columns
    return {
        "robot": (Kind.TEXT, names),
        "time_s": _times(times, start),
        "x_m": (Kind.NUMBER, x),
        "y_m": (Kind.NUMBER, y),
        "yaw_rad": (Kind.NUMBER, yaw),
    }


def _texts(texts: Iterable[str]) -> Column:
    return Kind.TEXT, list(texts)


def _times(times: Iterable[float], start: float) -> Column:
    return Kind.NUMBER, [seconds(time, start) for time in times]


def _interval(intervals: Sequence[Tuple[float, float]], start: float) -> Dict[str, Column]:
    return {
        "from_s": _times((begin for begin, _ in intervals), start),
        "to_s": _times((end for _, end in intervals), start),
    }


def _evidence(incident: Incident, start: float) -> List[Dict[str, Any]]:
    return [
        {"topic": each.topic, "time_s": seconds(each.stamp, start), "index": each.index} for each in incident.evidence
    ]
