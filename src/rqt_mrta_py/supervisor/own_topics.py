"""The topics on which a supervisor tells what it has derived."""

from __future__ import annotations

from typing import Any, Mapping, NamedTuple

from rqt_mrta_py.hooks import Outgoing

__all__ = ["ALLOCATION", "EVENT", "INCIDENT", "OWN_TOPICS", "ROBOT_STATE", "TASK_STATE", "TEAM_STATE", "OwnTopic"]


class OwnTopic(NamedTuple):
    """One of them.

    Attributes:
        name: absolute.
        type: ``pkg/Msg``.
        latched: in bags and on the bus; a live supervisor latches further ones for whoever subscribes late.
    """

    name: str
    type: str
    latched: bool = False

    def message(self, fields: Mapping[str, Any]) -> Outgoing:
        """Make a message of its fields."""
        return Outgoing(self.name, self.type, fields, self.latched)


ALLOCATION = OwnTopic("/mrta/allocation", "rqt_mrta_py/Allocation")
EVENT = OwnTopic("/mrta/event", "rqt_mrta_py/Event")
INCIDENT = OwnTopic("/mrta/incident", "rqt_mrta_py/Incident")
ROBOT_STATE = OwnTopic("/mrta/robot_state", "rqt_mrta_py/RobotState")
TASK_STATE = OwnTopic("/mrta/task_state", "rqt_mrta_py/TaskState")
TEAM_STATE = OwnTopic("/mrta/team_state", "rqt_mrta_py/TeamState", latched=True)

OWN_TOPICS = (ALLOCATION, EVENT, INCIDENT, ROBOT_STATE, TASK_STATE, TEAM_STATE)
"""All of them, by name."""
