"""The index of a whole bag: which connections it has, where its chunks begin, and what they hold."""

from __future__ import annotations

import io
import struct
from pathlib import Path
from typing import BinaryIO, Dict, List, NamedTuple, Tuple

import numpy as np

from rqt_mrta_py.errors import TransportError
from rqt_mrta_py.hooks import Connection
from rqt_mrta_py.transport.bags.connections import ConnectionTable
from rqt_mrta_py.transport.bags.records import MAGIC, OP_CHUNK_INFO, OP_CONNECTION, OP_FILE_HEADER
from rqt_mrta_py.transport.bags.scan import Record, read_record

__all__ = ["BagIndex", "ChunkPlace", "UnindexedBagError", "open_bag", "read_index"]

_SALVAGE = "save what it holds with 'mrta salvage'"
_GIVE = "give a file that 'rosbag info' reads"

_two = struct.Struct("<II").unpack_from
_u64 = struct.Struct("<Q").unpack_from


class UnindexedBagError(TransportError):
    """A bag has no index, or not all of it; what it holds can still be found by walking over it."""


class ChunkPlace(NamedTuple):
    """One chunk, as the index describes it.

    Attributes:
        position: where it begins in the file.
        start_ns: receipt of its earliest message [ns].
        end_ns: receipt of its latest message [ns].
        table: number of each connection in it and of that connection's messages, 32 bits each.
    """

    position: int
    start_ns: int
    end_ns: int
    table: bytes

    @property
    def counts(self) -> Dict[int, int]:
        """Give the number of messages by number of connection; only of those that have any."""
        return {number: count for number, count in np.frombuffer(self.table, "<u4").reshape(-1, 2).tolist() if count}


class BagIndex(NamedTuple):
    """What the end of a bag says of it.

    Attributes:
        path: of the bag.
        size: of the file [bytes].
        begins: where the index begins, behind the last chunk.
        connections: by number, in the order of the bag.
        chunks: by start, then position; those without messages are left out.
    """

    path: Path
    size: int
    begins: int
    connections: Dict[int, Connection]
    chunks: Tuple[ChunkPlace, ...]


def open_bag(path: Path) -> BinaryIO:
    """Open a file that begins as a bag of ROS 1 does.

    Raises:
        TransportError: it does not, or cannot be read; says what to do.
    """
    try:
        file: BinaryIO = Path(path).open("rb")  # noqa: SIM115 - the caller closes it
        magic = file.read(len(MAGIC))
    except FileNotFoundError:
        raise TransportError(f"{path}: no such file; give the path of a bag") from None
    except OSError as error:
        raise TransportError(f"{path}: not a whole ROS 1 bag: {error.strerror or error}; {_GIVE}") from error
    if magic == MAGIC:
        return file
    file.close()
    reason = f"it begins with {magic!r}, bags of version 2.0 with {MAGIC!r}" if magic else "the file is empty"
    raise TransportError(f"{path}: not a whole ROS 1 bag: {reason}; {_GIVE}")


def read_index(file: BinaryIO, path: Path) -> BagIndex:
    """Read what the end of a bag says of it.

    Args:
        file: of the bag.
        path: for errors.

    Raises:
        UnindexedBagError: the bag has no index, or it is damaged; says what to do.
    """
    try:
        size = file.seek(0, io.SEEK_END)
        header = read_record(file, len(MAGIC), size)
        if header.op != OP_FILE_HEADER:
            raise ValueError("its first record is no file header")
        begins = int(_u64(header.header["index_pos"])[0])
        if begins == 0:
            raise UnindexedBagError(
                f"{path}: not a whole ROS 1 bag: it is not indexed; its recording was never completed, {_SALVAGE}"
            )
        if begins > size:
            raise EOFError
        return _read(file, path, size, begins)
    except EOFError:
        raise UnindexedBagError(
            f"{path}: not a whole ROS 1 bag: its index is cut off; its end is missing, {_SALVAGE}"
        ) from None
    except (LookupError, OSError, ValueError, struct.error) as error:
        raise UnindexedBagError(f"{path}: not a whole ROS 1 bag: its index is damaged: {error}; {_SALVAGE}") from error


def _read(file: BinaryIO, path: Path, size: int, begins: int) -> BagIndex:
    table = ConnectionTable()
    connections: Dict[int, Connection] = {}
    chunks: List[ChunkPlace] = []
    position = begins
    while position < size:
        record = read_record(file, position, size)
        if record.end > size:
            raise EOFError
        file.seek(record.begin)
        data = file.read(record.end - record.begin)
        if record.op == OP_CONNECTION:
            table.describe(record.header, data)
            number = int.from_bytes(record.header["conn"], "little")
            found = table.find(number)
            if found is not None:
                connections[number] = found
        elif record.op == OP_CHUNK_INFO:
            chunk = _chunk_place(record, data)
            if not len(MAGIC) <= chunk.position < begins:
                raise ValueError(f"a chunk is said to begin at byte {chunk.position}, the index at byte {begins}")
            if chunk.counts:
                chunks.append(chunk)
        else:
            raise ValueError(f"a record at byte {position} is neither a connection nor about a chunk")
        position = record.end
    chunks.sort(key=lambda chunk: (chunk.start_ns, chunk.position))
    return BagIndex(path, size, begins, connections, tuple(chunks))


def _chunk_place(record: Record, data: bytes) -> ChunkPlace:
    if len(data) % 8:
        raise ValueError("what it says of a chunk is cut off")
    seconds, nanoseconds = _two(record.header["start_time"])
    last_seconds, last_nanoseconds = _two(record.header["end_time"])
    return ChunkPlace(
        int(_u64(record.header["chunk_pos"])[0]),
        seconds * 1_000_000_000 + nanoseconds,
        last_seconds * 1_000_000_000 + last_nanoseconds,
        data,
    )
