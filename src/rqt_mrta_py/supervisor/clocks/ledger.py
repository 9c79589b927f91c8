"""The ledger of one connection: receipts and stamps of its messages, in bounded memory."""

from __future__ import annotations

import re
from array import array
from typing import Any, List, Optional, Tuple

import numpy as np
from numpy.typing import NDArray

from rqt_mrta_py.hooks import Connection
from rqt_mrta_py.model.timing import ConnectionTiming, Gap, SenderClock
from rqt_mrta_py.supervisor.clocks.estimate import median_deviation, quantile, robust_line
from rqt_mrta_py.supervisor.clocks.samples import LongestTimes, PromptWindows, Samples

__all__ = ["Ledger", "begins_with_header"]

_NS = 1_000_000_000
_PIECE = 2048
"""So many messages are looked at together."""
_STAMP = slice(4, 12)
"""Where the stamp stands in a message that begins with a header: behind its number [bytes]."""
_NO_STAMP = bytes(8)
_REGULAR = 10
_MISSED = 3
_SHOWN = 10
_HEADER = re.compile(r"(?:std_msgs/)?Header\s+[A-Za-z]\w*\s*(?:#.*)?\Z")


def begins_with_header(definition: str) -> bool:
    """Tell whether messages of a definition begin with a ``std_msgs/Header``, as ROS has it where there is one."""
    for line in definition.splitlines():
        text = line.strip()
        # Constants take no bytes.
        if text and not text.startswith("#") and "=" not in text.partition("#")[0]:
            return _HEADER.match(text) is not None
    return False


