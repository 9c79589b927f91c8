"""What chunks of a whole bag hold, by the indexes that follow them.

Neighbours are read together, for many a recorder closes a chunk each second, with a few messages in it. Nothing is
believed that the chunks do not bear out.
"""

from __future__ import annotations

import struct
from typing import Any, BinaryIO, Dict, List, NamedTuple, Sequence, Tuple

import numpy as np
from numpy.typing import NDArray

from rqt_mrta_py.transport.bags.blocks import Block, ConnectionList
from rqt_mrta_py.transport.bags.compression import Compression, decompress
from rqt_mrta_py.transport.bags.index import ChunkPlace
from rqt_mrta_py.transport.bags.records import OP_CHUNK, OP_INDEX, OP_MESSAGE, parse_pairs

__all__ = ["LARGEST_CHUNK", "ChunkReader"]

LARGEST_CHUNK = 2**28
"""Chunks that claim more are not read in one piece [bytes]."""

_ENTRY = np.dtype([("seconds", "<u4"), ("nanoseconds", "<u4"), ("offset", "<u4")])
_MOST_HEADERS = 10_000
"""How many headers of indexes are remembered; those of one connection differ by the number of its messages alone."""

_u32 = struct.Struct("<I").unpack_from


class _Entries(NamedTuple):
    """Where messages stand, in the order of the indexes.

    Attributes:
        numbers: of their connections in the bag, shape (messages,).
        seconds, nanoseconds: when they were received, as the bag has it, each of shape (messages,).
        offsets: where their records begin in the content, shape (messages,) [bytes].
        limits: where the chunk of each ends there, shape (messages,) [bytes].
    """

    numbers: NDArray[np.int64]
    seconds: NDArray[np.int64]
    nanoseconds: NDArray[np.int64]
    offsets: NDArray[np.int64]
    limits: NDArray[np.int64]


