"""The watch on the master: is it there, is it the same, what topics are there."""

from __future__ import annotations

import threading
import time
from enum import Enum
from typing import Callable, Mapping

from rqt_mrta_py.errors import TransportError
from rqt_mrta_py.transport.ros1.master import Master
from rqt_mrta_py.transport.ros1.registrations import Registrations

__all__ = ["MasterChange", "MasterWatch"]

PERIOD = 0.5
"""How often the master is asked [s]."""


class MasterChange(Enum):
    """What became of the master.

    LOST: it does not answer any more; what is connected stays so.
    FOUND: it answers again and still knows this node.
    RESTARTED: a new one answers; it has been told all that this node publishes, hears and serves.
    """

    LOST = "lost"
    FOUND = "found"
    RESTARTED = "restarted"


class MasterWatch:
    """Asks the master in a thread of its own, so that no callback ever waits for it.

    Args:
        master: that is asked.
        node: resolved name of this node.
        on_topics: is told of the published topics with their types, whenever they are asked for.
        on_change: is told what became of the master.
        on_failure: is told what one of these raised, which ends the watch.
    """

    def __init__(
        self,
        master: Master,
        node: str,
        on_topics: Callable[[Mapping[str, str]], None],
        on_change: Callable[[MasterChange], None],
        on_failure: Callable[[Exception], None],
    ) -> None:
        self._master = master
        self._node = node
        self._on_topics = on_topics
        self._on_change = on_change
        self._on_failure = on_failure
        self._due = threading.Event()
        self._ended = False
        self._lost = False
        self._registrations = Registrations(self._due.set)
        self._thread = threading.Thread(target=self._run, name="master watch", daemon=True)

    def start(self) -> None:
        """Begin to ask."""
        self._thread.start()

    def stop(self) -> None:
        """Ask no more; it may never have begun, where Ctrl-C came first."""
        self._ended = True
        self._due.set()
        if self._thread.is_alive() and threading.current_thread() is not self._thread:
            self._thread.join(PERIOD)

    def again(self, topic: str) -> None:
        """Ask soon who publishes a topic: a connection was lost whose publisher may still be there."""
        self._registrations.again(topic)

    def wake(self) -> None:
        """Ask at once."""
        self._due.set()

    def _run(self) -> None:
        try:
            self._watch()
        except Exception as error:  # noqa: BLE001 - a thread's end must not go unnoticed
            self._on_failure(error)

    def _watch(self) -> None:
        asked = float("-inf")
        while not self._ended:
            self._due.clear()
            try:
                now = time.monotonic()
                if self._lost or now - asked >= PERIOD:
                    asked = now
                    self._look()
                if not self._ended:
                    self._registrations.tell(self._master)
                    self._on_topics(dict(self._master.ask("getPublishedTopics", "")[2]))
            except TransportError:
                if not (self._lost or self._ended):
                    self._lost = True
                    self._on_change(MasterChange.LOST)
                time.sleep(PERIOD / 2)
            self._due.wait(PERIOD)

    def _look(self) -> None:
        known, _, _ = self._master.ask("lookupNode", self._node)
        new = self._registrations.any_told and not known
        if new:
            self._registrations.forget()
            self._registrations.tell(self._master)
        if new or self._lost:
            self._lost = False
            self._on_change(MasterChange.RESTARTED if new else MasterChange.FOUND)
