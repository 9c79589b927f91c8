"""Rule: two robots hold one task that needs one."""

from __future__ import annotations

from typing import Dict, Sequence, Tuple

from rqt_mrta_py.hooks import IncidentBoard, RuleSetup
from rqt_mrta_py.model import Severity, TaskType
from rqt_mrta_py.supervisor.rules.overlap import Hold, Overlap

__all__ = ["TaskHeldByTwoRobots"]


class TaskHeldByTwoRobots(Overlap):
    """Puts up a warning from the moment on at which the second robot took a task that another still held.

    Fires: under a single-robot (SR) architecture, for a task whose ``robots`` is 1, when two robots hold it together
    from a time s on and still do at the later of s and (start of the older one + ``yielding``), plus ``handover``.
    At that time it is put up; it lasts from s until one robot at most holds the task.

    Does not fire: under MR architectures and those of unknown type; for tasks that need several robots; for shorter
    overlaps, as when a robot takes over and the other's last announcements still count; for an allocation that nobody
    speaks of any more, which ends when it expires.

    Args:
        setup: ``pace.yielding`` (ALLIANCE: psi) and ``pace.handover`` say for how long two may hold it.
    """

    causes = (
        "The two do not hear each other: messages are lost, the radio is parted, a topic or namespace is misspelt; or "
        "one takes the other for stopped because its timeout is shorter than the period of announcements."
    )

    def __init__(self, setup: RuleSetup) -> None:
        super().__init__(setup, setup.mission.architecture.taxonomy.tasks is TaskType.SINGLE_ROBOT)
        self._shared = {task.id for task in (*setup.mission.tasks, *setup.mission.later_tasks) if task.robots > 1}

    def side(self, robot: str, task: str) -> Tuple[str, str]:
        """Give the task, and by whom it is held."""
        return task, robot

    def deadline(self, key: str, since: float, holds: Dict[str, Hold]) -> float:
        """Say until when one of them must have yielded [s]."""
        oldest = min(start for start, _ in holds.values())
        return max(since, oldest + self.pace.yielding) + self.pace.handover

    def put_up(
        self, key: str, since: float, members: Sequence[str], holds: Dict[str, Hold], board: IncidentBoard
    ) -> None:
        """Put it up, unless the task needs several robots."""
        if key in self._shared:
            return
        text = f"{' and '.join(members)} have both held {key} since {self.since(since)}"
        shown = [message for _, message in holds.values()]
        board.open(key, Severity.WARNING, since, text, robots=members, tasks=[key], evidence=shown)
