"""The topics of an architecture, by what they say, and how long what they say counts."""

from __future__ import annotations

from typing import FrozenSet

from rqt_mrta_py.hooks import AllocationPace
from rqt_mrta_py.model import ArchitectureSpec
from rqt_mrta_py.supervisor.joins import join_tables
from rqt_mrta_py.supervisor.readers import allocation_readers, robot_readers, task_readers

__all__ = ["Topics", "usual_pace"]

_MINIMUM_SILENCE = 2.0
_LONGEST_HOLD = 3600.0


class Topics:
    """An architecture's monitored topics, ready to be read.

    Args:
        architecture: declares them.
    """

    def __init__(self, architecture: ArchitectureSpec) -> None:
        self.tables = join_tables(architecture.monitored_topics)
        joins = {table.join: table for table in self.tables}
        self.busy = robot_readers(architecture.busy_robots, joins)
        self.idle = robot_readers(architecture.idle_robots, joins)
        self.incoming = task_readers(architecture.incoming_tasks, joins)
        self.allocated = allocation_readers(architecture, joins)
        self.completed = task_readers(architecture.completed_tasks, joins)
        self.failed = task_readers(architecture.failed_tasks, joins)

    @property
    def silence(self) -> float:
        """How long a robot says nothing on any topic until it counts as lost [s]."""
        return max([_MINIMUM_SILENCE, *(reader.timeout for reader in (*self.busy, *self.idle))])

    @property
    def busy_timeout(self) -> float:
        """How long a busy message counts at most [s]; an allocated message counts no shorter."""
        return max((reader.timeout for reader in self.busy), default=0.0)

    @property
    def hold(self) -> float:
        """How long a sign keeps an allocation going [s]."""
        return max((reader.timeout for reader in (*self.busy, *self.allocated)), default=_MINIMUM_SILENCE)

    @property
    def naming(self) -> FrozenSet[str]:
        """Topics whose messages name the robot that speaks."""
        return frozenset(reader.topic.name for reader in (*self.busy, *self.idle) if reader.robot_path)


def usual_pace(architecture: ArchitectureSpec) -> AllocationPace:
    """Tell how fast tasks are shared out, as far as timeouts of monitored topics tell.

    All of it in times that one message keeps an allocation going: after two of them what is still held has been said
    anew since it changed hands; five are a try; fifteen are long for a robot with nothing to do.

    Args:
        architecture: declares the topics.
    """
    hold = Topics(architecture).hold
    hold = hold if 0.0 < hold < _LONGEST_HOLD else _MINIMUM_SILENCE
    return AllocationPace(handover=2.0 * hold, uptake=15.0 * hold, brief=5.0 * hold)
