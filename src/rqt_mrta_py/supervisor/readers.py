"""What an architecture's monitored topics say: which fields to ask for, and how to read ids and stamps from them."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Iterator, Mapping, Optional, Sequence, Tuple

from rqt_mrta_py.hooks import Heard, Subscription
from rqt_mrta_py.model import (
    ROBOT_TOKEN,
    TASK_TOKEN,
    ArchitectureSpec,
    MonitoredTopic,
    TopicJoin,
    normalise_id,
)
from rqt_mrta_py.supervisor.joins import JoinTable
from rqt_mrta_py.supervisor.values import STAMP, meets, text_of

__all__ = ["Joins", "TopicReader", "allocation_readers", "robot_readers", "task_readers"]

Joins = Mapping[TopicJoin, JoinTable]


@dataclass(frozen=True)
class TopicReader:
    """One monitored topic, and where in its messages the ids stand.

    Attributes:
        topic: as the architecture declares it.
        robot_path: field with the robot's id; empty if the name of the topic tells it, or nothing does.
        task_path: field with the task's id; empty likewise.
        stamped: whether the type is known to have a header.
        table: says which task it is where another id stands in the task's place; None if it is the task's own.
    """

    topic: MonitoredTopic
    robot_path: str
    task_path: str
    stamped: bool
    table: Optional[JoinTable] = None

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
        condition = self.topic.condition
        paths = [self.robot_path, self.task_path, STAMP if self.stamped else "", condition.field if condition else ""]
        return Subscription(self.topic.name, self.topic.type, tuple(dict.fromkeys(path for path in paths if path)))

    def robot_of(self, heard: Heard) -> str:
        """Read the normalised id of the robot; empty if the message names none."""
        if not self.robot_path:
            return heard.robot
        return normalise_id(text_of(heard.fields, self.robot_path)) or heard.robot

    def task_of(self, heard: Heard) -> str:
        """Read the normalised id of the task; empty if the message names none, or what stands for none so far."""
        if self.table is not None:
            return self.table.find(self.key_of(heard))
        if not self.task_path:
            return heard.task
        return normalise_id(text_of(heard.fields, self.task_path)) or heard.task

    def key_of(self, heard: Heard) -> str:
        """Read the id that stands in the task's place, whatever it is of; empty if there is none."""
        return text_of(heard.fields, self.task_path) if self.task_path else heard.task

    def counts(self, heard: Heard) -> bool:
        """Tell whether a message meets the topic's condition."""
        condition = self.topic.condition
        return condition is None or meets(heard.fields, condition.field, condition.value)


def robot_readers(topics: Sequence[MonitoredTopic], joins: Joins) -> Tuple[TopicReader, ...]:
    """Make readers of busy or idle topics; those that cannot tell a robot are left out."""
    return tuple(
        _reader(topic, topic.field, topic.task_field, joins)
        for topic in _named(topics)
        if topic.field or ROBOT_TOKEN in topic.name
    )


def task_readers(topics: Sequence[MonitoredTopic], joins: Joins) -> Tuple[TopicReader, ...]:
    """Make readers of incoming, completed or failed topics; those that cannot tell a task are left out."""
    return tuple(
        _reader(topic, topic.robot_field, topic.task_field or topic.field, joins)
        for topic in _named(topics)
        if _tells_task(topic)
    )


def allocation_readers(architecture: ArchitectureSpec, joins: Joins) -> Tuple[TopicReader, ...]:
    """Make readers of allocated topics; where a busy topic is the same topic, its field tells the robot.

    Args:
        architecture: declares both.
        joins: tables of its joins.
    """
    busy = {(topic.name, topic.type): topic.field for topic in reversed(architecture.busy_robots)}
    return tuple(
        _reader(
            topic,
            topic.robot_field or busy.get((topic.name, topic.type), ""),
            topic.task_field or topic.field,
            joins,
        )
        for topic in _named(architecture.allocated_tasks)
        if _tells_task(topic)
    )


def _named(topics: Sequence[MonitoredTopic]) -> Iterator[MonitoredTopic]:
    return (topic for topic in topics if topic.name)


def _tells_task(topic: MonitoredTopic) -> bool:
    return bool(topic.task_field or topic.field) or TASK_TOKEN in topic.name


def _reader(topic: MonitoredTopic, robot_path: str, task_path: str, joins: Joins) -> TopicReader:
    stamped = any(path.startswith("header/") for path in (robot_path, task_path))
    return TopicReader(topic, robot_path, task_path, stamped, None if topic.join is None else joins[topic.join])
