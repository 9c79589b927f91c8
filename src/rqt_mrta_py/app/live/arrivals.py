"""What a robot of a free-running team has heard, in the turns in which it would hear it in one process.

In one process a robot hears what others said a tick after they said it, in the order of the team, and what is
simulated in the same tick. Between nodes a quick one's words arrive before one's own turn of the same tick, a slow
one's after it, and a sensor's perhaps after the tick itself. So words are heard by the time at which they were said,
where they tell it, and of what is simulated as many messages as the manifests name.
"""

from __future__ import annotations

import struct
from collections import deque
from typing import Callable, Deque, Dict, List, Mapping, Sequence, Tuple

from rqt_mrta_py.app.live.hold_back import SIMULATION, agent_node
from rqt_mrta_py.app.live.tick_messages import Said, TickNews
from rqt_mrta_py.app.run.clock import RunClock
from rqt_mrta_py.errors import TransportError
from rqt_mrta_py.hooks import Connection, Stamped
from rqt_mrta_py.transport.codec.definitions import parse_definition

__all__ = ["Arrivals"]

_NS = 1_000_000_000
_MOST = 100_000
"""How many messages wait for the next turn; without any turn the oldest are forgotten."""
_OTHER_CLOCK = 10 * _NS
"""A header whose stamp lies further from the receipt does not tell when it was said [ns]."""

_read_stamp = struct.Struct("<4xII").unpack_from


class Arrivals:
    """Keeps messages until the turn in which they are heard.

    Args:
        team: ids of all robots.
        clock: ticks and their stamps.
        hears: tells whether messages of a topic arrive here at all.
    """

    def __init__(self, team: Sequence[str], clock: RunClock, hears: Callable[[str], bool]) -> None:
        self._clock = clock
        self._hears = hears
        self._team = {agent_node(robot): (rank, robot) for rank, robot in enumerate(team)}
        self._waiting: Deque[Stamped] = deque(maxlen=_MOST)
        self._headed: Dict[Connection, bool] = {}
        self._arrived: Dict[str, int] = {}
        self._named: Dict[str, int] = {}
        self._taken: Dict[str, int] = {}
        self._counts = False

    def put(self, stamped: Stamped) -> None:
        """Take in a message that has arrived."""
        self._waiting.append(stamped)
        if stamped.connection.caller == SIMULATION:
            topic = stamped.connection.topic
            self._arrived[topic] = self._arrived.get(topic, 0) + 1

    def expect(self, news: TickNews) -> None:
        """Begin a turn, or pass over it; who was not told of the first tick cannot know what to wait for.

        Args:
            news: of a tick, whose manifest counts as far as it is heard here.
        """
        self._counts = bool(news.manifest) and (self._counts or news.tick == 0)
        if self._counts:
            for said in news.manifest:
                if said.caller not in self._team and self._hears(said.topic):
                    self._named[said.topic] = self._named.get(said.topic, 0) + 1

    @property
    def missing(self) -> Tuple[Said, ...]:
        """What the manifests named and has not arrived yet, once each."""
        arrived = self._arrived
        return tuple(Said(SIMULATION, topic) for topic, named in self._named.items() if arrived.get(topic, 0) < named)

    def forgo(self) -> None:
        """Wait no longer for what is missing: it was lost."""
        for said in self.missing:
            self._named[said.topic] = self._arrived.get(said.topic, 0)

    def take_all(self) -> Sequence[Stamped]:
        """Give all that waits, in the order of arrival."""
        taken = tuple(self._waiting)
        self._waiting.clear()
        return taken

    def take_until(self, until_ns: int) -> Sequence[Stamped]:
        """Give what had arrived by a time [ns], in the order of arrival."""
        taken = []
        while self._waiting and self._waiting[0].receipt_ns <= until_ns:
            taken.append(self._waiting.popleft())
        return taken

    def take(self, tick: int, offsets: Mapping[str, float]) -> Sequence[Stamped]:
        """Give what is heard in a turn: what was said in ticks before, then what is so in this one.

        Args:
            tick: of the turn.
            offsets: by robot: its clock minus the true one [s]; those that are right are left out.
        """
        now_ns = self._clock.stamp_ns(tick)
        waiting, self._waiting = self._waiting, deque(maxlen=_MOST)
        turn: List[Tuple[int, int, Stamped]] = []
        for stamped in waiting:
            caller = stamped.connection.caller
            rank, robot = self._team.get(caller, (len(self._team), ""))
            if robot:
                said = self._said_in(stamped, offsets.get(robot, 0.0))
                due, at = said < tick, self._clock.stamp_ns(min(said, tick - 1))
            elif caller == SIMULATION:
                due, at = self._is_due(stamped, now_ns), now_ns
            else:
                due, at = stamped.receipt_ns <= now_ns, stamped.receipt_ns
            if due:
                turn.append((at, rank, stamped if at == stamped.receipt_ns else stamped._replace(receipt_ns=at)))
            else:
                self._waiting.append(stamped)
        turn.sort(key=lambda each: each[:2])
        return [stamped for _, _, stamped in turn]

    def _is_due(self, stamped: Stamped, now_ns: int) -> bool:
        """Tell whether the next message of the simulation on a topic has its turn."""
        topic = stamped.connection.topic
        if self._counts and self._taken.get(topic, 0) >= self._named.get(topic, 0):
            return False
        if not self._counts and stamped.receipt_ns > now_ns:
            return False
        self._taken[topic] = self._taken.get(topic, 0) + 1
        return True

    def _said_in(self, stamped: Stamped, offset: float) -> int:
        """Give the tick in which an agent said something: by its own words, else by their arrival."""
        receipt_ns = stamped.receipt_ns
        if self._begins_with_header(stamped.connection) and len(stamped.raw) >= 12:
            seconds, nanoseconds = _read_stamp(stamped.raw)
            said_ns = seconds * _NS + nanoseconds - round(offset * _NS)
            if abs(said_ns - receipt_ns) < _OTHER_CLOCK:
                return self._clock.nearest(said_ns)
        return self._clock.nearest(receipt_ns)

    def _begins_with_header(self, connection: Connection) -> bool:
        known = self._headed.get(connection)
        if known is None:
            try:
                known = parse_definition(connection.type, connection.definition).begins_with_header
            except TransportError:
                known = False
            self._headed[connection] = known
        return known
