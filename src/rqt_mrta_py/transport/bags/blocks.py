"""Blocks: some hundred or thousand messages of a bag, column by column, over bytes that nobody has copied yet."""

from __future__ import annotations

from dataclasses import dataclass
from itertools import repeat
from typing import Any, Dict, Iterable, Iterator, List, Sequence

import numpy as np
from numpy.typing import NDArray

from rqt_mrta_py.hooks import Connection, Stamped

__all__ = ["Block", "ConnectionList", "joined", "ordered"]

_new_stamped: Any = tuple.__new__
"""Makes a Stamped without a call of Python code."""


class ConnectionList(List[Connection]):
    """Connections in the order in which they were met; equal ones have one number."""

    def __init__(self) -> None:
        super().__init__()
        self._numbers: Dict[Connection, int] = {}

    def number(self, connection: Connection) -> int:
        """Give the place of a connection, new or known."""
        number = self._numbers.setdefault(connection, len(self))
        if number == len(self):
            self.append(connection)
        return number


@dataclass(eq=False)
class Block:
    """Messages in their order; iterating gives each as a Stamped.

    Attributes:
        connections: by number; more may be appended.
        numbers: of each message's connection, shape (messages,).
        receipts: of each, shape (messages,) [ns].
        content: bytes, among them those of the messages.
        begins: where each begins in the content, shape (messages,) [bytes].
        ends: where each ends, shape (messages,) [bytes].
    """

    connections: Sequence[Connection]
    numbers: NDArray[np.int64]
    receipts: NDArray[np.int64]
    content: bytes
    begins: NDArray[np.int64]
    ends: NDArray[np.int64]

    @classmethod
    def of(cls, connections: ConnectionList, messages: Sequence[Stamped]) -> Block:
        """Lay messages side by side.

        Args:
            connections: to which theirs are added.
            messages: in order.
        """
        raws = [stamped.raw for stamped in messages]
        numbers = np.fromiter((connections.number(each.connection) for each in messages), np.int64, len(raws))
        receipts = np.fromiter((each.receipt_ns for each in messages), np.int64, len(raws))
        sizes = np.fromiter(map(len, raws), np.int64, len(raws))
        ends = np.cumsum(sizes)
        return cls(connections, numbers, receipts, b"".join(raws), ends - sizes, ends)

    def __len__(self) -> int:
        return len(self.numbers)

    def __iter__(self) -> Iterator[Stamped]:
        known = self.connections
        connections = [known[number] for number in self.numbers.tolist()]
        return map(_new_stamped, repeat(Stamped), zip(connections, self.receipts.tolist(), self._raws()))

    def __getitem__(self, place: int) -> Stamped:
        begin, end = int(self.begins[place]), int(self.ends[place])
        connection = self.connections[int(self.numbers[place])]
        return Stamped(connection, int(self.receipts[place]), self.content[begin:end])

    def part(self, rows: Any) -> Block:
        """Give some of the messages, over the same bytes.

        Args:
            rows: a slice, or what else selects elements of an array.
        """
        return Block(
            self.connections, self.numbers[rows], self.receipts[rows], self.content, self.begins[rows], self.ends[rows]
        )

    def _raws(self) -> Iterator[bytes]:
        content = self.content
        return (content[begin:end] for begin, end in zip(self.begins.tolist(), self.ends.tolist()))


def joined(blocks: Sequence[Block]) -> Block:
    """Put blocks over the same connections one behind the other.

    Args:
        blocks: at least one; of large ones that are parts, only the bytes in use are copied.
    """
    if len(blocks) == 1:
        return blocks[0]
    contents: List[bytes] = []
    begins: List[NDArray[np.int64]] = []
    ends: List[NDArray[np.int64]] = []
    place = 0
    for block in blocks:
        if not len(block):
            continue
        first, last = int(block.begins.min()), int(block.ends.max())
        contents.append(block.content[first:last])
        begins.append(block.begins + (place - first))
        ends.append(block.ends + (place - first))
        place += last - first
    if not contents:
        return blocks[0]
    return Block(
        blocks[0].connections,
        np.concatenate([block.numbers for block in blocks]),
        np.concatenate([block.receipts for block in blocks]),
        b"".join(contents),
        np.concatenate(begins),
        np.concatenate(ends),
    )


def ordered(blocks: Iterable[Block]) -> Block:
    """Join blocks by time of receipt; equal times keep the order of the blocks, and that within each."""
    block = joined(list(blocks))
    steps = np.diff(block.receipts)
    if len(steps) and steps.min() < 0:
        return block.part(np.argsort(block.receipts, kind="stable"))
    return block
