"""What an ALLIANCE robot says: topics, types and fields of ``alliance_msgs``, and of ``mrta_alliance_msgs`` beside it.

``header/frame_id`` is the robot's id with a leading slash, whichever form its parameters have: by it the original
nodes know their own messages.
"""

from __future__ import annotations

from typing import Dict, Mapping, Sequence, Tuple

import numpy as np

from rqt_mrta_py.hooks import Column, Outgoing, OutgoingRows
from rqt_mrta_py.model import wire_id

__all__ = [
    "COMMUNICATION_TOPIC",
    "COMMUNICATION_TYPE",
    "FEEDBACK_TOPIC",
    "FEEDBACK_TYPE",
    "MOTIVATION_TOPICS",
    "MOTIVATION_TYPE",
    "SensoryFeedbacks",
    "announcement",
    "hazard_notice",
    "header",
    "motivation_topic",
    "motivations",
    "sensory_feedback",
    "time_to_activation",
]

COMMUNICATION_TOPIC = "/alliance/inter_robot_communication"
COMMUNICATION_TYPE = "alliance_msgs/InterRobotCommunication"
MOTIVATION_TOPICS = "/@robot_id@/alliance/motivation/@task_id@"
MOTIVATION_TYPE = "alliance_msgs/Motivation"
FEEDBACK_TOPIC = "alliance/sensory_feedback"
FEEDBACK_TYPE = "alliance_msgs/SensoryFeedback"

_WARN = 4  # rosgraph_msgs/Log.WARN


def header(robot_id: str, now: float) -> Dict[str, object]:
    """Give the header of a message.

    Args:
        robot_id: the sender.
        now: its time, never 0 [s].
    """
    return {"stamp": now, "frame_id": wire_id(robot_id)}


def motivation_topic(task: str) -> str:
    """Give the topic of one behaviour set's Motivation, in the robot's namespace."""
    return f"alliance/motivation/{task}"


def motivations(
    robot_id: str, now: float, topics: Sequence[str], tasks: Sequence[str], columns: Mapping[str, Column]
) -> OutgoingRows:
    """Say how the newest cycle of many behaviour sets went.

    Args:
        robot_id: the sender.
        now: its time [s].
        topics: of each behaviour set, in file order.
        tasks: of each.
        columns: the further fields of Motivation.
    """
    return OutgoingRows(tuple(topics), MOTIVATION_TYPE, {**_heads(robot_id, now), "task_id": tuple(tasks), **columns})


def sensory_feedback(robot_id: str, now: float, task: str, applicable: bool) -> Outgoing:
    """Say whether the sensors find a task applicable."""
    fields = {"header": header(robot_id, now), "task_id": task, "applicable": applicable}
    return Outgoing(FEEDBACK_TOPIC, FEEDBACK_TYPE, fields)


class SensoryFeedbacks:
    """Says whether the sensors find tasks applicable, each in a message of its own, mostly the same again."""

    def __init__(self) -> None:
        """Start with nothing said."""
        self._said: Mapping[str, bool] = {}
        self._topics: Tuple[str, ...] = ()
        self._columns: Mapping[str, Column] = {}

    def message(self, robot_id: str, now: float, applicable: Mapping[str, bool]) -> OutgoingRows:
        """Make the messages of one cycle.

        Args:
            robot_id: the sender.
            now: its time [s].
            applicable: by task; not to be changed any more.
        """
        if applicable is not self._said:
            self._said = applicable
            self._topics = (FEEDBACK_TOPIC,) * len(applicable)
            self._columns = {
                "task_id": tuple(applicable),
                "applicable": np.array(list(applicable.values()), bool),
            }
        return OutgoingRows(self._topics, FEEDBACK_TYPE, {**_heads(robot_id, now), **self._columns})


def announcement(robot_id: str, now: float, task: str, expected_duration: float) -> Outgoing:
    """Say to all robots that this one carries out a task.

    Args:
        robot_id: the sender.
        now: its time [s].
        task: what it carries out.
        expected_duration: how long it takes, above 0 [s].
    """
    fields = {"header": header(robot_id, now), "task_id": task, "expected_duration": expected_duration}
    return Outgoing(COMMUNICATION_TOPIC, COMMUNICATION_TYPE, fields)


def time_to_activation(robot_id: str, now: float, tasks: Sequence[str], seconds: Sequence[float]) -> Outgoing:
    """Say when behaviour sets are expected to become active.

    Args:
        robot_id: the sender.
        now: its time [s].
        tasks: of its behaviour sets, in file order.
        seconds: of each, equation 3.10 [s].
    """
    fields = {"header": header(robot_id, now), "task_ids": list(tasks), "seconds": list(seconds)}
    return Outgoing("alliance/time_to_activation", "mrta_alliance_msgs/TimeToActivation", fields)


def hazard_notice(robot_id: str, now: float, text: str) -> Outgoing:
    """Warn in the ROS log, so that bags hold it, of what would harm an original node.

    Args:
        robot_id: the robot whose agent noticed it.
        now: its time [s].
        text: one line.
    """
    fields = {"header": {"stamp": now}, "level": _WARN, "name": f"/{robot_id}/agent", "msg": text}
    return Outgoing("/rosout", "rosgraph_msgs/Log", fields)


def _heads(robot_id: str, now: float) -> Dict[str, Column]:
    return {"header/stamp": now, "header/frame_id": wire_id(robot_id)}
