"""Rule: a robot that can carry out one task at a time holds two."""

from __future__ import annotations

from typing import Dict, Sequence, Tuple

from rqt_mrta_py.hooks import IncidentBoard, RuleSetup
from rqt_mrta_py.model import RobotType, Severity
from rqt_mrta_py.supervisor.rules.overlap import Hold, Overlap

__all__ = ["RobotWithTwoTasks"]


class RobotWithTwoTasks(Overlap):
    """Puts up a warning from the moment on at which a robot took a task while it still held another.

    Fires: under a single-task (ST) architecture, when a robot holds two tasks together from a time s on and still does
    at s + ``handover``. At that time it is put up; it lasts from s until the robot holds one task at most.

    Does not fire: under MT architectures and those of unknown type; for shorter overlaps, as when a robot changes tasks
    and what it said last of the old one still counts.

    Args:
        setup: ``pace.handover`` says for how long it may hold both.
    """

    causes = (
        "Two nodes speak under one robot's id, or a robot went on to its next task without stopping the old one: a "
        "restarted agent beside its predecessor, a copied namespace, a lost or ignored order to stop."
    )

    def __init__(self, setup: RuleSetup) -> None:
        super().__init__(setup, setup.mission.architecture.taxonomy.robots is RobotType.SINGLE_TASK)

    def side(self, robot: str, task: str) -> Tuple[str, str]:
        """Give the robot, and what it holds."""
        return robot, task

    def deadline(self, key: str, since: float, holds: Dict[str, Hold]) -> float:
        """Say until when it must have let go of one [s]."""
        return since + self.pace.handover

    def put_up(
        self, key: str, since: float, members: Sequence[str], holds: Dict[str, Hold], board: IncidentBoard
    ) -> None:
        """Put it up."""
        text = (
            f"{key} has held {' and '.join(members)} together since {self.since(since)}, but carries out one at a time"
        )
        shown = [message for _, message in holds.values()]
        board.open(key, Severity.WARNING, since, text, robots=[key], tasks=members, evidence=shown)
