"""The last seconds of a stream, bounded in time and in bytes, for bags of what happened just now."""

from __future__ import annotations

from collections import deque
from typing import Deque, Dict, List, Optional, Sequence

from rqt_mrta_py.hooks import Connection, Stamped

__all__ = ["MESSAGE_BYTES", "RingBuffer"]

MESSAGE_BYTES = 200
"""What a message takes in memory besides its own bytes, roughly [bytes]."""

_MOST_LATCHED = 256
"""How many connections are remembered whose last message late subscribers get."""


class RingBuffer:
    """Keeps messages until they are too old, or too many.

    Attributes:
        dropped: how many messages went before their time, for want of room.
        size: what the messages take that are kept [bytes].

    Args:
        seconds: how far back it reaches, by receipt [s].
        most_bytes: what it may take [bytes].
    """

    def __init__(self, seconds: float, most_bytes: int) -> None:
        self._span_ns = round(seconds * 1e9)
        self._most = most_bytes
        self._kept: Deque[Stamped] = deque()
        self._latched: Dict[Connection, Stamped] = {}
        self.size = 0
        self.dropped = 0

    def __len__(self) -> int:
        return len(self._kept)

    def extend(self, messages: Sequence[Stamped]) -> None:
        """Take in the next messages; no receipt is before that of the message before."""
        if not messages:
            return
        kept, size = self._kept, self.size
        kept.extend(messages)
        for stamped in messages:
            size += len(stamped[2]) + MESSAGE_BYTES
            if stamped[0].latched:
                self._latch(stamped)
        oldest = messages[-1].receipt_ns - self._span_ns
        while kept[0][1] < oldest:
            size -= len(kept.popleft()[2]) + MESSAGE_BYTES
        while size > self._most:
            size -= len(kept.popleft()[2]) + MESSAGE_BYTES
            self.dropped += 1
        self.size = size

    def last(self, seconds: Optional[float] = None) -> List[Stamped]:
        """Give what was received in the last seconds before the newest message, in order.

        Args:
            seconds: how far back [s]; None: all that is kept.

        Returns:
            The messages. Before them, as received with the first, stand latched messages of before, which late
            subscribers would have got: they say what the others are about.
        """
        if not self._kept:
            return []
        newest = self._kept[-1].receipt_ns
        since = self._kept[0].receipt_ns if seconds is None else newest - round(seconds * 1e9)
        messages = [stamped for stamped in self._kept if stamped.receipt_ns >= since]
        start = messages[0].receipt_ns
        there = {stamped.connection for stamped in messages}
        before = [stamped for connection, stamped in self._latched.items() if connection not in there]
        return [*(stamped._replace(receipt_ns=start) for stamped in before), *messages]

    def _latch(self, stamped: Stamped) -> None:
        self._latched.pop(stamped.connection, None)
        if len(self._latched) >= _MOST_LATCHED:
            del self._latched[next(iter(self._latched))]
        self._latched[stamped.connection] = stamped
