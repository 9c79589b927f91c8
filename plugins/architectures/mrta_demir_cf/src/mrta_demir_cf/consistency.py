"""System consistency: a robot whose message contradicts what this one knows is set right.

At most one correction goes to one robot about one task in a heartbeat, and a loss of it is made good by the next
message that contradicts, never by blind repetition. Without contingency handling nobody is set right.
"""

from __future__ import annotations

import math
from typing import Dict, Tuple

from mrta_demir_cf.message_kinds import Kind, WarnedState
from mrta_demir_cf.mind import Mind
from mrta_demir_cf.task_model import TaskModel
from mrta_demir_cf.task_states import TaskBelief

__all__ = ["Consistency"]

_STATES: Dict[TaskBelief, WarnedState] = {
    TaskBelief.COMPLETED: WarnedState.COMPLETED,
    TaskBelief.UNACHIEVABLE: WarnedState.UNACHIEVABLE,
    TaskBelief.REQUESTED: WarnedState.REQUESTED,
    TaskBelief.REQUESTED_OTHER: WarnedState.REQUESTED,
    TaskBelief.ASSIGNED: WarnedState.EXECUTING,
    TaskBelief.EXECUTING: WarnedState.EXECUTING,
    TaskBelief.EXECUTING_OTHER: WarnedState.EXECUTING,
}


class Consistency:
    """Sets other robots right.

    Args:
        mind: whose beliefs it speaks for.
    """

    def __init__(self, mind: Mind) -> None:
        self._mind = mind
        self._corrected: Dict[Tuple[str, str], float] = {}

    def warn(self, robot: str, model: TaskModel) -> None:
        """Tell a robot what this one believes of a task; nothing if that is nothing.

        Args:
            robot: id of who is mistaken.
            model: of the task; a task that nobody holds and that is not over is no contradiction.
        """
        state = _STATES.get(model.belief)
        if state is None or not self._may_correct(robot, model.id):
            return
        mind = self._mind
        claimed = model.is_claimed or model.is_held
        mind.speaker.say(
            Kind.WARNING,
            model.id,
            recipient=robot,
            state=state.value,
            holder=model.holder if claimed else "",
            cost=model.cost if claimed and math.isfinite(model.cost) else 0.0,
            map_stamp=max(model.unreachable if model.belief is TaskBelief.UNACHIEVABLE else model.since, 0.0),
        )

    def answer(self, robot: str, model: TaskModel) -> None:
        """Tell all, because of a robot that does not know it, that this one executes a task."""
        if self._may_correct(robot, model.id):
            self._mind.say_execution(model)

    def refute(self, robot: str, model: TaskModel) -> None:
        """Tell all, because of a robot that is mistaken, that a task can be reached."""
        if self._may_correct(robot, model.id):
            mind = self._mind
            mind.speaker.say(Kind.NEW_TASK, model.id, place=model.place, map_stamp=max(model.reachable, 0.0))

    def _may_correct(self, robot: str, task: str) -> bool:
        """Tell whether a correction is due, and if so count it as given."""
        told, now = self._mind.told, self._mind.now
        if not told.handling:
            return False
        last = self._corrected.get((robot, task))
        if last is not None and now - last < told.heartbeat:
            return False
        self._corrected[robot, task] = now
        return True
