"""What a rule waits for: deadlines by key, each put off or dropped cheaply."""

from __future__ import annotations

import math
from heapq import heappop, heappush
from typing import Dict, Generic, List, Tuple, TypeVar

from rqt_mrta_py.hooks import IncidentBoard

__all__ = ["Deadlines"]

_Key = TypeVar("_Key")

_SOON = 1e-6
"""What falls due while a rule is woken does so this much later [s]; stamps of this century still tell it apart."""


class Deadlines(Generic[_Key]):
    """Deadlines of one rule, which is woken for the first of them only."""

    def __init__(self) -> None:
        self._due: Dict[_Key, float] = {}
        self._heap: List[Tuple[float, int, _Key]] = []
        self._count = 0
        self._armed = math.inf
        self._now = -math.inf

    def put(self, key: _Key, due: float, board: IncidentBoard) -> None:
        """Set a deadline [s], instead of one of the same key."""
        due = round(due, 9)
        if due <= self._now:
            due = self._now + _SOON
        self._due[key] = due
        self._count += 1
        heappush(self._heap, (due, self._count, key))
        self.arm(board)

    def drop(self, key: _Key) -> None:
        """Forget a deadline; nothing happens if there is none."""
        self._due.pop(key, None)

    def take(self, time: float) -> List[_Key]:
        """Take out what has fallen due by a time [s], first come first; ``arm`` is to be called after it."""
        self._now = max(self._now, time)
        if self._armed <= time:
            self._armed = math.inf
        taken = []
        while self._heap and self._heap[0][0] <= time:
            due, _, key = heappop(self._heap)
            if self._due.get(key) == due:
                del self._due[key]
                taken.append(key)
        return taken

    def arm(self, board: IncidentBoard) -> None:
        """Ask to be woken for the first deadline."""
        heap = self._heap
        while heap and self._due.get(heap[0][2]) != heap[0][0]:
            heappop(heap)
        if heap and heap[0][0] < self._armed:
            self._armed = heap[0][0]
            board.wake_at(self._armed)
