"""Rule: a message names a task that is none of the mission's."""

from __future__ import annotations

from rqt_mrta_py.hooks import Fact, IncidentBoard, TaskStateChanged, UnknownTaskNamed
from rqt_mrta_py.supervisor.rules.unknown_names import Named, UnknownNames

__all__ = ["UnknownTask"]


class UnknownTask(UnknownNames):
    """Puts up a warning on each task that is named and is none of the mission's.

    Fires: at once, when a message on a monitored topic of busy robots, allocated, completed or failed tasks, or on
    ``/mrta/task_progress``, names a task that the mission does not list and that has not come up. It lasts from the
    first such message to the last one, which is that after which there is none for twice ``pace.handover``, or until
    the task comes up. Of more than 50 such ids the first 50 are told.

    Does not fire: where the mission lists no tasks; for tasks that an incoming message or an operator lets come up; for
    ids in the names of topics of idle robots.

    Args:
        setup: see ``UnknownNames``.
    """

    causes = (
        "A task id is misspelt in a robot's parameters, a robot runs with another mission's files, or the message that "
        "the task has come up was lost or is still under way."
    )

    def notice(self, fact: Fact, board: IncidentBoard) -> None:
        """Follow which unknown tasks are named."""
        if isinstance(fact, UnknownTaskNamed):
            known = [task.id for task in (*self.mission.tasks, *self.mission.later_tasks)]
            who = fact.robot or fact.message.topic
            robots = [fact.robot] if fact.robot else []
            self.name(fact, Named(fact.task, f"{who} names task", known, robots, [fact.task]), board)
        elif isinstance(fact, TaskStateChanged):
            self.forget(fact.task, fact.time, board)