class Ledger:
    """Keeps what is needed to tell a connection's timing.

    Args:
        connection: whose messages will come.
    """

    def __init__(self, connection: Connection) -> None:
        self.connection = connection
        self._stamped = begins_with_header(connection.definition)
        self._receipts = array("q")
        self._stamps = bytearray()
        # Receipts and halves of stamps that nobody has looked at, and how many they are.
        self._waiting: List[Tuple[NDArray[np.int64], NDArray[np.uint32]]] = []
        self._count = 0
        self._messages = 0
        self._first = self._last = 0
        self._times = Samples(1)
        self._longest = LongestTimes()
        self._leads = Samples(2)
        self._prompt = PromptWindows()
        self._with_stamp = self._ahead = 0
        self._span = (0, 0)
        self._at_least = 0

    def take(self, receipt_ns: int, raw: bytes) -> None:
        """Take in one message; receipts do not decrease [ns]."""
        self._receipts.append(receipt_ns)
        if self._stamped:
            self._stamps += raw[_STAMP] if len(raw) >= _STAMP.stop else _NO_STAMP
        if len(self._receipts) == _PIECE:
            self._put_down()

    def take_together(
        self, receipts: NDArray[np.int64], content: bytes, begins: NDArray[np.int64], ends: NDArray[np.int64]
    ) -> None:
        """Take in messages column by column.

        Args:
            receipts: in order, shape (messages,) [ns].
            content: bytes, among them those of the messages.
            begins: where each begins in the content, shape (messages,) [bytes].
            ends: where each ends, shape (messages,) [bytes].
        """
        self._put_down()
        stamps = np.zeros((len(receipts) if self._stamped else 0, 2), np.uint32)
        if self._stamped:
            long_enough = ends - begins >= _STAMP.stop
            if long_enough.any():
                # One window begins at each byte, and is as long as a stamp.
                size = _STAMP.stop - _STAMP.start
                windows: NDArray[Any] = np.ndarray((len(content) - size + 1,), f"V{size}", content, strides=(1,))
                found = np.frombuffer(windows[begins[long_enough] + _STAMP.start].tobytes(), "<u4")
                stamps[long_enough] = found.reshape(-1, 2)
        self._wait(receipts, stamps)

    def timing(self, robot: str) -> Optional[ConnectionTiming]:
        """Sum up; None if there was no message.

        Args:
            robot: whose connection it is; empty if no robot's.
        """
        self._put_down()
        self._look()
        if not self._messages:
            return None
        times = self._times.rows[:, 0] / _NS
        length = (self._last - self._first) / _NS
        period = float(np.median(times)) if len(times) else None
        jitter = median_deviation(times) if len(times) else None
        gaps = self._gaps(period, jitter)
        shown = None if gaps is None else gaps[:_SHOWN]
        return ConnectionTiming(
            topic=self.connection.topic,
            type=self.connection.type,
            caller=self.connection.caller,
            robot=robot,
            messages=self._messages,
            start=self._first / _NS,
            end=self._last / _NS,
            rate=(self._messages - 1) / length if length > 0.0 else None,
            period=period,
            jitter=jitter,
            gaps=None if gaps is None else len(gaps),
            longest_gaps=()
            if shown is None
            else tuple(sorted(Gap(int(start) / _NS, int(start + long) / _NS) for long, start in shown)),
            longest=int(self._longest.rows[0, 0]) / _NS if len(times) else None,
            clock=self._clock(),
        )

    def _gaps(self, period: Optional[float], jitter: Optional[float]) -> Optional[NDArray[np.int64]]:
        """Give the gaps of regular messages, the longest first."""
        if period is None or jitter is None or self._messages < _REGULAR or jitter > period / 4.0 or period <= 0.0:
            return None
        rows = self._longest.rows
        return rows[rows[:, 0] > _MISSED * period * _NS]

    def _clock(self) -> Optional[SenderClock]:
        if not self._with_stamp:
            return None
        first, last = self._span
        prompt, leads = self._prompt.rows, self._leads.rows
        # Counted from the first: nanoseconds of this century are more than a float tells apart.
        middle = (last - first) / 2.0
        line = robust_line((prompt[:, 0] - first).astype(np.float64), prompt[:, 1].astype(np.float64), middle)
        delays = line.at((leads[:, 0] - first).astype(np.float64)) - leads[:, 1]
        return SenderClock(
            stamped=self._with_stamp,
            offset=line.value / _NS,
            drift=line.slope,
            at_least=self._at_least / _NS,
            ahead=self._ahead,
            delay_median=max(quantile(delays, 0.5), 0.0) / _NS,
            delay_high=max(quantile(delays, 0.95), 0.0) / _NS,
        )

    def _put_down(self) -> None:
        """Lay what came one by one to what came together."""
        if self._receipts:
            receipts = np.array(self._receipts, np.int64)
            stamps = np.frombuffer(bytes(self._stamps), "<u4").reshape(-1, 2)
            del self._receipts[:]
            self._stamps.clear()
            self._wait(receipts, stamps)

    def _wait(self, receipts: NDArray[np.int64], stamps: NDArray[np.uint32]) -> None:
        self._waiting.append((receipts, stamps))
        self._count += len(receipts)
        if self._count >= _PIECE:
            self._look()

    def _look(self) -> None:
        """Look at what has come since the last look."""
        if not self._count:
            return
        receipts = np.concatenate([each for each, _ in self._waiting])
        stamps = np.concatenate([each for _, each in self._waiting]).astype(np.int64)
        self._waiting.clear()
        self._count = 0
        before = receipts[:1] if not self._messages else np.array([self._last], np.int64)
        if not self._messages:
            self._first = int(receipts[0])
        starts = np.concatenate([before, receipts[:-1]])
        times = np.column_stack([receipts - starts, starts])[0 if self._messages else 1 :]
        self._times.add(times[:, :1])
        self._longest.add(times)
        self._messages += len(receipts)
        self._last = int(receipts[-1])
        if self._stamped:
            self._look_at_stamps(receipts, stamps[:, 0] * _NS + stamps[:, 1])

    def _look_at_stamps(self, receipts: NDArray[np.int64], stamps: NDArray[np.int64]) -> None:
        # A stamp of 0 is one that nobody set.
        receipts, stamps = receipts[stamps != 0], stamps[stamps != 0]
        if not len(stamps):
            return
        leads = stamps - receipts
        rows = np.column_stack([receipts, leads])
        self._leads.add(rows)
        self._prompt.add(rows)
        highest = int(leads.max())
        first = self._span[0] if self._with_stamp else int(receipts[0])
        self._span = first, int(receipts[-1])
        self._at_least = max(highest, self._at_least) if self._with_stamp else highest
        self._with_stamp += len(stamps)
        self._ahead += int((leads > 0).sum())
