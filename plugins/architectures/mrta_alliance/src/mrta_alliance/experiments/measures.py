"""Numbers from the record of a mission."""

from __future__ import annotations

from typing import Dict, FrozenSet, List, Optional, Sequence

from rqt_mrta_py.model import Allocation, MissionRecord, TaskState

__all__ = ["done_at", "done_tasks", "double_holdings", "holder_at", "length", "takeover_time"]

_LEAST = 1e-6
"""What holdings must overlap for to count as double: a task may be handed on within one moment [s]."""


def length(record: MissionRecord) -> float:
    """Give how long a mission lasted [s]."""
    return 0.0 if record.start is None or record.end is None else record.end - record.start


def done_at(record: MissionRecord) -> Dict[str, float]:
    """Give when each task that is done was done, since the start of the mission [s], by task."""
    times: Dict[str, float] = {}
    for task in record.tasks:
        if task.state is TaskState.DONE:
            times[task.id] = task.history[-1].start - (record.start or 0.0)
    return times


def done_tasks(record: MissionRecord) -> FrozenSet[str]:
    """List the tasks that are done."""
    return frozenset(done_at(record))


def double_holdings(record: MissionRecord) -> List[float]:
    """Give how long each pair of overlapping allocations of one task overlaps [s], by start of the later one.

    The supervisor takes an allocation to last until its robot was silent on it for the topic's timeout, unless the
    architecture's own signs end it before.
    """
    overlaps: List[float] = []
    by_task: Dict[str, List[Allocation]] = {}
    for later in sorted(record.allocations, key=lambda each: (each.start, each.robot, each.task)):
        for earlier in by_task.setdefault(later.task, []):
            overlap = min(earlier.end, later.end) - later.start
            if earlier.robot != later.robot and overlap > _LEAST:
                overlaps.append(overlap)
        by_task[later.task].append(later)
    return overlaps


def holder_at(allocations: Sequence[Allocation], task: str, moment: float) -> Optional[Allocation]:
    """Find the allocation by which a task is held at a moment on the stream's clock [s]; the earliest if several."""
    held = [each for each in allocations if each.task == task and each.start <= moment < each.end]
    return min(held, key=lambda each: (each.start, each.robot), default=None)


def takeover_time(record: MissionRecord, task: str, robot: str, moment: float) -> Optional[float]:
    """Give how long after the loss of its robot a task was taken by another.

    Args:
        record: of the mission.
        task: that was held.
        robot: that was lost.
        moment: of the loss, since the start of the mission [s].

    Returns:
        From the loss to the first announcement of another robot [s]; None if there was none.
    """
    lost = (record.start or 0.0) + moment
    starts = [
        each.start for each in record.allocations if each.task == task and each.robot != robot and each.start > lost
    ]
    return min(starts) - lost if starts else None
