"""What falls due when: a queue whose entries may be put off cheaply."""

from __future__ import annotations

import math
from enum import IntEnum
from heapq import heappop, heappush
from typing import Dict, List, Tuple

__all__ = ["Agenda", "Due", "Entry", "due_after", "whole_nanoseconds"]


class Due(IntEnum):
    """Kinds of things that fall due, in the order in which they are taken at one time."""

    SILENCE = 0
    ALLOCATION = 1
    ROBOT_STATE = 2


Entry = Tuple[Due, str, str]
"""What falls due: the kind, the robot or an empty text, the task or an empty text."""


def whole_nanoseconds(time: float) -> float:
    """Round a sum of times to what stamps can say [s]: a message stamped exactly then must compare equal."""
    return round(time, 9)


def due_after(time: float, timeout: float) -> float:
    """Say when a timeout falls due.

    Args:
        time: when it began [s].
        timeout: [s].

    Returns:
        The sum in whole nanoseconds [s].
    """
    return whole_nanoseconds(time + timeout)


class Agenda:
    """Entries by due time, then kind, then the order number that they were put with.

    An entry that is put off is left where it is: whoever takes it looks at the true due time and puts it back.
    """

    def __init__(self) -> None:
        self._heap: List[Tuple[float, Due, int, Entry]] = []
        self._earliest: Dict[Entry, float] = {}
        self.next = math.inf

    def put(self, due: float, order: int, entry: Entry) -> None:
        """Ask for an entry at its due time, unless it is in the queue for that time or earlier.

        Args:
            due: [s].
            order: decides between entries of one kind and one due time.
            entry: what falls due.
        """
        if due < self._earliest.get(entry, math.inf):
            self._earliest[entry] = due
            heappush(self._heap, (due, entry[0], order, entry))
            self.next = self._heap[0][0]

    def take(self) -> Tuple[float, Entry]:
        """Take the first entry out of the queue.

        Returns:
            The time it stood at, which is no later than its true due time [s], and the entry.
        """
        due, _, _, entry = heappop(self._heap)
        if self._earliest.get(entry) == due:
            del self._earliest[entry]
        self.next = self._heap[0][0] if self._heap else math.inf
        return due, entry

    @property
    def first(self) -> Entry:
        """Give the entry that stands first; there must be one."""
        return self._heap[0][3]

    def put_off(self, due: float) -> None:
        """Let the entry that stands first stand at another time [s], which is its true due time."""
        order = self._heap[0][2]
        _, entry = self.take()
        self.put(due, order, entry)

    def fork(self) -> Agenda:
        """Copy the queue, so that the copy can go on by itself."""
        twin = Agenda()
        twin._heap = list(self._heap)
        twin._earliest = dict(self._earliest)
        twin.next = self.next
        return twin
