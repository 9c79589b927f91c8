"""Chunks of a bag: the records of some messages, and where each connection's messages stand among them.

A chunk holds thousands of small messages, so it is made column by column, and row by row where they are equally long.
"""

from __future__ import annotations

from typing import Any, List, NamedTuple, Sequence, Tuple

import numpy as np
from numpy.typing import NDArray

from rqt_mrta_py.transport.bags.headers import INDEX_HEADERS, MESSAGE_HEADERS
from rqt_mrta_py.transport.bags.pending import Pending
from rqt_mrta_py.transport.bags.windows import put

__all__ = ["Chunk", "build_chunk"]

_ENTRY = np.dtype([("seconds", "<u4"), ("nanoseconds", "<u4"), ("offset", "<u4")])
"""An entry of an index: when a message was received, and where its record begins in the chunk."""

_WHOLE_ENTRY = np.dtype(f"V{_ENTRY.itemsize}")


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

    body: memoryview
    indexes: memoryview
    start_ns: int
    end_ns: int
    counts: bytes
    described: int


def build_chunk(pending: Pending, descriptions: Sequence[bytes], described: int) -> Chunk:
    """Put messages into a chunk.

    Args:
        pending: at least one message; a connection that no chunk describes yet has a single one before any in a block.
        descriptions: the records that describe the connections, by number.
        described: how many of them stand in earlier chunks.
    """
    numbers, receipts, sizes, singles, raws = pending.columns()
    seconds, nanoseconds = np.divmod(receipts, 1_000_000_000)
    # Two parts are a single message; its header is put in with all the others.
    parts = [MESSAGE_HEADERS.sample] * (2 * len(raws))
    parts[1::2] = raws
    lengths = sizes + MESSAGE_HEADERS.length
    ends = np.cumsum(lengths)
    highest = int(numbers.max())
    if highest >= described:
        added = np.zeros(len(numbers), np.int64)
        added[singles] = _describe(numbers[singles], descriptions, described, parts)
        ends += np.cumsum(added)
    starts = ends - lengths

    body = _join_messages(pending, parts, starts, int(ends[-1]))
    columns = {"connection": numbers, "seconds": seconds, "nanoseconds": nanoseconds, "size": sizes}
    MESSAGE_HEADERS.put(body, starts, columns)

    entries = np.empty(len(numbers), _ENTRY)
    entries["seconds"], entries["nanoseconds"], entries["offset"] = seconds, nanoseconds, starts
    indexes, counts = _build_indexes(numbers, entries)
    return Chunk(body.data, indexes, int(receipts.min()), int(receipts.max()), counts, max(described, highest + 1))


def _describe(
    numbers: NDArray[np.int64], descriptions: Sequence[bytes], described: int, parts: List[bytes]
) -> NDArray[np.int64]:
    """Put each connection's description before its first message.

    Returns:
        What stands before each message [bytes].
    """
    known = np.maximum.accumulate(np.maximum(numbers + 1, described))
    before = np.concatenate(([described], known[:-1]))
    added = np.zeros(len(numbers), np.int64)
    for place in np.flatnonzero(known > before).tolist():
        text = b"".join(descriptions[before[place] : known[place]])
        parts[2 * place] = text + parts[2 * place]
        added[place] = len(text)
    return added


def _join_messages(pending: Pending, parts: Sequence[bytes], starts: NDArray[np.int64], size: int) -> NDArray[np.uint8]:
    """Put messages one after the other, those of a block behind room for their headers.

    Args:
        pending: the messages.
        parts: what to put for single ones, two parts each.
        starts: where the record of each message begins, shape (messages,).
        size: of all records [bytes].
    """
    if not pending.blocks:
        return np.frombuffer(bytearray().join(parts), np.uint8)
    length = MESSAGE_HEADERS.length
    body = np.empty(size, np.uint8)
    single = position = 0
    for before, upto, numbers, _, content in pending.blocks:
        start = int(starts[before])
        body.data[position:start] = b"".join(parts[2 * single : 2 * upto])
        stride = length + content.itemsize
        rows: NDArray[np.void] = np.ndarray(content.shape, content.dtype, body, start + length, (stride,))
        rows[...] = content
        single, position = upto, start + len(numbers) * stride
    body.data[position:] = b"".join(parts[2 * single :])
    return body


def _build_indexes(numbers: NDArray[np.int64], entries: NDArray[Any]) -> Tuple[memoryview, bytes]:
    """Give the records of the indexes, and each connection with the number of its entries."""
    totals = np.bincount(numbers)
    found = np.flatnonzero(totals)
    counts = totals[found]
    # NumPy sorts short integers in linear time.
    order = np.argsort(numbers.astype(np.min_scalar_type(len(totals))), kind="stable")
    sizes = counts * _ENTRY.itemsize
    lengths = sizes + INDEX_HEADERS.length
    ends = np.cumsum(lengths)
    indexes = np.empty(int(ends[-1]), np.uint8)
    INDEX_HEADERS.put(indexes, ends - lengths, {"connection": found, "count": counts, "size": sizes})
    # An entry stands behind those before it, and behind the headers of its connection and of those before that.
    headers = np.arange(1, len(found) + 1) * INDEX_HEADERS.length
    places = np.arange(len(order)) * _ENTRY.itemsize + np.repeat(headers, counts)
    put(indexes, places, entries.take(order).view(_WHOLE_ENTRY))
    pairs = np.empty((len(found), 2), "<u4")
    pairs[:, 0], pairs[:, 1] = found, counts
    return indexes.data, pairs.tobytes()
