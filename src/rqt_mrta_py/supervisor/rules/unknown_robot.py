"""Rule: a message names a robot that is not of the team."""

from __future__ import annotations

from rqt_mrta_py.hooks import Fact, IncidentBoard, UnknownRobotNamed
from rqt_mrta_py.supervisor.rules.unknown_names import Named, UnknownNames

__all__ = ["UnknownRobot"]


class UnknownRobot(UnknownNames):
    """Puts up a warning on each robot that is named and is none of the mission's.

    Fires: at once, when a message on a monitored topic, or on ``/mrta/task_progress``, names a robot that the mission
    does not list. It lasts from the first such message to the last one, which is that after which there is none for
    twice ``pace.handover``. Of more than 50 such ids the first 50 are told.

    Does not fire: where the mission lists no robots; for robots that only publish on topics that are not monitored; for
    what an architecture says on further topics.

    Args:
        setup: see ``UnknownNames``.
    """

    causes = (
        "A namespace or frame id is misspelt, a robot of another team speaks on the same master, or the application's "
        "file does not list the robot."
    )

    def notice(self, fact: Fact, board: IncidentBoard) -> None:
        """Follow which unknown robots are named."""
        if isinstance(fact, UnknownRobotNamed):
            known = [robot.id for robot in self.mission.application.robots]
            named = Named(fact.robot, f"{fact.message.topic} names robot", known, robots=[fact.robot])
            self.name(fact, named, board)
