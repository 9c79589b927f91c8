"""The closed sets of supervision: what state a robot, task, allocation or incident can be in."""

from __future__ import annotations

from enum import Enum
from typing import Optional

__all__ = ["Outcome", "Progress", "RobotState", "Severity", "TaskState"]


class RobotState(Enum):
    """What the supervisor knows of a robot from the messages about it."""

    IDLE = "idle"
    BUSY = "busy"
    OFFLINE = "offline"


class TaskState(Enum):
    """How far a task has come."""

    WAITING = "waiting"
    ALLOCATED = "allocated"
    EXECUTING = "executing"
    DONE = "done"
    FAILED = "failed"
    WITHDRAWN = "withdrawn"


class Outcome(Enum):
    """How one robot's time with one task ended."""

    DONE = "done"
    FAILED = "failed"
    YIELDED = "yielded"
    GAVE_UP = "gave_up"
    LOST = "lost"
    PREEMPTED = "preempted"
    OPEN = "open"


class Progress(Enum):
    """What a behaviour says of the task it carries out, or an operator of a task.

    Members stand in the order of the constants of ``rqt_mrta_py/TaskProgress``, which count from 0.
    """

    RUNNING = "running"
    DONE = "done"
    FAILED = "failed"
    UNREACHABLE = "unreachable"
    APPEARED = "appeared"
    WITHDRAWN = "withdrawn"
    REASSIGNED = "reassigned"

    @property
    def code(self) -> int:
        """Give the constant of ``rqt_mrta_py/TaskProgress``."""
        return _PROGRESS_BY_CODE.index(self)

    @classmethod
    def of_code(cls, code: int) -> Optional[Progress]:
        """Read a constant of ``rqt_mrta_py/TaskProgress``; None for a number that nobody has defined."""
        return _PROGRESS_BY_CODE[code] if 0 <= code < len(_PROGRESS_BY_CODE) else None


# A robot of a large team asks for each of its fellows at the start; to list the members takes longer than all else.
_PROGRESS_BY_CODE = tuple(Progress)


class Severity(Enum):
    """How much an incident matters; ordered by ``rank``."""

    INFO = "info"
    WARNING = "warning"
    ERROR = "error"

    @property
    def rank(self) -> int:
        """Give 0 for info, 1 for warning, 2 for error."""
        return list(Severity).index(self)
