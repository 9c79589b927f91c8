"""What is on its way to one hearer of the embedded bus: a node, or a team that hears together."""

from __future__ import annotations

import heapq
from collections import deque
from operator import itemgetter
from typing import Any, Deque, Dict, List, Mapping, NamedTuple, Optional, Tuple

from rqt_mrta_py.hooks import Connection, FieldReader

__all__ = ["Delivery", "Hearing", "Inbox", "Message", "Read"]


class Hearing(NamedTuple):
    """A subscription that a topic's messages suit.

    Attributes:
        hearer: who hears: a callback that takes a Heard; in a team that hears together, the row of the node.
        robot: what ``@robot_id@`` stands for in the topic.
        task: what ``@task_id@`` stands for.
        paths: of the fields asked for.
        reader: of these fields; None if there are none.
    """

    hearer: Any
    robot: str
    task: str
    paths: Tuple[str, ...]
    reader: Optional[FieldReader]


Read = Dict[Tuple[str, ...], Mapping[str, Any]]
"""What has been read of a message, by the paths that were asked for."""

Message = Tuple[Connection, int, bytes, Read]
"""A message under way: how it comes, its ordinal, its bytes, and what has been read of them, whoever hears it.

A plain tuple, for there are tens of thousands a second.
"""

Delivery = Tuple[float, Message, Tuple[Hearing, ...]]
"""When a message arrives [s], the message, and the subscriptions that mean it, all of one node."""

_arrival = itemgetter(0)


class Inbox:
    """Deliveries to one hearer: those that have arrived, those that are delayed, and those it is to hear now.

    Attributes:
        arrived: in the order of sending, which is that of their arrival; the bus appends to it.
        delayed: by arrival, then in the order of sending, as ``heapq`` has it.
        due: what the hearer hears next, in order; it takes them from the left.
    """

    __slots__ = ("_sent", "arrived", "delayed", "due")

    def __init__(self) -> None:
        self.arrived: Deque[Delivery] = deque()
        self.due: Deque[Delivery] = deque()
        self.delayed: List[Tuple[float, int, Delivery]] = []
        self._sent = 0

    def delay(self, delivery: Delivery) -> None:
        """Take in a message that arrives later than now."""
        heapq.heappush(self.delayed, (delivery[0], self._sent, delivery))
        self._sent += 1

    def collect(self, now: float) -> bool:
        """Make due what has arrived by order of arrival, then of sending.

        Args:
            now: the time [s]; nothing in ``arrived`` is later.

        Returns:
            True if anything is due.
        """
        if self.delayed and self.delayed[0][0] <= now:
            late: List[Delivery] = []
            while self.delayed and self.delayed[0][0] <= now:
                late.append(heapq.heappop(self.delayed)[2])
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
        self.delayed.clear()

    def discard_row(self, row: int) -> None:
        """Forget what is on its way to one node of a team."""
        self.arrived = deque(delivery for delivery in self.arrived if delivery[2][0].hearer != row)
        self.due = deque(delivery for delivery in self.due if delivery[2][0].hearer != row)
        self.delayed = [item for item in self.delayed if item[2][2][0].hearer != row]
        heapq.heapify(self.delayed)
