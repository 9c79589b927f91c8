"""ROS time: the wall's, or that of ``/clock``, which may go backwards."""

from __future__ import annotations

import struct
import time
from typing import Callable, Optional, Tuple

__all__ = ["CLOCK_TOPIC", "CLOCK_TYPE", "RosClock"]

CLOCK_TOPIC = "/clock"
CLOCK_TYPE = "rosgraph_msgs/Clock"

_read_time = struct.Struct("<II").unpack_from
_wall_ns = time.time_ns
_SECOND = 1_000_000_000


class RosClock:
    """Tells the time of one node; whoever asks holds the node's lock.

    Args:
        simulated: see below.
        tell: is told seconds and nanoseconds of each simulated time, from 0 on.

    Attributes:
        simulated: whether the time is that of ``/clock``; it is 0 until the first message.
    """

    def __init__(self, simulated: bool, tell: Callable[[int, int], None] = lambda seconds, nanoseconds: None) -> None:
        self.simulated = simulated
        self._tell = tell
        self._now = 0
        if simulated:
            tell(0, 0)

    def now(self) -> float:
        """Give the time [s]."""
        return (self._now if self.simulated else _wall_ns()) / _SECOND

    def receipt(self) -> int:
        """Give the time of a message that arrives now, never before that of the one before [ns]."""
        if not self.simulated:
            self._now = max(self._now, _wall_ns())
        return self._now

    def tick(self, raw: bytes) -> Optional[Tuple[float, float]]:
        """Take the time from a message of ``/clock``.

        Args:
            raw: the message; its first eight bytes are a time.

        Returns:
            The times before and after [s] if it went backwards; else None.

        Raises:
            struct.error: the message is too short.
        """
        seconds, nanoseconds = _read_time(raw)
        self._tell(seconds, nanoseconds)
        before, self._now = self._now, seconds * _SECOND + nanoseconds
        return (before / _SECOND, self._now / _SECOND) if self._now < before else None
