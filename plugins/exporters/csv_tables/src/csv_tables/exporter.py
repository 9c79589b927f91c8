"""The tables of one mission; times count from its stream's start."""

from __future__ import annotations

from typing import Dict, List, Mapping, Sequence, Tuple

from csv_tables.poses import POSES, PoseTrack
from csv_tables.table import Cell, csv_bytes, seconds
from rqt_mrta_py.hooks import ExporterSetup, Heard, Subscription
from rqt_mrta_py.model import MissionRecord

__all__ = ["CsvExporter"]

_Table = Tuple[Sequence[str], List[Sequence[Cell]]]

# Decimals of positions and angles: a micrometre is far below what any robot knows.
_DECIMALS = 6


class CsvExporter:
    """Writes robots, tasks, allocations, incidents, events and poses as a table each.

    Args:
        setup: not needed.
    """

    def __init__(self, setup: ExporterSetup) -> None:
        self._poses = PoseTrack()

    def subscriptions(self) -> Sequence[Subscription]:
        """Say what to hear: the robots' poses."""
        return (POSES,)

    def hear(self, heard: Heard) -> None:
        """Take in one pose."""
        self._poses.hear(heard)

    def export(self, record: MissionRecord) -> Mapping[str, bytes]:
        """Give the tables by file name."""
        start = record.start or 0.0
        tables: Dict[str, _Table] = {
            "robots.csv": _robots(record, start),
            "tasks.csv": _tasks(record, start),
            "allocations.csv": _allocations(record, start),
            "incidents.csv": _incidents(record, start),
            "events.csv": _events(record, start),
            "poses.csv": self._pose_table(start),
        }
        return {name: csv_bytes(head, rows) for name, (head, rows) in tables.items()}

    def _pose_table(self, start: float) -> _Table:
        head = ("robot", "time [s]", "x [m]", "y [m]", "yaw [rad]")
        return head, [
            (robot, seconds(time, start), *(round(value, _DECIMALS) for value in pose))
            for robot, time, *pose in self._poses
        ]


def _robots(record: MissionRecord, start: float) -> _Table:
    return ("robot", "state", "from [s]", "to [s]"), [
        (robot.id, each.state.value, seconds(each.start, start), seconds(each.end, start))
        for robot in record.robots
        for each in robot.states
    ]


def _tasks(record: MissionRecord, start: float) -> _Table:
    return ("task", "state", "from [s]", "to [s]"), [
        (task.id, each.state.value, seconds(each.start, start), seconds(each.end, start))
        for task in record.tasks
        for each in task.history
    ]


def _allocations(record: MissionRecord, start: float) -> _Table:
    return ("task", "robot", "from [s]", "to [s]", "outcome"), [
        (each.task, each.robot, seconds(each.start, start), seconds(each.end, start), each.outcome.value)
        for each in record.allocations
    ]


def _incidents(record: MissionRecord, start: float) -> _Table:
    return ("rule", "severity", "from [s]", "to [s]", "robots", "tasks", "text", "causes"), [
        (
            each.rule,
            each.severity.value,
            seconds(each.start, start),
            seconds(each.end, start),
            " ".join(each.robots),
            " ".join(each.tasks),
            each.text,
            each.causes,
        )
        for each in record.incidents
    ]


def _events(record: MissionRecord, start: float) -> _Table:
    return ("time [s]", "kind", "severity", "robot", "task", "state", "text"), [
        (seconds(each.time, start), each.kind, each.severity.value, each.robot, each.task, each.state, each.text)
        for each in record.events
    ]
