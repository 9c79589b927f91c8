"""What a robot believes, as a message for those who watch; no robot listens to it."""

from __future__ import annotations

import math
from typing import Any, Dict, Tuple

from mrta_demir_cf.mind import Mind
from mrta_demir_cf.task_states import TaskBelief
from rqt_mrta_py.hooks import Outgoing
from rqt_mrta_py.model import wire_id

__all__ = ["BELIEFS_TOPIC", "BELIEFS_TOPICS", "BELIEFS_TYPE", "BeliefsTeller", "notice_message"]

BELIEFS_TOPIC = "demir_cf/beliefs"
"""In the robot's namespace."""

BELIEFS_TOPICS = "/@robot_id@/demir_cf/beliefs"
"""Of all robots."""

BELIEFS_TYPE = "demir_cf_msgs/Beliefs"

_WARN = 4  # rosgraph_msgs/Log.WARN


class BeliefsTeller:
    """Tells beliefs whenever a state changes, and from time to time.

    Args:
        mind: whose beliefs they are.
        period: at most this long from one message to the next [s].
    """

    def __init__(self, mind: Mind, period: float) -> None:
        self._mind = mind
        self._period = period
        self._told = (-1, 0)
        self._told_at = -math.inf

    def message(self) -> Tuple[Outgoing, ...]:
        """Give the message that is due now, if one is."""
        mind = self._mind
        told = (mind.changes, mind.contradictions)
        if told == self._told and mind.now - self._told_at < self._period:
            return ()
        self._told, self._told_at = told, mind.now
        held = mind.tasks[mind.mine] if mind.mine is not None else None
        executes = held is not None and held.belief is TaskBelief.EXECUTING
        cost = mind.held_cost(held) if held is not None and executes else math.nan
        fields: Dict[str, Any] = {
            "header": {"stamp": mind.now, "frame_id": wire_id(mind.robot_id)},
            "robot_id": mind.robot_id,
            "task_id": held.id if held is not None and executes else "",
            "cost": cost,
            "contradictions": mind.contradictions,
            "task_ids": list(mind.tasks),
            "states": [model.belief.value for model in mind.tasks.values()],
            "holders": [model.holder for model in mind.tasks.values()],
            "robot_ids": list(mind.robots),
            "robot_states": [robot.belief.value for robot in mind.robots.values()],
        }
        return (Outgoing(BELIEFS_TOPIC, BELIEFS_TYPE, fields),)


def notice_message(mind: Mind, text: str) -> Outgoing:
    """Warn in the ROS log, so that bags hold it, of a change that the tables do not allow."""
    fields = {"header": {"stamp": mind.now}, "level": _WARN, "name": f"/{mind.robot_id}/agent", "msg": text}
    return Outgoing("/rosout", "rosgraph_msgs/Log", fields)
