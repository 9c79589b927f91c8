"""Times of receipt of a live stream: ROS time, but never back."""

from __future__ import annotations

from typing import Callable

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

    def receipt(self) -> int:
        """Give the time of a message that arrives now [ns]."""
        # Float seconds of this century tell a quarter of a microsecond; simulated ones tell nanoseconds.
        at = round(self._now() * _NS) + self._offset
        if at > self.newest:  # noqa: PLR1730 - each message comes by here, and max takes three times as long
            self.newest = at
        return self.newest

    def jump(self, after: float) -> None:
        """Take note that ROS time went back.

        Args:
            after: what it is now [s].
        """
        self._offset = self.newest - round(after * _NS)
        self.jumps += 1
