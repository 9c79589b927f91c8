"""What an architecture declares in its rqt_mrta.xml."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Optional, Tuple

from rqt_mrta_py.model.parameters import ConfigTemplate
from rqt_mrta_py.model.taxonomy import Taxonomy

__all__ = [
    "ArchitectureSpec",
    "IncludeSpec",
    "LaunchArgument",
    "LaunchTemplate",
    "MonitoredTopic",
    "TopicCondition",
    "TopicJoin",
]


@dataclass(frozen=True)
class TopicJoin:
    """Another topic that says for which task something else stands, such as an auction.

    Attributes:
        name: absolute topic; ``@robot_id@`` and ``@task_id@`` in it stand for any name.
        type: ``pkg/Msg``.
        field: path of the id of what stands for a task.
        task_field: path of the id of that task.
    """

    name: str
    type: str
    field: str
    task_field: str


@dataclass(frozen=True)
class TopicCondition:
    """What a message must say to count.

    Attributes:
        field: path of a string, a whole number or a bool.
        value: as text; of a bool ``true`` or ``false``.
    """

    field: str
    value: str


@dataclass(frozen=True)
class MonitoredTopic:
    """A topic that tells of robots or tasks, and where in its messages.

    Attributes:
        name: absolute topic; may hold ``@robot_id@`` and ``@task_id@``, the name then tells the robot or task.
        type: ``pkg/Msg``.
        field: path, joined by ``/``, of the string field with the id that this topic is about.
        robot_field: path of the robot's id where ``field`` is the task's; empty if none.
        task_field: path of the task's id where ``field`` is the robot's; empty if none.
        queue_size: messages that a subscriber keeps; 0 is unbounded.
        timeout: how long one message keeps the state fresh [s].
        horizon: history window [s].
        join: tells the task where the id in the task's place is of something else; None if it is the task's.
        condition: only messages that meet it count; None if all do.
        bid_field: path of the number that a robot bids; empty unless this topic tells bids.
    """

    name: str
    type: str
    field: str = ""
    robot_field: str = ""
    task_field: str = ""
    queue_size: int = 0
    timeout: float = 2.0
    horizon: float = 5.0
    join: Optional[TopicJoin] = None
    condition: Optional[TopicCondition] = None
    bid_field: str = ""


@dataclass(frozen=True)
class LaunchArgument:
    """An ``arg`` of an include; mandatory when the default is empty."""

    name: str
    value: str = ""
    default: str = ""


@dataclass(frozen=True)
class IncludeSpec:
    """A launch file that a launch file includes."""

    file: str
    arguments: Tuple[LaunchArgument, ...] = ()


@dataclass(frozen=True)
class LaunchTemplate:
    """One launch file (``launch_<i>``), written to ``launch/<id>.launch``."""

    id: str
    includes: Tuple[IncludeSpec, ...] = ()


@dataclass(frozen=True)
class ArchitectureSpec:
    """An allocation architecture as registered.

    Attributes:
        package: the ROS package that registers it; its name for the command line.
        name: its name for people.
        taxonomy: which problems it solves.
        busy_robots: topics that say that a robot is busy now.
        idle_robots: topics that say that a robot is idle now.
        incoming_tasks: topics that say that a task has arrived.
        allocated_tasks: topics that say that a task is being executed.
        completed_tasks: topics that say that a task is done.
        failed_tasks: topics that say that a task has failed.
        bids: topics that say what a robot bids for a task; nothing follows from them but why tasks went to whom.
        robot_config_id: id of the config that every robot gets a copy of; None if none.
        robot_launch_id: id of the launch that every robot gets a copy of; None if none.
        configs: parameter templates, in file order.
        launches: launch templates, in file order.
        widgets: names of the monitor panels, in file order.
    """

    package: str
    name: str
    taxonomy: Taxonomy
    busy_robots: Tuple[MonitoredTopic, ...] = ()
    idle_robots: Tuple[MonitoredTopic, ...] = ()
    incoming_tasks: Tuple[MonitoredTopic, ...] = ()
    allocated_tasks: Tuple[MonitoredTopic, ...] = ()
    completed_tasks: Tuple[MonitoredTopic, ...] = ()
    failed_tasks: Tuple[MonitoredTopic, ...] = ()
    bids: Tuple[MonitoredTopic, ...] = ()
    robot_config_id: Optional[str] = None
    robot_launch_id: Optional[str] = None
    configs: Tuple[ConfigTemplate, ...] = ()
    launches: Tuple[LaunchTemplate, ...] = ()
    widgets: Tuple[str, ...] = ()

    @property
    def monitored_topics(self) -> Tuple[MonitoredTopic, ...]:
        """All topics from which states follow."""
        return (
            *self.busy_robots,
            *self.idle_robots,
            *self.incoming_tasks,
            *self.allocated_tasks,
            *self.completed_tasks,
            *self.failed_tasks,
        )