class ChunkReader:
    """Reads chunks of one bag.

    Args:
        file: of the bag.
        connections: of the blocks.
        numbers: place of each connection that is wanted there, by its number in the bag; at least one.
    """

    def __init__(self, file: BinaryIO, connections: ConnectionList, numbers: Dict[int, int]) -> None:
        self._file = file
        self._connections = connections
        self._numbers = numbers
        # Numbers are a stranger's: a table up to the highest could take all memory.
        self._sorted = np.array(sorted(numbers), np.int64)
        self._places = np.array([numbers[number] for number in sorted(numbers)], np.int64)
        self._known: Dict[bytes, int] = {}

    def read(self, chunks: Sequence[ChunkPlace], end: int) -> Block:
        """Read the messages of chunks that stand one behind the other.

        Args:
            chunks: in the order of the file, at least one.
            end: where their indexes end at the latest, by what stands behind them.

        Returns:
            The messages by time of receipt; equal times in the order of the file.

        Raises:
            EOFError, OSError, RuntimeError, ValueError: a chunk is damaged, or does not hold what its index says.
            MissingDependencyError: the library for its compression is not installed.
        """
        begin = chunks[0].position
        self._file.seek(begin)
        region = self._file.read(end - begin)
        content, entries = self._entries(region, [chunk._replace(position=chunk.position - begin) for chunk in chunks])
        if entries is None:
            return Block.of(self._connections, ())
        if int(entries.nanoseconds.max()) >= 1_000_000_000:
            raise ValueError("its index has stamps of a billion nanoseconds or more")
        receipts = entries.seconds * 1_000_000_000 + entries.nanoseconds
        order = np.argsort(entries.offsets, kind="stable")
        if len(order) > 1 and int(np.diff(receipts[order]).min()) < 0:
            order = order[np.argsort(receipts[order], kind="stable")]
        entries = _Entries(*(column[order] for column in entries))
        begins, ends = _records(content, entries)
        places = self._places[np.searchsorted(self._sorted, entries.numbers)]
        return Block(self._connections, places, receipts[order], content, begins, ends)

    def _entries(self, region: bytes, chunks: Sequence[ChunkPlace]) -> Tuple[bytes, Any]:
        """Find the content of chunks, and what their indexes say of it; None if they say nothing."""
        contents: List[bytes] = []
        plain = True
        shift = 0
        parts: List[bytes] = []
        # Of each part: number of the connection, entries, how far the content is shifted, where the chunk ends there.
        columns: List[Tuple[int, int, int, int]] = []
        for chunk in chunks:
            compression, size, begin, end = _chunk_header(region, chunk.position)
            if compression is not Compression.NONE:
                if plain and contents:
                    raise ValueError("chunks are compressed differently")
                plain = False
                content = decompress(compression, region[begin:end], size)
                if len(content) < size:
                    raise EOFError(f"it unpacks to {len(content)} of {size} bytes")
                contents.append(content)
                its_shift, limit = shift, shift + size
                shift += size
            else:
                contents.append(b"")
                its_shift, limit = begin, end
            position = end
            for _ in chunk.counts:
                number, first, position = self._index(region, position)
                if number in self._numbers:
                    parts.append(region[first:position])
                    columns.append((number, (position - first) // _ENTRY.itemsize, its_shift, limit))
        content = region if plain else b"".join(contents)
        entries = np.frombuffer(b"".join(parts), _ENTRY)
        if not len(entries):
            return content, None
        table = np.array(columns, np.int64)
        numbers, shifts, limits = (np.repeat(table[:, column], table[:, 1]) for column in (0, 2, 3))
        seconds, nanoseconds, offsets = (entries[name].astype(np.int64) for name in _ENTRY.names or ())
        return content, _Entries(numbers, seconds, nanoseconds, offsets + shifts, limits)

    def _index(self, region: bytes, position: int) -> Tuple[int, int, int]:
        """Read one record of an index.

        Returns:
            The number of its connection, where its entries begin and where they end.
        """
        if position + 4 > len(region):
            raise ValueError("its index is cut off")
        length = _u32(region, position)[0]
        begin = position + 8 + length
        if begin > len(region):
            raise ValueError("its index is cut off")
        header = region[position + 4 : begin - 4]
        number = self._known.get(header)
        if number is None:
            fields = parse_pairs(header)
            if fields.get("op") != OP_INDEX or len(fields.get("conn", b"")) != 4:
                raise ValueError("its index is cut off")
            number = _u32(fields["conn"])[0]
            if len(self._known) < _MOST_HEADERS:
                self._known[header] = number
        end = begin + _u32(region, begin - 4)[0]
        if end > len(region) or (end - begin) % _ENTRY.itemsize:
            raise ValueError("its index is cut off")
        return number, begin, end


def _chunk_header(region: bytes, position: int) -> Tuple[Compression, int, int, int]:
    """Read the header of a chunk.

    Returns:
        How it is compressed, its size before that, and where its data begins and ends.
    """
    if position + 8 > len(region):
        raise EOFError("it is cut off")
    length = _u32(region, position)[0]
    begin = position + 8 + length
    if begin > len(region):
        raise EOFError("it is cut off")
    header = parse_pairs(region[position + 4 : begin - 4])
    if header.get("op") != OP_CHUNK or len(header.get("size", b"")) != 4:
        raise ValueError("there is no chunk")
    size, end = _u32(header["size"])[0], begin + _u32(region, begin - 4)[0]
    word = header.get("compression", b"").decode("ascii", "replace")
    try:
        compression = Compression(word)
    except ValueError:
        known = ", ".join(each.value for each in Compression)
        raise ValueError(f"it is compressed by {word!r}; there are {known}") from None
    if max(end - begin, size) > LARGEST_CHUNK:
        raise ValueError(f"it claims {max(end - begin, size)} bytes; at most {LARGEST_CHUNK} are read in one piece")
    if end > len(region):
        raise EOFError("it is cut off")
    return compression, size, begin, end


def _records(content: bytes, entries: _Entries) -> Tuple[NDArray[np.int64], NDArray[np.int64]]:
    """Find where messages begin and end, and hold their headers against the index."""
    offsets, limits = entries.offsets, entries.limits
    if (offsets > limits - 8).any():
        raise ValueError("its index points behind its end")
    lengths = _words(content, offsets)
    begins = offsets + lengths + 8
    if (begins > limits).any():
        raise ValueError("a message's header is longer than the rest of it")
    ends = begins + _words(content, begins - 4)
    if (ends > limits).any():
        raise ValueError("a message is longer than the rest of it")
    shortest, longest = int(lengths.min()), int(lengths.max())
    if shortest == longest:
        _check_headers(content, shortest, entries)
    else:
        for length in np.unique(lengths).tolist():
            rows = np.flatnonzero(lengths == length)
            _check_headers(content, length, _Entries(*(column[rows] for column in entries)))
    return begins, ends


def _check_headers(content: bytes, length: int, entries: _Entries) -> None:
    """Hold headers of one length against the index."""
    first = int(entries.offsets[0]) + 4
    sample = content[first : first + length]
    header = parse_pairs(sample)
    if header.get("op") != OP_MESSAGE or len(header.get("conn", b"")) != 4 or len(header.get("time", b"")) != 8:
        raise ValueError("its index points at what is no message")
    connection, time = _place_of(sample, b"conn="), _place_of(sample, b"time=")
    rows: NDArray[Any] = np.ndarray((len(content) - length + 1,), f"V{length}", content, strides=(1,))[
        entries.offsets + 4
    ]
    same = rows.view(np.uint8).reshape(len(rows), length) == np.frombuffer(sample, np.uint8)
    same[:, connection : connection + 4] = True
    same[:, time : time + 8] = True
    layout = np.dtype(
        {
            "names": ["connection", "seconds", "nanoseconds"],
            "formats": ["<u4"] * 3,
            "offsets": [connection, time, time + 4],
            "itemsize": length,
        }
    )
    fields = rows.view(layout)
    if not (
        same.all()
        and (fields["connection"] == entries.numbers).all()
        and (fields["seconds"] == entries.seconds).all()
        and (fields["nanoseconds"] == entries.nanoseconds).all()
    ):
        raise ValueError("its index points at what is another message or none")


def _place_of(header: bytes, prefix: bytes) -> int:
    """Find where the value of a field begins in a header that holds it."""
    position = 0
    while not header.startswith(prefix, position + 4):
        position += 4 + int(_u32(header, position)[0])
    return position + 4 + len(prefix)


def _words(content: bytes, places: NDArray[np.int64]) -> NDArray[np.int64]:
    """Read 32 bits at each place."""
    windows: NDArray[Any] = np.ndarray((len(content) - 3,), "<u4", content, strides=(1,))
    return windows[places].astype(np.int64)
