"""Tasks that cannot be reached: how they are closed, and when they are thought of again."""

from __future__ import annotations

from mrta_demir_cf.message_kinds import Kind
from mrta_demir_cf.mind import Mind
from mrta_demir_cf.task_model import TaskModel
from mrta_demir_cf.task_states import TaskBelief, TaskEvent

__all__ = ["close", "note_closed", "reopen"]


def close(mind: Mind, model: TaskModel, *, own: bool) -> None:
    """Note that a task cannot be carried out (rows 24 and 32).

    Args:
        mind: the robot's.
        model: of the task.
        own: whether this robot found so; it then tells all.
    """
    executed = own and model.belief in (TaskBelief.ASSIGNED, TaskBelief.EXECUTING)
    known = model.belief is TaskBelief.UNACHIEVABLE
    if mind.change(model, TaskEvent.BLOCKED if executed else TaskEvent.UNACHIEVABLE_TOLD) is None or known:
        return
    note_closed(mind, model, mind.now)
    if own:
        mind.speaker.say(Kind.UNACHIEVABILITY, model.id, map_stamp=mind.now)


def note_closed(mind: Mind, model: TaskModel, stamp: float) -> None:
    """Remember when a task was found to be out of reach, and what this robot's own map says of it.

    Args:
        mind: the robot's.
        model: of the task.
        stamp: when it was found so [s].
    """
    model.unreachable = max(model.unreachable, stamp)
    model.failures += 1
    model.had_way = mind.finds_way(model.id)


def reopen(mind: Mind) -> None:
    """Think again of tasks that could not be reached (row 34), and tell all of those that seem to be now.

    A task is thought of again at once when this robot's map shows a way and did not when the task was closed, and
    otherwise after the time to retry, doubled with each failure; never as long as its map shows none.
    """
    for model in mind.tasks.values():
        if model.belief is not TaskBelief.UNACHIEVABLE or not mind.finds_way(model.id):
            continue
        wait = mind.told.retry * 2.0 ** (model.failures - 1)
        if model.had_way and not 0.0 < wait <= mind.now - model.since:
            continue
        mind.change(model, TaskEvent.TOLD_NEW)
        model.reachable = mind.now
        mind.speaker.say(Kind.NEW_TASK, model.id, place=model.place, map_stamp=mind.now)
