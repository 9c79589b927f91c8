"""Records of a damaged bag: what stands at a place, and where the next record begins when none does."""

from __future__ import annotations

import re
import struct
from typing import BinaryIO, Dict, Mapping, NamedTuple, Optional

from rqt_mrta_py.transport.bags.records import (
    OP_CHUNK,
    OP_CHUNK_INFO,
    OP_CONNECTION,
    OP_FILE_HEADER,
    OP_INDEX,
    OP_MESSAGE,
    parse_pairs,
)

__all__ = ["LARGEST_RECORD", "Record", "find_record", "follows", "read_record"]

LARGEST_RECORD = 2**30
"""Chunks and messages that claim more are not believed; ROS closes chunks at 768 KiB, or after one message that is
larger [bytes]."""

_LONGEST_HEADER = 2**20
"""The longest header holds the name of a topic [bytes]."""

_FIELDS: Mapping[bytes, Mapping[str, Optional[int]]] = {
    OP_MESSAGE: {"conn": 4, "time": 8},
    OP_FILE_HEADER: {"index_pos": 8},
    OP_INDEX: {"conn": 4},
    OP_CHUNK: {"compression": None, "size": 4},
    OP_CHUNK_INFO: {"chunk_pos": 8},
    OP_CONNECTION: {"conn": 4, "topic": None},
}
"""What the header of each kind of record holds at least, with the lengths of the values [bytes]."""

_CUT = "the header of a record is cut off"

_NAMES = tuple(name.encode() for name in sorted({"op", "ver"}.union(*_FIELDS.values())))
_LONGEST_NAME = max(map(len, _NAMES))

_BLOCK = 2**18
_LANDMARK = re.compile(b"\x04\0\0\0op=[" + OP_MESSAGE + OP_CHUNK + OP_CONNECTION + b"]")
_CHUNK_LANDMARK = re.compile(b"\x04\0\0\0op=" + OP_CHUNK)
_BEFORE_LANDMARK = 64
"""How far the field ``op`` stands from the beginning of a record at most: ROS sorts the fields by name, and chunks
have the longest before it [bytes]."""

_u32 = struct.Struct("<I").unpack_from


class Record(NamedTuple):
    """A record whose header is whole.

    Attributes:
        header: its fields.
        position: where it begins.
        begin: where its data begins.
        end: where its data ends, if its length is right; may lie behind the end of the file.
    """

    header: Dict[str, bytes]
    position: int
    begin: int
    end: int

    @property
    def op(self) -> bytes:
        """Give the kind of record."""
        return self.header["op"]

    @property
    def next(self) -> int:
        """Give where the next record begins: in an uncompressed chunk the first one of its content."""
        inside = self.op == OP_CHUNK and self.header["compression"] == b"none"
        return self.begin if inside else self.end


def read_record(file: BinaryIO, position: int, size: int) -> Record:
    """Read the header of a record.

    Args:
        file: of records.
        position: where the record begins.
        size: of the file.

    Raises:
        EOFError: the file ends before the header does.
        ValueError: there is no record; says why.
    """
    file.seek(position)
    length = _length(file)
    if length > _LONGEST_HEADER:
        raise ValueError(f"a record claims a header of {length} bytes; at most {_LONGEST_HEADER} are believed")
    if position + 8 + length > size:
        # Any four bytes are a length; what is left of a header begins with one of its fields.
        first = file.read(4 + _LONGEST_NAME)[4:].partition(b"=")[0]
        if any(name.startswith(first) for name in _NAMES):
            raise EOFError(_CUT)
        raise ValueError("a record claims a header that is longer than the rest")
    header = parse_pairs(file.read(length))
    wanted = _FIELDS.get(header.get("op", b""))
    if wanted is None:
        raise ValueError("a header does not say what its record is")
    for name, expected in wanted.items():
        if name not in header or expected not in (None, len(header[name])):
            raise ValueError(f"a header lacks a field {name!r} that makes sense")
    begin = position + 8 + length
    return Record(header, position, begin, begin + _length(file))


def follows(file: BinaryIO, position: int, size: int) -> bool:
    """Tell whether the file ends at a place or a record begins there, which may be cut off."""
    if position >= size:
        return position == size
    try:
        read_record(file, position, size)
    except EOFError:
        return True
    except ValueError:
        return False
    return True


def find_record(file: BinaryIO, position: int, size: int, chunks_only: bool = False) -> Optional[int]:
    """Search for the beginning of a chunk, a connection or a message.

    Args:
        file: of records.
        position: where to begin.
        size: of the file.
        chunks_only: search for a chunk; the content of one that LZ4 compressed shows connections and messages too.

    Returns:
        The first place at or behind the position; None if there is none.
    """
    landmarks = _CHUNK_LANDMARK if chunks_only else _LANDMARK
    overlap = _BEFORE_LANDMARK + 8
    block = position
    while block < size:
        file.seek(block)
        data = file.read(_BLOCK + overlap)
        for landmark in landmarks.finditer(data):
            for start in range(max(0, landmark.start() - _BEFORE_LANDMARK), landmark.start() - 3):
                length = _u32(data, start)[0]
                # Only a header that is long enough to hold the landmark can be its own.
                if landmark.end() - start - 4 <= length <= _LONGEST_HEADER and _is_record(file, block + start, size):
                    return block + start
        block += _BLOCK
    return None


def _is_record(file: BinaryIO, position: int, size: int) -> bool:
    try:
        read_record(file, position, size)
    except (EOFError, ValueError):
        return False
    return True


def _length(file: BinaryIO) -> int:
    data = file.read(4)
    if len(data) < 4:
        raise EOFError(_CUT)
    length: int = _u32(data)[0]
    return length
