"""Ways onto topics that are open before anything is said on them: in lock step nothing may be lost."""

from __future__ import annotations

import logging
import time
from typing import Callable, Collection, FrozenSet, Iterable, Protocol, Set, Tuple

from rqt_mrta_py.transport.ros1.master import Graph

__all__ = ["Opener", "Ways"]

_log = logging.getLogger("rqt_mrta_py.app")

_PATIENCE = 5.0
"""How long a subscriber may take to connect [s]."""

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

    def graph(self) -> Graph:
        """Give what the master knows."""
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
        """Open topics, together; those that are open stay so.

        Args:
            topics: each resolved, with its type and whether it is latched.

        Raises:
            TransportError: as of ``advertise``, or the master does not answer.
        """
        new = [each for each in dict.fromkeys(topics) if each[0] not in self._open]
        if not new:
            return
        for topic, type_name, latched in new:
            self._node.advertise(topic, type_name, latched)
        self._open.update(topic for topic, _, _ in new)
        graph = self._node.graph()
        witnesses = self._witnesses.intersection(graph.nodes)
        wanted = {topic: {*graph.subscribers.get(topic, ()), *witnesses} for topic, _, _ in new}
        until = time.monotonic() + _PATIENCE
        while not self._ends():
            missing = [
                f"{topic} {node}" for topic in wanted for node in sorted(wanted[topic] - self._node.hearers(topic))
            ]
            if not missing:
                return
            if time.monotonic() > until:
                _log.warning("nobody waits any longer for: %s", ", ".join(missing))
                return
            time.sleep(_LOOK)
