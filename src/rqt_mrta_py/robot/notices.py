"""What hosts tell each other of tasks: progress for everybody, log lines for people."""

from __future__ import annotations

from functools import lru_cache
from typing import NamedTuple, Optional, Union

from rqt_mrta_py.config.tasks.task_text import read_task
from rqt_mrta_py.errors import ConfigError
from rqt_mrta_py.hooks import Heard, Outgoing, Subscription
from rqt_mrta_py.model import Progress, Task, normalise_id

__all__ = ["PROGRESS", "HeardProgress", "log_message", "progress_message", "read_definition", "read_progress"]

_TOPIC = "/mrta/task_progress"
_TYPE = "rqt_mrta_py/TaskProgress"
_INFO = 2  # rosgraph_msgs/Log.INFO
_WARN = 4  # rosgraph_msgs/Log.WARN

PROGRESS = Subscription(_TOPIC, _TYPE, ("task_id", "robot_id", "progress", "detail", "task_yaml"))
"""What to subscribe to for ``read_progress``."""


class HeardProgress(NamedTuple):
    """A task's progress as it was heard.

    Attributes:
        task: normalised id.
        robot: normalised id of the robot that tells it, or that the task shall go to; empty if none.
        progress: what is told.
        detail: why.
        definition: of a task that appeared, what it is, as text that nobody has looked at; empty if not told.
    """

    task: str
    robot: str
    progress: Progress
    detail: str
    definition: str


def read_progress(heard: Heard) -> Optional[HeardProgress]:
    """Read a message of ``PROGRESS``; None if its progress is a number that nobody has defined."""
    fields = heard.fields
    progress = Progress.of_code(fields["progress"])
    if progress is None:
        return None
    return HeardProgress(
        normalise_id(fields["task_id"]),
        normalise_id(fields["robot_id"]),
        progress,
        fields["detail"],
        fields["task_yaml"],
    )


# A whole team hears the same text.
@lru_cache(maxsize=16)
def read_definition(text: str, task_id: str) -> Union[Task, str]:
    """Read what a task is that appeared.

    Args:
        text: from anybody.
        task_id: normalised id of the task that it shall define.

    Returns:
        The task; or what is wrong with the text, in one line.
    """
    try:
        task = read_task(text, "task_yaml")
    except ConfigError as error:
        more = len(error.problems) - 1
        return f"{error.problems[0]}{f' (and {more} more)' if more else ''}"
    return task if task.id == task_id else f"task_yaml: defines {task.id!r}"


def progress_message(robot_id: str, task_id: str, progress: Progress, detail: str, now: float) -> Outgoing:
    """Make the message that tells everybody how a task goes at a time [s]."""
    fields = {
        "header": {"stamp": now},
        "task_id": task_id,
        "robot_id": robot_id,
        "progress": progress.code,
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
