"""Spans: how many messages came on each connection, and when the first and the last of them."""

from __future__ import annotations

from typing import Iterator, Optional, Sequence, Tuple

import numpy as np
from numpy.typing import NDArray

from rqt_mrta_py.hooks import Connection
from rqt_mrta_py.transport.bags.blocks import Block

__all__ = ["Spans"]


class Spans:
    """Counts blocks over the same connections; iterating gives (connection, messages, first, last), times in ns.

    Attributes:
        messages: how many there were.
        start_ns: receipt of the first [ns]; None if there was none.
        end_ns: receipt of the last [ns]; None if there was none.
    """

    def __init__(self) -> None:
        self.messages = 0
        self.start_ns: Optional[int] = None
        self.end_ns: Optional[int] = None
        self._connections: Sequence[Connection] = ()
        # By number of the connection: how many, the first, the last.
        self._columns: NDArray[np.int64] = np.zeros((3, 0), np.int64)

    def count(self, block: Block) -> None:
        """Take note of the messages of a block, which are in order."""
        if not len(block):
            return
        self._connections = block.connections
        missing = len(block.connections) - self._columns.shape[1]
        if missing:
            self._columns = np.concatenate([self._columns, np.zeros((3, missing), np.int64)], axis=1)
        counts, first, last = self._columns
        numbers, receipts = block.numbers, block.receipts
        fresh = counts[numbers] == 0
        # Of equal numbers the value that is assigned last stands.
        first[numbers[fresh][::-1]] = receipts[fresh][::-1]
        last[numbers] = receipts
        counts += np.bincount(numbers, minlength=len(counts))
        self.messages += len(block)
        start_ns, end_ns = int(receipts[0]), int(receipts[-1])
        self.start_ns = start_ns if self.start_ns is None else min(self.start_ns, start_ns)
        self.end_ns = end_ns if self.end_ns is None else max(self.end_ns, end_ns)

    def __iter__(self) -> Iterator[Tuple[Connection, int, int, int]]:
        for connection, (count, first, last) in zip(self._connections, self._columns.T.tolist()):
            if count:
                yield connection, count, first, last
