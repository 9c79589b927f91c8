"""One task's state, and which changes between states there are."""

from __future__ import annotations

import copy
import math
from typing import FrozenSet, Iterable, Mapping, Optional

from rqt_mrta_py.model import RobotState, TaskInterval, TaskRecord, TaskState
from rqt_mrta_py.supervisor.timeline import Timeline

__all__ = ["FINAL", "TRANSITIONS", "TaskWatch", "state_when_held"]

_ENDS = frozenset({TaskState.DONE, TaskState.FAILED, TaskState.WITHDRAWN})

TRANSITIONS: Mapping[TaskState, FrozenSet[TaskState]] = {
    TaskState.WAITING: _ENDS | {TaskState.ALLOCATED, TaskState.EXECUTING},
    TaskState.ALLOCATED: _ENDS | {TaskState.WAITING, TaskState.EXECUTING},
    TaskState.EXECUTING: _ENDS | {TaskState.WAITING, TaskState.ALLOCATED},
    TaskState.DONE: frozenset(),
    TaskState.FAILED: frozenset(),
    TaskState.WITHDRAWN: frozenset(),
}
"""From each state to those that may follow; a task that appears anew begins again as WAITING from any final state."""

FINAL = frozenset(state for state, successors in TRANSITIONS.items() if not successors)
"""States that stay, unless the task appears anew."""


def state_when_held(holders: Iterable[RobotState], anonymously: bool) -> TaskState:
    """Derive the state of a task that has not ended.

    Args:
        holders: the states of the robots that hold it.
        anonymously: True while a message that names no robot says that it is allocated.

    Returns:
        EXECUTING while a robot that holds it is busy, ALLOCATED while somebody holds it, else WAITING.
    """
    state = TaskState.ALLOCATED if anonymously else TaskState.WAITING
    for holder in holders:
        if holder is RobotState.BUSY:
            return TaskState.EXECUTING
        state = TaskState.ALLOCATED
    return state


class TaskWatch:
    """One task's state.

    Args:
        task_id: its id.
        order: its place in the mission.
        start: when it is first known [s].
        robots: how many robots it needs; None if unknown.
    """

    def __init__(self, task_id: str, order: int, start: float, robots: Optional[int] = None) -> None:
        self.id = task_id
        self.order = order
        self.robots = robots
        self.timeline: Timeline[TaskState, TaskInterval] = Timeline(TaskInterval, TaskState.WAITING, start)
        self.anonymous_until = -math.inf

    @property
    def state(self) -> TaskState:
        """Give the present state."""
        return self.timeline.state

    @property
    def ended(self) -> bool:
        """Whether the task is done, failed or withdrawn."""
        return self.state in FINAL

    def allows(self, state: TaskState) -> bool:
        """Tell whether a state may follow the present one."""
        return state in TRANSITIONS[self.state]

    def record(self, end: float) -> TaskRecord:
        """Give the history up to a time [s]."""
        return TaskRecord(self.id, self.timeline.intervals(end))

    def fork(self) -> TaskWatch:
        """Copy this watch, so that the copy can go on by itself."""
        twin = copy.copy(self)
        twin.timeline = self.timeline.fork()
        return twin
