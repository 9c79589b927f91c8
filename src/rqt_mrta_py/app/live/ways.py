"""Ways onto topics that are open before anything is said on them, so that nothing is lost at the beginning."""

from __future__ import annotations

import itertools
import logging
import time
from typing import Callable, Collection, FrozenSet, Iterable, Mapping, Optional, Protocol, Sequence, Set, Tuple

from rqt_mrta_py.errors import TransportError
from rqt_mrta_py.hooks import EVERYTHING, Stamped, Subscription
from rqt_mrta_py.model import ROBOT_TOKEN, TASK_TOKEN, Mission
from rqt_mrta_py.transport.ros1.master import Graph

__all__ = ["Opener", "Opening", "Ways", "expanded", "foreseen_topics", "overhear"]

_log = logging.getLogger("rqt_mrta_py.app")

_PATIENCE = 15.0
"""How long a subscriber may take to connect [s]."""

_DOUBT = 1.0
"""After what time it is asked whether a subscriber is still alive [s]."""
_MOST_TOPICS = 256
"""How many topics a pattern may stand for that are subscribed to before anybody publishes them."""
_LOOK = 0.005
"""How often it is looked whether all are connected [s]."""


class Opener(Protocol):
    """What is asked of a node of ROS."""

    def advertise(self, topic: str, type_name: str, latched: bool = False) -> None:
        """Let subscribers find a topic."""
        ...

    def hearers(self, topic: str) -> FrozenSet[str]:
        """Give the nodes that are connected to a topic."""
        ...

    def refused(self, topic: str) -> FrozenSet[str]:
        """Give the nodes that will not be connected to a topic, for they take it for something else."""
        ...

    def graph(self) -> Graph:
        """Give what the master knows."""
        ...

    def reaches(self, node: str) -> bool:
        """Tell whether a node answers."""
        ...


class Ways:
    """Opens topics of a node, and waits until everybody who wants to hear them is connected.

    Not to be called with the node's lock held, for connecting may need it.

    Args:
        node: that publishes.
        witnesses: nodes that hear every topic as soon as they find it; those that are not there are not waited for.
        ends: tells whether to stop waiting.
    """

    def __init__(self, node: Opener, witnesses: Collection[str], ends: Callable[[], bool]) -> None:
        self._node = node
        self._witnesses = frozenset(witnesses)
        self._ends = ends
        self._open: Set[str] = set()

    def open(self, topics: Iterable[Tuple[str, str, bool]]) -> None:
        """Open topics, together, and wait until they are; those that are open stay so.

        Args:
            topics: each resolved, with its type and whether it is latched.

        Raises:
            TransportError: as of ``advertise``.
        """
        opening = self.begin(topics)
        while opening is not None and not self._ends() and not opening.is_over():
            time.sleep(_LOOK)

    def begin(self, topics: Iterable[Tuple[str, str, bool]]) -> Optional[Opening]:
        """Begin to open topics, together, without waiting.

        Args:
            topics: each resolved, with its type and whether it is latched.

        Returns:
            What tells when they are open; None if all of them have been begun before.

        Raises:
            TransportError: as of ``advertise``.
        """
        new = [each for each in dict.fromkeys(topics) if each[0] not in self._open]
        if not new:
            return None
        for topic, type_name, latched in new:
            self._node.advertise(topic, type_name, latched)
        names = [topic for topic, _, _ in new]
        self._open.update(names)
        try:
            graph = self._node.graph()
        except TransportError as error:
            # The mission goes on without a master; who comes to hear of the topics later may miss the beginning.
            _log.warning("nobody knows who hears %s: %s", ", ".join(names), error)
            return Opening(self._node, dict.fromkeys(names, frozenset()))
        witnesses = self._witnesses.intersection(graph.nodes)
        return Opening(self._node, {topic: witnesses.union(graph.subscribers.get(topic, ())) for topic in names})


class Opening:
    """Topics that are being opened.

    Attributes:
        topics: their names.

    Args:
        node: that publishes.
        wanted: who is to be connected to each.
    """

    def __init__(self, node: Opener, wanted: Mapping[str, FrozenSet[str]]) -> None:
        self.topics = tuple(wanted)
        self._node = node
        self._wanted = wanted
        self._began = time.monotonic()
        self._doubt = self._began + _DOUBT

    def is_over(self) -> bool:
        """Look whether all who live are connected, or have been waited for long enough."""
        missing = {
            topic: nodes - self._node.hearers(topic) - self._node.refused(topic)
            for topic, nodes in self._wanted.items()
        }
        absent = frozenset().union(*missing.values())
        if not absent:
            return True
        now = time.monotonic()
        if now > self._began + _PATIENCE:
            told = ", ".join(f"{topic} {node}" for topic, nodes in missing.items() for node in sorted(nodes))
            _log.warning("nobody waits any longer for: %s", told)
            return True
        if now > self._doubt:
            try:
                dead = frozenset(node for node in absent if not self._node.reaches(node))
            except TransportError as error:
                _log.warning("nobody knows who lives and hears %s: %s", ", ".join(self.topics), error)
                return True
            self._wanted = {topic: nodes - dead for topic, nodes in self._wanted.items()}
            self._doubt = time.monotonic() + _DOUBT
        return False


def expanded(topic: str, team: Sequence[str], tasks: Sequence[str]) -> Sequence[str]:
    """Give the topics that a pattern stands for, as far as robots and tasks are known.

    Args:
        topic: resolved, perhaps with tokens.
        team: ids of robots.
        tasks: ids of tasks.

    Returns:
        The topics; none if there are too many, or the pattern means everything.
    """
    robots = team if ROBOT_TOKEN in topic else ("",)
    names = tasks if TASK_TOKEN in topic else ("",)
    if topic == EVERYTHING or len(robots) * len(names) > _MOST_TOPICS:
        return ()
    return [
        topic.replace(ROBOT_TOKEN, robot).replace(TASK_TOKEN, task) for robot, task in itertools.product(robots, names)
    ]


def foreseen_topics(mission: Mission, wishes: Iterable[Subscription]) -> Sequence[str]:
    """Give the topics that somebody wants to hear of a mission, as far as robots and tasks are known.

    Who subscribes to them before anybody publishes there hears the first message; whoever asks the master comes late.

    Args:
        mission: tells robots and tasks.
        wishes: their topics are absolute, perhaps with tokens.
    """
    robots = [robot.id for robot in mission.application.robots]
    tasks = mission.task_ids
    return tuple(dict.fromkeys(topic for wish in wishes for topic in expanded(wish.topic, robots, tasks)))


def overhear(_stamped: Stamped) -> None:
    """Take no note of a message; somebody else does."""
