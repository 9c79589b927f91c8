"""Makespan: how long all tasks took together."""

from __future__ import annotations

from typing import Optional

from rqt_mrta_py.model import MissionRecord, TaskState

__all__ = ["makespan"]

_OVER = frozenset({TaskState.DONE, TaskState.FAILED, TaskState.WITHDRAWN})


def makespan(record: MissionRecord) -> Optional[float]:
    """Say how long it took from the start of the mission until its last task was done [s].

    Args:
        record: of a finished mission.

    Returns:
        The time; None while a task is open, or if none was done.
    """
    done = [task.history[-1].start for task in record.tasks if task.state is TaskState.DONE]
    if record.start is None or not done or any(task.state not in _OVER for task in record.tasks):
        return None
    return max(done) - record.start
