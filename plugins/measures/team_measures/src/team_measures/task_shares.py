"""How the time that robots spent on tasks is spread over the tasks."""

from __future__ import annotations

from typing import Dict, Optional

from rqt_mrta_py.model import MissionRecord

__all__ = ["task_shares"]


def task_shares(record: MissionRecord) -> Optional[Dict[str, float]]:
    """Say which part of all the time that tasks were allocated each task had.

    Where ``coverage`` says how long a task was held, this says what robots did with their time: under an architecture
    that lets the fastest task win again and again, its share comes close to 1.

    Args:
        record: of a finished mission.

    Returns:
        By task, in the record's order, from 0 to 1; together 1. A task that two robots held counts twice meanwhile.
        None where no task was allocated for any time.
    """
    spent = {task.id: 0.0 for task in record.tasks}
    for allocation in record.allocations:
        spent[allocation.task] = spent.get(allocation.task, 0.0) + max(allocation.end - allocation.start, 0.0)
    total = sum(spent.values())
    return {task: time / total for task, time in spent.items()} if total > 0.0 else None
