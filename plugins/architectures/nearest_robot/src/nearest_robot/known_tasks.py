"""What one robot knows of its tasks from what is reported: which are over, out of reach, ordered by an operator."""

from __future__ import annotations

import math
from typing import Dict, Iterable, Set

from rqt_mrta_py.hooks import TaskReport
from rqt_mrta_py.model import Progress, Task

__all__ = ["KnownTasks"]

_ENDS = (Progress.DONE, Progress.FAILED, Progress.WITHDRAWN)


class KnownTasks:
    """The tasks that a robot may carry out, and how they stand.

    Attributes:
        tasks: by id, in the mission's order; those that appeared come last.
        ended: ids of those that are over.
        ordered: the task that an operator gave to this robot; empty if none.

    Args:
        robot_id: whose knowledge it is.
        tasks: that it may carry out, now or later.
        retry: for how long a task that was unreachable is left alone [s].
    """

    def __init__(self, robot_id: str, tasks: Iterable[Task], retry: float) -> None:
        self.tasks: Dict[str, Task] = {task.id: task for task in tasks}
        self.ended: Set[str] = set()
        self.ordered = ""
        self._robot_id = robot_id
        self._retry = retry
        self._unreachable_until: Dict[str, float] = {}

    def note(self, report: TaskReport, now: float) -> None:
        """Take in a report at a time [s]."""
        task = report.task
        if report.progress in _ENDS:
            self.ended.add(task)
            self._revoke(task)
        elif report.progress is Progress.UNREACHABLE:
            self._unreachable_until[task] = now + self._retry
        elif report.progress is Progress.APPEARED:
            self.ended.discard(task)
            self._unreachable_until.pop(task, None)
            if report.definition is not None:
                self.tasks[task] = report.definition
        elif report.progress is Progress.REASSIGNED:
            self._revoke(task)
            if report.robot == self._robot_id:
                self.ordered = task
                self._unreachable_until.pop(task, None)

    def is_open(self, task: str, now: float) -> bool:
        """Tell whether a task is neither over nor to be left alone, at a time [s]."""
        return task not in self.ended and now >= self._unreachable_until.get(task, -math.inf)

    def _revoke(self, task: str) -> None:
        if self.ordered == task:
            self.ordered = ""
