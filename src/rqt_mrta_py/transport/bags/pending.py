"""What waits for its chunk of a bag: messages one by one, and blocks of messages that are alike."""

from __future__ import annotations

from operator import itemgetter
from typing import List, NamedTuple, Tuple, Union

import numpy as np
from numpy.typing import NDArray

__all__ = ["Block", "Columns", "Pending", "Single"]

Single = Tuple[int, int, bytes]
"""A message: number of its connection, receipt [ns], bytes."""

_number, _receipt, _raw = itemgetter(0), itemgetter(1), itemgetter(2)


class Block(NamedTuple):
    """Neighbours that are equally long and were received at one moment.

    Attributes:
        before: how many messages of the chunk come before them.
        singles_before: how many of these stand in no block.
        numbers: of their connections, shape (messages,).
        receipt_ns: when they were received [ns].
        content: their bytes, shape (messages,), of a void type as long as each.
    """

    before: int
    singles_before: int
    numbers: NDArray[np.int64]
    receipt_ns: int
    content: NDArray[np.void]


class Columns(NamedTuple):
    """Messages column by column, in their order.

    Attributes:
        numbers: of their connections, shape (messages,).
        receipts: when they were received, shape (messages,) [ns].
        sizes: of each, shape (messages,) [bytes].
        singles: selects those that stand in no block.
        raws: the bytes of those.
    """

    numbers: NDArray[np.int64]
    receipts: NDArray[np.int64]
    sizes: NDArray[np.int64]
    singles: Union[slice, NDArray[np.bool_]]
    raws: List[bytes]


class Pending:
    """Messages in the order of writing; as many as its length.

    Attributes:
        singles: those that stand in no block, in their order; more may be appended.
        blocks: the others, in their order.
    """

    __slots__ = ("blocks", "singles")

    def __init__(self) -> None:
        self.singles: List[Single] = []
        self.blocks: List[Block] = []

    def __len__(self) -> int:
        count = len(self.singles)
        if self.blocks:
            last = self.blocks[-1]
            count += last.before - last.singles_before + len(last.numbers)
        return count

    def append_block(self, numbers: NDArray[np.int64], receipt_ns: int, content: NDArray[np.void]) -> None:
        """Let messages wait behind the others.

        Args:
            numbers: see Block.
            receipt_ns: see Block.
            content: see Block.
        """
        self.blocks.append(Block(len(self), len(self.singles), numbers, receipt_ns, content))

    def columns(self) -> Columns:
        """Look at all of them."""
        count = len(self)
        numbers, receipts, sizes = np.empty((3, count), np.int64)
        singles: Union[slice, NDArray[np.bool_]] = slice(None)
        if self.blocks:
            singles = np.ones(count, np.bool_)
            for before, _, of_block, receipt_ns, content in self.blocks:
                its = slice(before, before + len(of_block))
                numbers[its], receipts[its], sizes[its], singles[its] = of_block, receipt_ns, content.itemsize, False
        raws = list(map(_raw, self.singles))
        for column, values in (
            (numbers, map(_number, self.singles)),
            (receipts, map(_receipt, self.singles)),
            (sizes, map(len, raws)),
        ):
            column[singles] = np.fromiter(values, np.int64, len(raws))
        return Columns(numbers, receipts, sizes, singles, raws)
