"""Several streams of blocks, each by time of receipt, as one."""

from __future__ import annotations

from typing import Iterable, Iterator, List, Optional

import numpy as np

from rqt_mrta_py.transport.bags.blocks import Block, ordered

__all__ = ["merged"]


def merged(streams: Iterable[Iterator[Block]]) -> Iterator[Block]:
    """Merge streams over the same connections by time of receipt.

    A block of each is held at most.

    Args:
        streams: each in order; of equal times those of the first stream come first.
    """
    heads = [_Head(stream) for stream in streams]
    while True:
        open_heads = [head for head in heads if head.fill()]
        if not open_heads:
            return
        # Up to where the first block ends everything is known.
        last = min(open_heads, key=lambda head: head.end).end
        parts: List[Block] = []
        behind = False
        for head in open_heads:
            parts.append(head.take(last, inclusive=not behind))
            # What the stream brings next may be of that very time, and come before those of later streams.
            behind = behind or (head.end == last and head.emptied)
        block = ordered(part for part in parts if len(part))
        if len(block):
            yield block


class _Head:
    """The first block of a stream, as far as it has not been taken."""

    def __init__(self, stream: Iterator[Block]) -> None:
        self._stream = stream
        self._rest: Optional[Block] = None
        self.end = 0

    @property
    def emptied(self) -> bool:
        return not self._rest

    def fill(self) -> bool:
        """Make sure that there is a block; tell whether there is."""
        while not self._rest:
            block = next(self._stream, None)
            if block is None:
                return False
            self._rest = block
            if len(block):
                self.end = int(block.receipts.max())
        return True

    def take(self, last: int, inclusive: bool) -> Block:
        """Take all messages up to a time [ns]; there must be a block."""
        block = self._rest
        if block is None:
            raise ValueError("there is no block to take from")
        upto = int(np.searchsorted(block.receipts, last, "right" if inclusive else "left"))
        self._rest = block.part(slice(upto, None))
        return block.part(slice(0, upto))
