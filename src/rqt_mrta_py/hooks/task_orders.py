"""What operators say of tasks: the orders that a scenario gives in simulation and people give to a live team."""

from __future__ import annotations

from typing import Optional

from rqt_mrta_py.config.tasks.task_text import dump_task
from rqt_mrta_py.hooks.stream import Outgoing
from rqt_mrta_py.model import Progress, Task

__all__ = ["task_order"]


def task_order(
    progress: Progress, task_id: str, now: float, *, robot: str = "", detail: str = "", task: Optional[Task] = None
) -> Outgoing:
    """Say on ``/mrta/task_progress`` what an operator wants of a task.

    Args:
        progress: APPEARED, WITHDRAWN or REASSIGNED.
        task_id: of the task.
        now: when [s].
        robot: id of the robot that it shall go to; empty unless it is reassigned.
        detail: why, in a few words.
        task: what the task is, where it appears; None if everybody knows it.
    """
    fields = {
        "header": {"stamp": now},
        "task_id": task_id,
        "robot_id": robot,
        "progress": progress.code,
        "detail": detail,
        "task_yaml": "" if task is None else dump_task(task),
    }
    return Outgoing("/mrta/task_progress", "rqt_mrta_py/TaskProgress", fields)
