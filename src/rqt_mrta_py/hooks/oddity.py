"""Facts that rules live on besides states: what messages say that does not fit, and what falls due unsaid."""

from __future__ import annotations

from typing import NamedTuple

from rqt_mrta_py.model import Evidence, TaskState

__all__ = [
    "AllocationExpired",
    "TaskApplicability",
    "TaskClaimed",
    "TaskEndTold",
    "UnknownRobotNamed",
    "UnknownTaskNamed",
]


class AllocationExpired(NamedTuple):
    """For so long nobody has said that a robot holds a task that it does no more; how that ended shows only later.

    An ``AllocationEnded`` dated back to this time [s] follows, when the robot is heard again or counts as lost.
    """

    time: float
    robot: str
    task: str


class TaskApplicability(NamedTuple):
    """A robot says that a task is, or is no longer, one that it can carry out now.

    Attributes:
        time: when [s].
        robot: its id; empty: nobody can, or everybody might.
        task: its id.
        applicable: whether it can.
    """

    time: float
    robot: str
    task: str
    applicable: bool


class TaskClaimed(NamedTuple):
    """A message says that a robot carries out a task that has ended.

    Attributes:
        time: when [s].
        robot: normalised id of who is said to; empty if the message names nobody.
        task: its id.
        state: DONE, FAILED or WITHDRAWN, as the task stands.
        message: that says so.
    """

    time: float
    robot: str
    task: str
    state: TaskState
    message: Evidence


class TaskEndTold(NamedTuple):
    """A message says that a task is over, be it news or not.

    Attributes:
        time: when [s].
        robot: normalised id of who is said to have ended it; empty if nobody is named.
        task: its id.
        before: the task's state so far.
        told: DONE, FAILED or WITHDRAWN.
        message: that says so.
    """

    time: float
    robot: str
    task: str
    before: TaskState
    told: TaskState
    message: Evidence


class UnknownRobotNamed(NamedTuple):
    """A monitored message names a robot that is not of the team; only where the mission lists its robots.

    Attributes:
        time: when [s].
        robot: the id, normalised.
        message: that names it.
    """

    time: float
    robot: str
    message: Evidence


class UnknownTaskNamed(NamedTuple):
    """A message says who carries out a task, or that it is over, which is none of the mission's.

    Only where the mission lists its tasks; one that comes up on the way is no longer unknown.

    Attributes:
        time: when [s].
        task: the id, normalised.
        robot: normalised id of who is named with it; empty if nobody is.
        message: that names it.
    """

    time: float
    task: str
    robot: str
    message: Evidence
