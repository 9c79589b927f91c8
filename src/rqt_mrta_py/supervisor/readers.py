"""What an architecture's monitored topics say: which fields to ask for, and how to read ids and stamps from them."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any, Iterator, Mapping, Sequence, Tuple

from rqt_mrta_py.hooks import Heard, Subscription
from rqt_mrta_py.model import ROBOT_TOKEN, TASK_TOKEN, ArchitectureSpec, MonitoredTopic, normalise_id

__all__ = ["STAMP", "TopicReader", "allocation_readers", "robot_readers", "stamp_of", "task_readers", "text_of"]

STAMP = "header/stamp"


def text_of(fields: Mapping[str, Any], path: str) -> str:
    """Read an id: a text as it stands, a whole number as its digits; empty if it is anything else or not there."""
    value = fields.get(path, "") if path else ""
    if isinstance(value, str):
        return value
    return str(value) if isinstance(value, int) and not isinstance(value, bool) else ""


def stamp_of(heard: Heard) -> float:
    """Read a message's header stamp [s]; 0 if it has none or its subscriber did not ask for it."""
    value = heard.fields.get(STAMP, 0.0)
    return float(value) if isinstance(value, (int, float)) else 0.0


@dataclass(frozen=True)
class TopicReader:
    """One monitored topic, and where in its messages the ids stand.

    Attributes:
        topic: as the architecture declares it.
        robot_path: field with the robot's id; empty if the name of the topic tells it, or nothing does.
        task_path: field with the task's id; empty likewise.
        stamped: whether the type is known to have a header.
    """

    topic: MonitoredTopic
    robot_path: str
    task_path: str
    stamped: bool

    @property
    def timeout(self) -> float:
        """How long one message counts [s]."""
        return max(self.topic.timeout, 0.0)

    @property
    def tells_robot(self) -> bool:
        """Whether each message tells a robot, in a field or by the name of its topic."""
        return bool(self.robot_path) or ROBOT_TOKEN in self.topic.name

    @property
    def tells_task(self) -> bool:
        """Whether each message tells a task, in a field or by the name of its topic."""
        return bool(self.task_path) or TASK_TOKEN in self.topic.name

    def subscription(self) -> Subscription:
        """Ask for what is read here."""
        paths = [self.robot_path, self.task_path, STAMP if self.stamped else ""]
        return Subscription(self.topic.name, self.topic.type, tuple(dict.fromkeys(path for path in paths if path)))

    def robot_of(self, heard: Heard) -> str:
        """Read the normalised id of the robot; empty if the message names none."""
        if not self.robot_path:
            return heard.robot
        return normalise_id(text_of(heard.fields, self.robot_path)) or heard.robot

    def task_of(self, heard: Heard) -> str:
        """Read the normalised id of the task; empty if the message names none."""
        if not self.task_path:
            return heard.task
        return normalise_id(text_of(heard.fields, self.task_path)) or heard.task


def robot_readers(topics: Sequence[MonitoredTopic]) -> Tuple[TopicReader, ...]:
    """Make readers of busy or idle topics; those that cannot tell a robot are left out."""
    return tuple(
        TopicReader(topic, topic.field, topic.task_field, _has_header(topic.field, topic.task_field))
        for topic in _named(topics)
        if topic.field or ROBOT_TOKEN in topic.name
    )


def task_readers(topics: Sequence[MonitoredTopic]) -> Tuple[TopicReader, ...]:
    """Make readers of incoming, completed or failed topics; those that cannot tell a task are left out."""
    return tuple(_task_reader(topic, topic.robot_field) for topic in _named(topics) if _tells_task(topic))


def allocation_readers(architecture: ArchitectureSpec) -> Tuple[TopicReader, ...]:
    """Make readers of allocated topics; where a busy topic is the same topic, its field tells the robot.

    Args:
        architecture: declares both.
    """
    busy = {(topic.name, topic.type): topic.field for topic in reversed(architecture.busy_robots)}
    return tuple(
        _task_reader(topic, topic.robot_field or busy.get((topic.name, topic.type), ""))
        for topic in _named(architecture.allocated_tasks)
        if _tells_task(topic)
    )


def _named(topics: Sequence[MonitoredTopic]) -> Iterator[MonitoredTopic]:
    return (topic for topic in topics if topic.name)


def _tells_task(topic: MonitoredTopic) -> bool:
    return bool(topic.task_field or topic.field) or TASK_TOKEN in topic.name


def _task_reader(topic: MonitoredTopic, robot_path: str) -> TopicReader:
    task_path = topic.task_field or topic.field
    return TopicReader(topic, robot_path, task_path, _has_header(task_path, robot_path))


def _has_header(*paths: str) -> bool:
    return any(path.startswith("header/") for path in paths)
