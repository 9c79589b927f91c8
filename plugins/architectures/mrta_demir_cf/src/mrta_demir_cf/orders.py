"""What the robot's host tells of tasks: how its own went, what others did, what operators want."""

from __future__ import annotations

import math
from typing import Optional

from mrta_demir_cf.message_kinds import CancelReason, Kind
from mrta_demir_cf.mind import Mind
from mrta_demir_cf.reachability import close
from mrta_demir_cf.task_model import TaskModel
from mrta_demir_cf.task_states import TaskBelief, TaskEvent
from rqt_mrta_py.hooks import TaskReport
from rqt_mrta_py.model import Progress

__all__ = ["heed"]


def heed(mind: Mind, report: TaskReport) -> None:
    """Take in a report.

    * DONE: rows 18 and 31. What this robot has done while it believed something else of the task is told as well.
    * FAILED, UNREACHABLE: rows 24 and 32; nobody can do it, as far as is known.
    * WITHDRAWN: as if it were completed, silently.
    * APPEARED: row 37 or 34; a task that was completed and appears anew is a new one with the same id.
    * REASSIGNED: rows 5, 15 and 4, before all rules of cost; who gets a task so keeps it until it ends or is recalled.

    Args:
        mind: the robot's.
        report: from the host.
    """
    own = report.robot == mind.robot_id
    if report.progress is Progress.APPEARED:
        _appear(mind, report)
        return
    if report.progress is Progress.RUNNING:
        return
    model = mind.task(report.task)
    if report.progress is Progress.DONE:
        _end(mind, model, own)
    elif report.progress in (Progress.FAILED, Progress.UNREACHABLE):
        close(mind, model, own=own)
    elif report.progress is Progress.WITHDRAWN:
        mind.change(model, TaskEvent.COMPLETION_TOLD)
    elif report.progress is Progress.REASSIGNED:
        if own:
            _take(mind, model)
        else:
            _leave(mind, model, report.robot)


def _end(mind: Mind, model: TaskModel, own: bool) -> None:
    executed = own and model.belief is TaskBelief.EXECUTING
    row = mind.change(model, TaskEvent.REACHED if executed else TaskEvent.COMPLETION_TOLD)
    if own and row is not None:
        if mind.told.handling:
            mind.speaker.completed = model.id
        mind.speaker.say(Kind.COMPLETION, model.id)


def _appear(mind: Mind, report: TaskReport) -> None:
    known = mind.tasks.get(report.task)
    if known is not None and known.belief is TaskBelief.COMPLETED:
        del mind.tasks[report.task]
    definition = report.definition or mind.definitions.get(report.task)
    model = mind.task(report.task) if definition is None else mind.know(definition)
    model.born = mind.now
    if mind.speaker.completed == model.id:
        mind.speaker.completed = ""
    if model.belief is TaskBelief.UNACHIEVABLE:
        mind.change(model, TaskEvent.TOLD_NEW)
        model.reachable = mind.now
    mind.stirred = True


def _take(mind: Mind, model: TaskModel) -> None:
    """Take what an operator gives to this robot."""
    if model.id not in mind.definitions or model.belief is TaskBelief.COMPLETED:
        return
    if model.belief is TaskBelief.UNACHIEVABLE:
        mind.change(model, TaskEvent.TOLD_NEW)
        model.reachable = mind.now
    if mind.mine not in (None, model.id):
        mind.cancel(mind.tasks[str(mind.mine)], TaskEvent.RECALLED, CancelReason.OPERATOR)
    if model.belief in (TaskBelief.ASSIGNED, TaskBelief.EXECUTING):
        model.ordered = True
        return
    mind.change(model, TaskEvent.AWARD_TAKEN)
    cost = mind.cost(model.id)
    model.claim(mind.robot_id, mind.told.unknown_cost if cost is None else cost, mind.now, awarded=True, ordered=True)


def _leave(mind: Mind, model: TaskModel, robot: Optional[str]) -> None:
    """Leave what an operator gives to another robot, or to nobody in particular."""
    if model.is_held:
        mind.cancel(model, TaskEvent.RECALLED, CancelReason.OPERATOR)
    if robot is not None and mind.change(model, TaskEvent.AWARD_TO_OTHER) is not None:
        model.claim(robot, math.inf, mind.now, awarded=True, ordered=True)
