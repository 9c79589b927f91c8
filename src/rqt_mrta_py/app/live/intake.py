"""How messages of a live graph are taken in: those that may change something at once, the others soon, together.

Most messages say nothing that changes anything, but that a robot was heard or still does what it did: they wait for the
next one that may, or for a look at the clock, and are taken in together, in a fraction of the time. Their order, and
what follows from them, is the same.
"""

from __future__ import annotations

from typing import Any, Callable, Dict, List, Optional, Sequence, Tuple

from rqt_mrta_py.app.live.stream_clock import StreamClock
from rqt_mrta_py.app.observation import Observation
from rqt_mrta_py.errors import TransportError
from rqt_mrta_py.hooks import Connection, FieldReader, Stamped

__all__ = ["Intake"]

_MOST_EARLY = 10_000
"""How many messages wait for the first time of a simulated clock."""


class _Source:
    """Where messages come from, and what the latest of them said that had not been said before.

    Attributes:
        connection: kept, so that no other one takes over its identity.
        read: reads what they say to the supervisor; None if nothing.
        counts: whether they are taken in at all.
        said: what was read of the latest one that was new.
        changes: how often anything had changed when that was taken in.
    """

    __slots__ = ("changes", "connection", "counts", "read", "said")

    def __init__(self, connection: Connection, read: Optional[FieldReader], counts: bool = True) -> None:
        self.connection = connection
        self.read = read
        self.counts = counts
        self.said: object = None
        self.changes = -1


class Intake:
    """Takes messages in, in their order; whoever calls holds the node's lock.

    Attributes:
        heard: how many messages have been taken in.

    Args:
        node: resolved name of the node that hears: what it says itself is taken in where it is said.
        clock: gives messages their times of receipt.
        observation: takes them in.
        keepers: who keeps them before that.
        tell: says what has become new.
    """

    def __init__(
        self,
        node: str,
        clock: StreamClock,
        observation: Observation,
        keepers: Sequence[Callable[[Sequence[Stamped]], None]],
        tell: Callable[[], None],
    ) -> None:
        self.heard = 0
        self._node = node
        self._clock = clock
        self._observation = observation
        self._supervisor = observation.supervisor
        self._keepers = tuple(keepers)
        self._tell = tell
        self._early: List[Stamped] = []
        self._waiting: List[Stamped] = []
        self._sources: Dict[int, _Source] = {}
        self._closed = False

    def hear(self, stamped: Stamped) -> None:
        """Hear a message of somebody's, received by ROS time."""
        source = self._sources.get(id(stamped[0])) or self._meet(stamped[0])
        read = source.read
        if read is None:
            if source.counts:
                self._waiting.append(stamped)
            return
        try:
            said: object = read(stamped[2])
        except TransportError:
            said = None
        supervisor = self._supervisor
        if said is not None and said == source.said and supervisor.changes == source.changes:
            self._waiting.append(stamped)
            return
        self.catch_up()
        self.take(stamped)
        self._tell()
        source.said, source.changes = said, supervisor.changes

    def catch_up(self) -> None:
        """Take in what waits."""
        if self._early and self._clock.runs:
            early, self._early = self._early, []
            at = self._clock.receipt()
            for stamped in early:
                self.take(stamped._replace(receipt_ns=at))
        if not self._waiting:
            return
        waiting, self._waiting = self._waiting, []
        if self._closed:
            return
        if not self._clock.runs:
            self._keep_early(waiting)
            return
        messages = self._clock.stamped(waiting)
        for keep in self._keepers:
            keep(messages)
        self._observation.feed_all(messages)
        self.heard += len(messages)

    def take(self, stamped: Stamped) -> None:
        """Take in a message; whatever waits has been taken in."""
        if self._closed:
            return
        if not self._clock.runs:
            self._keep_early((stamped,))
            return
        messages = self._clock.stamped((stamped,))
        for keep in self._keepers:
            keep(messages)
        self._observation.feed(messages[0])
        self.heard += 1

    def close(self) -> None:
        """Take in nothing more."""
        self._closed = True

    def _keep_early(self, messages: Sequence[Stamped]) -> None:
        """Keep what came before a simulated clock began to run: it is taken in with its first time."""
        self._early.extend(messages)
        del self._early[_MOST_EARLY:]

    def _meet(self, connection: Connection) -> _Source:
        """Find out about a new connection."""
        if connection.caller == self._node:
            source = _Source(connection, None, counts=False)
        else:
            try:
                source = _Source(connection, self._observation.statements(connection))
            except TransportError:
                source = _Source(connection, _reads_nothing)
        self._sources[id(connection)] = source
        return source


def _reads_nothing(_raw: bytes) -> Tuple[Any, ...]:
    """Read messages of a definition that has not what is to be read: each is taken in at once."""
    raise TransportError("its definition has not what is to be read")
