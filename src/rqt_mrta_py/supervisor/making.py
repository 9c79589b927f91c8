"""Values of a record, made by the thousand for every picture.

The constructor of a frozen dataclass sets each attribute by a call of its own. These functions give the same values in
about half the time; what they leave out is what ``__post_init__`` would do, of which these classes have none.
"""

from __future__ import annotations

from typing import Optional, Tuple, Type, TypeVar

from rqt_mrta_py.model import (
    Allocation,
    Outcome,
    RobotInterval,
    RobotRecord,
    RobotState,
    TaskInterval,
    TaskRecord,
    TaskState,
)

__all__ = ["allocation", "interval", "robot_record", "task_record"]

_State = TypeVar("_State", RobotState, TaskState)
_Interval = TypeVar("_Interval", RobotInterval, TaskInterval)

_new = object.__new__


def interval(kind: Type[_Interval], state: _State, start: float, end: float) -> _Interval:
    """Make an interval of a kind; times in seconds."""
    made = _new(kind)
    values = made.__dict__
    values["state"] = state
    values["start"] = start
    values["end"] = end
    return made


def robot_record(robot_id: str, states: Tuple[RobotInterval, ...], last_heard: Optional[float]) -> RobotRecord:
    """Make a RobotRecord."""
    made = _new(RobotRecord)
    values = made.__dict__
    values["id"] = robot_id
    values["states"] = states
    values["last_heard"] = last_heard
    return made


def task_record(task_id: str, history: Tuple[TaskInterval, ...]) -> TaskRecord:
    """Make a TaskRecord."""
    made = _new(TaskRecord)
    values = made.__dict__
    values["id"] = task_id
    values["history"] = history
    return made


def allocation(task: str, robot: str, start: float, end: float, outcome: Outcome) -> Allocation:
    """Make an Allocation; times in seconds."""
    made = _new(Allocation)
    values = made.__dict__
    values["task"] = task
    values["robot"] = robot
    values["start"] = start
    values["end"] = end
    values["outcome"] = outcome
    return made
