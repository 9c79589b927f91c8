"""Times of receipt of a live stream: ROS time, but never back."""

from __future__ import annotations

from typing import Callable, Sequence

from rqt_mrta_py.hooks import Stamped

__all__ = ["StreamClock"]

_NS = 1_000_000_000


class StreamClock:
    """Gives times of receipt that never go back, whatever ROS time does.

    After ROS time went back, the stream goes on from its newest receipt, as fast as ROS time does.

    Attributes:
        newest: latest receipt given [ns].
        jumps: how often ROS time went back.

    Args:
        now: gives ROS time [s].
    """

    def __init__(self, now: Callable[[], float]) -> None:
        self._now = now
        self._offset = 0
        self.newest = 0
        self.jumps = 0

    @property
    def runs(self) -> bool:
        """Whether there is a time at all: a simulated clock that has not begun to run tells none."""
        return self.newest > 0 or self._now() > 0.0

    def look(self) -> int:
        """Give the time without taking note of it: messages may still be stamped that came before it [ns]."""
        # Float seconds of this century tell a quarter of a microsecond; simulated ones tell nanoseconds.
        return max(self.newest, round(self._now() * _NS) + self._offset)

    def receipt(self) -> int:
        """Give the time of a message that arrives now; those before it have been stamped [ns]."""
        at = round(self._now() * _NS) + self._offset
        if at > self.newest:  # noqa: PLR1730 - each message comes by here, and max takes three times as long
            self.newest = at
        return self.newest

    def stamped(self, messages: Sequence[Stamped]) -> Sequence[Stamped]:
        """Give messages their times of receipt.

        Args:
            messages: as received by ROS time, in the order of receipt; before a jump is told, all from before it.
        """
        if not self._offset and messages[0].receipt_ns >= self.newest:
            self.newest = messages[-1].receipt_ns
            return messages
        return [self._stamped(stamped) for stamped in messages]

    def _stamped(self, stamped: Stamped) -> Stamped:
        at = stamped.receipt_ns + self._offset
        if at < self.newest:
            at = self.newest
        else:
            self.newest = at
        return stamped if at == stamped.receipt_ns else stamped._replace(receipt_ns=at)

    def jump(self, after: float) -> None:
        """Take note that ROS time went back.

        Args:
            after: what it is now [s].
        """
        self._offset = self.newest - round(after * _NS)
        self.jumps += 1
