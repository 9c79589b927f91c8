"""Chunks of a bag: the records of some messages, and where each connection's messages stand among them."""

from __future__ import annotations

import struct
from typing import Dict, List, NamedTuple, Sequence, Tuple

from rqt_mrta_py.transport.bags.records import MESSAGE_OVERHEAD, index_prefix, message_prefix, stamp

__all__ = ["Chunk", "Pending", "Target", "build_chunk"]

_u32 = struct.Struct("<I").pack
_two = struct.Struct("<II").pack


class Target(NamedTuple):
    """A connection as one bag knows it.

    Attributes:
        number: in the order of first messages, from 0.
        described: the record that describes it.
        message_prefix: of its messages.
        index_prefix: of its indexes.
    """

    number: int
    described: bytes
    message_prefix: bytes
    index_prefix: bytes

    @classmethod
    def of(cls, number: int, described: bytes) -> Target:
        """Make the target of a number and the record that describes its connection."""
        return cls(number, described, message_prefix(number), index_prefix(number))


Pending = Tuple[Target, int, bytes]
"""A message that waits for its chunk: target, receipt [ns], bytes."""


class Chunk(NamedTuple):
    """A chunk before it is compressed, with what the file says of it elsewhere.

    Attributes:
        body: records of connections and messages.
        indexes: the records that follow the chunk.
        start_ns: receipt of the earliest message [ns].
        end_ns: receipt of the latest message [ns].
        counts: number of each connection, and of its messages.
        described: how many connections this chunk and those before it describe.
    """

    body: bytes
    indexes: bytes
    start_ns: int
    end_ns: int
    counts: List[Tuple[int, int]]
    described: int


def build_chunk(messages: Sequence[Pending], targets: Sequence[Target], described: int) -> Chunk:
    """Put messages into a chunk.

    Args:
        messages: in the order of writing; at least one.
        targets: by number.
        described: how many of them stand in earlier chunks.
    """
    parts: List[bytes] = []
    entries: Dict[int, List[bytes]] = {}
    offset, last_ns, time = 0, -1, b""
    start_ns = end_ns = messages[0][1]
    for target, receipt_ns, raw in messages:
        number = target.number
        while number >= described:
            parts.append(targets[described].described)
            offset += len(parts[-1])
            described += 1
        if receipt_ns != last_ns:
            last_ns, time = receipt_ns, stamp(receipt_ns)
            start_ns, end_ns = min(start_ns, receipt_ns), max(end_ns, receipt_ns)
        entry = time + _u32(offset)
        known = entries.get(number)
        if known is None:
            entries[number] = [entry]
        else:
            known.append(entry)
        size = len(raw)
        parts.append(target.message_prefix + time + _u32(size))
        parts.append(raw)
        offset += MESSAGE_OVERHEAD + size
    indexes: List[bytes] = []
    for number, found in entries.items():
        indexes.append(targets[number].index_prefix + _two(len(found), 12 * len(found)))
        indexes.extend(found)
    counts = [(number, len(found)) for number, found in entries.items()]
    return Chunk(b"".join(parts), b"".join(indexes), start_ns, end_ns, counts, described)
