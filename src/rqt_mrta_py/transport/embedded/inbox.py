"""What is on its way to one node of the embedded bus."""

from __future__ import annotations

import heapq
from collections import deque
from operator import itemgetter
from typing import Any, Callable, Deque, List, Mapping, NamedTuple, Optional, Tuple

from rqt_mrta_py.hooks import Connection, FieldReader, Heard

__all__ = ["Delivery", "Hearing", "Inbox", "Message"]


class Message:
    """One message under way; its fields are read once for each set of paths, whoever hears them."""

    __slots__ = ("_read", "connection", "ordinal", "raw")

    def __init__(self, connection: Connection, ordinal: int, raw: bytes) -> None:
        self.connection = connection
        self.ordinal = ordinal
        self.raw = raw
        self._read: Tuple[Tuple[Tuple[str, ...], Mapping[str, Any]], ...] = ()

    def fields(self, paths: Tuple[str, ...], reader: FieldReader) -> Mapping[str, Any]:
        """Give value by path; everybody who asks for the same paths is handed the same mapping."""
        for known, fields in self._read:
            if known == paths:
                return fields
        fields = dict(zip(paths, reader(self.raw)))
        self._read = (*self._read, (paths, fields))
        return fields


class Hearing(NamedTuple):
    """A subscription that a topic's messages suit, with what the tokens of the topic stand for."""

    callback: Callable[[Heard], None]
    robot: str
    task: str
    paths: Tuple[str, ...]
    reader: Optional[FieldReader]


Delivery = Tuple[float, Message, Tuple[Hearing, ...]]
"""When a message arrives [s], the message, and the subscriptions of the node that mean it."""

_arrival = itemgetter(0)


class Inbox:
    """Deliveries to one node: those that have arrived, those that are delayed, and those it is to hear now.

    Attributes:
        arrived: in the order of sending, which is that of their arrival; the bus appends to it.
        due: what the node hears next, in order; it takes them from the left.
    """

    __slots__ = ("_delayed", "_sent", "arrived", "due")

    def __init__(self) -> None:
        self.arrived: Deque[Delivery] = deque()
        self.due: Deque[Delivery] = deque()
        self._delayed: List[Tuple[float, int, Delivery]] = []
        self._sent = 0

    def delay(self, delivery: Delivery) -> None:
        """Take in a message that arrives later than now."""
        heapq.heappush(self._delayed, (delivery[0], self._sent, delivery))
        self._sent += 1

    def collect(self, now: float) -> bool:
        """Make due what has arrived by order of arrival, then of sending.

        Args:
            now: the time [s]; nothing in ``arrived`` is later.

        Returns:
            True if anything is due.
        """
        if self._delayed and self._delayed[0][0] <= now:
            late: List[Delivery] = []
            while self._delayed and self._delayed[0][0] <= now:
                late.append(heapq.heappop(self._delayed)[2])
            # What was delayed was sent before whatever arrived at its moment without delay.
            self.due.extend(sorted([*late, *self.arrived], key=_arrival))
            self.arrived.clear()
        elif not self.due:
            self.due, self.arrived = self.arrived, self.due
        elif self.arrived:
            self.due.extend(self.arrived)
            self.arrived.clear()
        return bool(self.due)

    def discard(self) -> None:
        """Forget everything."""
        self.arrived.clear()
        self.due.clear()
        self._delayed.clear()
