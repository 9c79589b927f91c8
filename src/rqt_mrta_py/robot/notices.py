"""What a host tells of its tasks: progress for everybody, log lines for people."""

from __future__ import annotations

from typing import NamedTuple, Optional

from rqt_mrta_py.hooks import Heard, Outgoing, Subscription
from rqt_mrta_py.model import Progress, normalise_id

__all__ = ["PROGRESS", "HeardProgress", "log_message", "progress_message", "read_progress"]

# The constants of rqt_mrta_py/TaskProgress, each at the index of its value.
_PROGRESS_BY_CODE = (
    Progress.RUNNING,
    Progress.DONE,
    Progress.FAILED,
    Progress.UNREACHABLE,
    Progress.APPEARED,
    Progress.WITHDRAWN,
    Progress.REASSIGNED,
)
_TOPIC = "/mrta/task_progress"
_TYPE = "rqt_mrta_py/TaskProgress"
_INFO = 2  # rosgraph_msgs/Log.INFO
_WARN = 4  # rosgraph_msgs/Log.WARN

PROGRESS = Subscription(_TOPIC, _TYPE, ("task_id", "robot_id", "progress", "detail"))
"""What to subscribe to for ``read_progress``."""


class HeardProgress(NamedTuple):
    """A task's progress as it was heard.

    Attributes:
        task: its id.
        robot: normalised id of the robot that tells it, or that the task shall go to; empty if none.
        progress: what is told.
        detail: why.
    """

    task: str
    robot: str
    progress: Progress
    detail: str


def read_progress(heard: Heard) -> Optional[HeardProgress]:
    """Read a message of ``PROGRESS``; None if its progress is a number that nobody has defined."""
    fields = heard.fields
    code = fields["progress"]
    if not 0 <= code < len(_PROGRESS_BY_CODE):
        return None
    return HeardProgress(fields["task_id"], normalise_id(fields["robot_id"]), _PROGRESS_BY_CODE[code], fields["detail"])


def progress_message(robot_id: str, task_id: str, progress: Progress, detail: str, now: float) -> Outgoing:
    """Make the message that tells everybody how a task goes at a time [s]."""
    fields = {
        "header": {"stamp": now},
        "task_id": task_id,
        "robot_id": robot_id,
        "progress": _PROGRESS_BY_CODE.index(progress),
        "detail": detail,
    }
    return Outgoing(_TOPIC, _TYPE, fields)


def log_message(robot_id: str, text: str, now: float, *, warning: bool = False) -> Outgoing:
    """Make a line of the ROS log at a time [s], in the name of the robot's agent."""
    fields = {
        "header": {"stamp": now},
        "level": _WARN if warning else _INFO,
        "name": f"/{robot_id}/agent",
        "msg": text,
    }
    return Outgoing("/rosout", "rosgraph_msgs/Log", fields)
