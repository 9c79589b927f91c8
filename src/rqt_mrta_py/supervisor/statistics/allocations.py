"""Allocations: how many, how they ended, how long they took to come."""

from __future__ import annotations

from typing import Dict, Optional

from rqt_mrta_py.model import MissionRecord, Outcome

__all__ = ["allocations_by_outcome", "reallocations", "time_to_first_allocation"]


def allocations_by_outcome(record: MissionRecord) -> Dict[str, int]:
    """Count allocations by how they ended, outcomes that do not occur included.

    Args:
        record: of a finished mission.
    """
    counts = {outcome.value: 0 for outcome in Outcome}
    for allocation in record.allocations:
        counts[allocation.outcome.value] += 1
    return counts


def reallocations(record: MissionRecord) -> int:
    """Count the allocations that gave a task to another robot than the allocation of that task before.

    Args:
        record: of a finished mission.
    """
    holder: Dict[str, str] = {}
    count = 0
    for allocation in record.allocations:
        count += holder.get(allocation.task, allocation.robot) != allocation.robot
        holder[allocation.task] = allocation.robot
    return count


def time_to_first_allocation(record: MissionRecord) -> Dict[str, Optional[float]]:
    """Say how long each task first waited for a robot.

    Args:
        record: of a finished mission.

    Returns:
        By task, from when it was first known to its first allocation [s]; None if it was never allocated.
    """
    first: Dict[str, float] = {}
    for allocation in record.allocations:
        first.setdefault(allocation.task, allocation.start)
    known = {task.id: task.history[0].start for task in record.tasks if task.history}
    return {task: first[task] - start if task in first else None for task, start in known.items()}
