"""Batches: messages of one moment, column by column.

A team of a thousand robots says tens of thousands of messages a second, a thousand at a time; what carries, records or
counts them looks at columns, and cuts out single messages only where somebody wants to read them.
"""

from __future__ import annotations

from itertools import groupby, repeat
from typing import Any, Iterator, NamedTuple, Optional, Sequence, Tuple

from rqt_mrta_py.hooks import Connection, Stamped

__all__ = ["Batch", "Run"]

_new_stamped: Any = tuple.__new__
"""Makes a Stamped of one row of the columns without a call of Python code."""


class Run(NamedTuple):
    """Neighbours among messages that are equally long.

    Attributes:
        messages: how many, at least one.
        size: of each [bytes].
    """

    messages: int
    size: int


class Batch:
    """Messages that were received at one moment, in their order; iterating gives each as a Stamped.

    Attributes:
        connections: of each message. Where the same nodes speak together again, it may be the same tuple again.
        receipt_ns: when they were received, on the stream's clock [ns].
        content: their bytes, one message after the other.
        runs: where one message ends in the content and the next begins, in order.

    Args:
        connections: see above.
        receipt_ns: see above.
        content: see above.
        runs: see above; they cover the content, and are as many messages as there are connections.
    """

    __slots__ = ("_raws", "connections", "content", "receipt_ns", "runs")

    def __init__(
        self, connections: Tuple[Connection, ...], receipt_ns: int, content: bytes, runs: Sequence[Run]
    ) -> None:
        self.connections = connections
        self.receipt_ns = receipt_ns
        self.content = content
        self.runs = runs
        self._raws: Optional[Sequence[bytes]] = None

    @classmethod
    def of(cls, connections: Tuple[Connection, ...], receipt_ns: int, raws: Sequence[bytes]) -> Batch:
        """Put messages together.

        Args:
            connections: of each message.
            receipt_ns: when they were received [ns].
            raws: their bytes, as many as connections.
        """
        runs = [Run(len(list(run)), size) for size, run in groupby(map(len, raws))]
        batch = cls(connections, receipt_ns, b"".join(raws), runs)
        batch._raws = raws
        return batch

    @property
    def raws(self) -> Sequence[bytes]:
        """The bytes of each message."""
        if self._raws is None:
            content, raws, start = self.content, [], 0
            for count, size in self.runs:
                end = start + count * size
                raws += [content[at : at + size] for at in range(start, end, size)] if size else [b""] * count
                start = end
            self._raws = raws
        return self._raws

    def __len__(self) -> int:
        return len(self.connections)

    def __iter__(self) -> Iterator[Stamped]:
        rows = zip(self.connections, repeat(self.receipt_ns), self.raws)
        return map(_new_stamped, repeat(Stamped), rows)
