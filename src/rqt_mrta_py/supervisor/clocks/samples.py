"""What is kept of any number of messages in bounded memory, the same whatever pieces they come in."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from rqt_mrta_py.supervisor.clocks.estimate import promptest

__all__ = ["LongestTimes", "PromptWindows", "Samples"]

_Whole = NDArray[np.int64]


class Samples:
    """Every message's values as long as there are few; every second, fourth ... one when there are many.

    Args:
        columns: values of each message.
        most: how many messages are kept; even.
    """

    def __init__(self, columns: int, most: int = 2048) -> None:
        self._most = most
        self._stride = 1
        self._seen = 0
        self._kept: _Whole = np.empty((0, columns), np.int64)

    @property
    def rows(self) -> _Whole:
        """Those that are kept, in order, shape (messages, columns)."""
        return self._kept

    def add(self, rows: _Whole) -> None:
        """Take in messages, shape (messages, columns)."""
        start = -self._seen % self._stride
        self._seen += len(rows)
        self._kept = np.concatenate([self._kept, rows[start :: self._stride]])
        while len(self._kept) > self._most:
            self._kept = self._kept[::2]
            self._stride *= 2


class PromptWindows:
    """The promptest message of each of a number of windows of time, equally long, which grow with the stream.

    Args:
        most: how many windows; even.
        width_ns: how long one is at first [ns].
    """

    def __init__(self, most: int = 64, width_ns: int = 1_000_000_000) -> None:
        self._most = most
        self._width = width_ns
        self._start = 0
        self._rows: _Whole = np.empty((0, 2), np.int64)

    @property
    def rows(self) -> _Whole:
        """Receipt and lead of each, by receipt, shape (windows, 2) [ns]."""
        return self._rows

    def add(self, rows: _Whole) -> None:
        """Take in messages.

        Args:
            rows: receipt and lead of each, shape (messages, 2) [ns].
        """
        if not len(rows):
            return
        if not len(self._rows):
            self._start = int(rows[0, 0])
        together = np.concatenate([self._rows, rows])
        since = np.maximum(together[:, 0] - self._start, 0)
        while int(since.max()) // self._width >= self._most:
            self._width *= 2
        self._rows = together[promptest(since // self._width, together[:, 1])]


class LongestTimes:
    """The longest times between two messages.

    Args:
        most: how many.
    """

    def __init__(self, most: int = 100) -> None:
        self._most = most
        self._rows: _Whole = np.empty((0, 2), np.int64)

    @property
    def rows(self) -> _Whole:
        """Length and start of each, the longest first, of equal ones the earlier, shape (times, 2) [ns]."""
        return self._rows

    def add(self, rows: _Whole) -> None:
        """Take in times, in order; length and start of each, shape (times, 2) [ns]."""
        together = np.concatenate([self._rows, rows])
        self._rows = together[np.argsort(-together[:, 0], kind="stable")[: self._most]]
