"""Chunks of a bag: the records of some messages, and where each connection's messages stand among them.

A chunk holds thousands of small messages, so it is made column by column.
"""

from __future__ import annotations

from operator import itemgetter
from typing import Any, List, NamedTuple, Sequence, Tuple

import numpy as np
from numpy.typing import NDArray

from rqt_mrta_py.transport.bags.headers import INDEX_HEADERS, MESSAGE_HEADERS

__all__ = ["Chunk", "Pending", "build_chunk"]

Pending = Tuple[int, int, bytes]
"""A message that waits for its chunk: number of its connection, receipt [ns], bytes."""

_number, _receipt, _raw = itemgetter(0), itemgetter(1), itemgetter(2)

_ENTRY = np.dtype([("seconds", "<u4"), ("nanoseconds", "<u4"), ("offset", "<u4")])
"""An entry of an index: when a message was received, and where its record begins in the chunk."""


class Chunk(NamedTuple):
    """A chunk before it is compressed, with what the file says of it elsewhere.

    Attributes:
        body: records of connections and messages.
        indexes: the records that follow the chunk, by number of connection.
        start_ns: receipt of the earliest message [ns].
        end_ns: receipt of the latest message [ns].
        counts: number of each connection in it and of that connection's messages, in that order, 32 bits each.
        described: how many connections this chunk and those before it describe.
    """

    body: bytes
    indexes: bytes
    start_ns: int
    end_ns: int
    counts: bytes
    described: int


def build_chunk(messages: Sequence[Pending], descriptions: Sequence[bytes], described: int) -> Chunk:
    """Put messages into a chunk.

    Args:
        messages: in the order of writing; at least one.
        descriptions: the records that describe the connections, by number.
        described: how many of them stand in earlier chunks.
    """
    count = len(messages)
    numbers = np.fromiter(map(_number, messages), np.int64, count)
    receipts = np.fromiter(map(_receipt, messages), np.int64, count)
    raws = list(map(_raw, messages))
    sizes = np.fromiter(map(len, raws), np.int64, count)
    seconds, nanoseconds = np.divmod(receipts, 1_000_000_000)

    columns = {"connection": numbers, "seconds": seconds, "nanoseconds": nanoseconds, "size": sizes}
    parts = [b""] * (2 * count)
    parts[0::2] = MESSAGE_HEADERS.make(columns)
    parts[1::2] = raws

    lengths = sizes + MESSAGE_HEADERS.length
    offsets = np.cumsum(lengths) - lengths
    highest = int(numbers.max())
    if highest >= described:
        offsets += _describe(numbers, descriptions, described, parts)

    entries = np.empty(count, _ENTRY)
    entries["seconds"], entries["nanoseconds"], entries["offset"] = seconds, nanoseconds, offsets
    indexes, counts = _build_indexes(numbers, entries)
    return Chunk(
        b"".join(parts), indexes, int(receipts.min()), int(receipts.max()), counts, max(described, highest + 1)
    )


def _describe(
    numbers: NDArray[np.int64], descriptions: Sequence[bytes], described: int, parts: List[bytes]
) -> NDArray[np.int64]:
    """Put each connection's description before its first message; two parts are a message.

    Returns:
        By how much each message moves.
    """
    known = np.maximum.accumulate(np.maximum(numbers + 1, described))
    before = np.concatenate(([described], known[:-1]))
    added = np.zeros(len(numbers), np.int64)
    for place in np.flatnonzero(known > before).tolist():
        text = b"".join(descriptions[before[place] : known[place]])
        parts[2 * place] = text + parts[2 * place]
        added[place] = len(text)
    return np.cumsum(added)


def _build_indexes(numbers: NDArray[np.int64], entries: NDArray[Any]) -> Tuple[bytes, bytes]:
    """Give the records of the indexes, and each connection with the number of its entries."""
    totals = np.bincount(numbers)
    found = np.flatnonzero(totals)
    counts = totals[found]
    sizes = counts * _ENTRY.itemsize
    # NumPy sorts short integers in linear time.
    order = np.argsort(numbers.astype(np.min_scalar_type(len(totals))), kind="stable")
    content = entries.take(order).tobytes()
    bounds = [0, *np.cumsum(sizes).tolist()]
    parts = [b""] * (2 * len(found))
    parts[0::2] = INDEX_HEADERS.make({"connection": found, "count": counts, "size": sizes})
    parts[1::2] = [content[begin:end] for begin, end in zip(bounds, bounds[1:])]
    return b"".join(parts), np.stack((found, counts), axis=1).astype("<u4").tobytes()
