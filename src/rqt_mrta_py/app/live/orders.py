"""What operators may order of a team, checked before the team hears of it."""

from __future__ import annotations

from typing import Collection, Mapping

from rqt_mrta_py.config.tasks.task_text import read_task
from rqt_mrta_py.errors import UsageError
from rqt_mrta_py.hooks import Outgoing, task_order
from rqt_mrta_py.model import Mission, Progress, normalise_id
from rqt_mrta_py.wording import accepted

__all__ = ["reassigned", "submitted", "withdrawn"]


def submitted(fields: Mapping[str, str], mission: Mission, now: float) -> Outgoing:
    """Tell the team of a task.

    Args:
        fields: of a request of SubmitTask.
        mission: lists the tasks that everybody knows.
        now: the time [s].

    Raises:
        UsageError: neither a task nor the id of one is given, or the two disagree, or nobody knows the id.
        ConfigError: the task's text is not acceptable.
    """
    task_id, text = normalise_id(fields["task_id"]), fields["task_yaml"]
    if text.strip():
        task = read_task(text, "task_yaml")
        if task_id not in ("", task.id):
            raise UsageError(f"task_yaml: defines {task.id!r}, but task_id is {task_id!r}; leave one of them out")
        return task_order(Progress.APPEARED, task.id, now, detail="there is a new task", task=task)
    _check("task_id", task_id, mission.task_ids)
    return task_order(Progress.APPEARED, task_id, now, detail="there is a new task")


def withdrawn(fields: Mapping[str, str], tasks: Collection[str], now: float) -> Outgoing:
    """Take a task back.

    Args:
        fields: of a request of WithdrawTask.
        tasks: ids of those that are known; if there are none, any is taken back.
        now: the time [s].

    Raises:
        UsageError: nobody knows the task.
    """
    task_id = normalise_id(fields["task_id"])
    _check("task_id", task_id, tasks)
    detail = fields["reason"] or "an operator takes it back"
    return task_order(Progress.WITHDRAWN, task_id, now, detail=detail)


def reassigned(fields: Mapping[str, str], tasks: Collection[str], robots: Collection[str], now: float) -> Outgoing:
    """Give a task to another robot.

    Args:
        fields: of a request of ReassignTask.
        tasks: ids of those that are known; if there are none, any will do.
        robots: likewise.
        now: the time [s].

    Raises:
        UsageError: nobody knows the task or the robot.
    """
    task_id, robot = normalise_id(fields["task_id"]), normalise_id(fields["robot_id"])
    _check("task_id", task_id, tasks)
    _check("robot_id", robot, robots)
    detail = fields["reason"] or "an operator gives it to another robot"
    return task_order(Progress.REASSIGNED, task_id, now, robot=robot, detail=detail)


def _check(name: str, value: str, known: Collection[str]) -> None:
    if not value:
        raise UsageError(f"{name}: is empty; {accepted(value, known)}" if known else f"{name}: is empty")
    if known and value not in known:
        raise UsageError(f"{name}: nobody knows {value!r}; {accepted(value, known)}")
