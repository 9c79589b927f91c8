"""Bags without an index: what a recording left that was killed, filled its disk, or lost its end."""

from __future__ import annotations

import struct
from pathlib import Path
from typing import BinaryIO, Dict, Iterator, List, Mapping, Tuple

from rqt_mrta_py.errors import TransportError
from rqt_mrta_py.hooks import Connection, Stamped
from rqt_mrta_py.transport.bag_records import MAGIC, OP_CHUNK, OP_CONNECTION, OP_MESSAGE, parse_pairs
from rqt_mrta_py.transport.compression import Compression, decompress

__all__ = ["ChunkWalk"]

_LARGEST_CHUNK = 2**30
"""Chunks that claim more are not believed; ROS closes them at 768 KiB, or after one message that is larger [bytes]."""

_LONGEST_HEADER = 2**20
"""The longest header holds the name of a topic [bytes]."""

_CUT = "the header of a record is cut off"

_u32 = struct.Struct("<I").unpack_from
_two = struct.Struct("<II").unpack_from


class ChunkWalk:
    """Walks over the records of a bag from its first byte, and never asks for an index.

    Iterating yields the messages in the order of the file, as far as whole records stand, also those of a chunk whose
    end is missing. What cannot be read is said in ``faults``, and the walk goes on with the next chunk where one can
    be found. Equal connections are the same object.

    Args:
        path: of the bag, or of its ``.active`` file.

    Attributes:
        faults: what could not be read, in the order of the file, so far.

    Raises:
        TransportError: the file cannot be read or is no ROS 1 bag.
    """

    def __init__(self, path: Path) -> None:
        self.path = Path(path)
        self.faults: List[str] = []
        self._connections: Dict[int, Connection] = {}
        self._equal: Dict[Connection, Connection] = {}
        with self._opened():
            pass

    def __iter__(self) -> Iterator[Stamped]:
        self.faults.clear()
        self._connections.clear()
        with self._opened() as file:
            size = self.path.stat().st_size
            position = len(MAGIC)
            while position < size:
                try:
                    header, begin, end = _head(file, position, size)
                    data = self._inner(file, position, header, begin, min(end, size))
                except (EOFError, RuntimeError, OSError, ValueError) as error:
                    self.faults.append(f"byte {position}: {error}")
                    return
                if end > size:
                    self.faults.append(f"byte {position}: the file ends {end - size} bytes before this record does")
                yield from self._messages(position, data, whole=end <= size)
                position = end

    def _opened(self) -> BinaryIO:
        try:
            file = self.path.open("rb")
        except OSError as error:
            raise TransportError(f"{self.path}: cannot be read: {error}") from error
        magic = file.read(len(MAGIC))
        if magic != MAGIC:
            file.close()
            raise TransportError(f"{self.path}: begins with {magic!r}; a ROS 1 bag begins with {MAGIC!r}")
        return file

    def _inner(self, file: BinaryIO, position: int, header: Mapping[str, bytes], begin: int, end: int) -> bytes:
        """Read a record's data, if it is a chunk's: decompressed, as far as that can be done."""
        if header.get("op") != OP_CHUNK:
            return b""
        try:
            compression = Compression(header["compression"].decode("ascii", "replace"))
            size = _u32(header["size"])[0]
        except (LookupError, ValueError, struct.error) as error:
            self.faults.append(f"byte {position}: a chunk without a known compression and size: {_words(error)}")
            return b""
        if size > _LARGEST_CHUNK:
            self.faults.append(f"byte {position}: a chunk claims {size} bytes; at most {_LARGEST_CHUNK} are believed")
            return b""
        file.seek(begin)
        try:
            data = decompress(compression, file.read(end - begin), size)
        except (EOFError, RuntimeError, OSError, ValueError) as error:
            self.faults.append(f"byte {position}: a chunk cannot be decompressed: {error}")
            return b""
        return data

    def _messages(self, chunk: int, data: bytes, whole: bool) -> Iterator[Stamped]:
        position, size = 0, len(data)
        while position < size:
            message = None
            try:
                header, begin, end = _record(data, position)
                if end > size:
                    raise EOFError("it ends before a record does")
                if header.get("op") == OP_MESSAGE:
                    seconds, nanoseconds = _two(header["time"])
                    connection = self._connections[_u32(header["conn"])[0]]
                    message = Stamped(connection, seconds * 1_000_000_000 + nanoseconds, data[begin:end])
                elif header.get("op") == OP_CONNECTION:
                    self._describe(header, data[begin:end])
            except (EOFError, LookupError, ValueError, struct.error) as error:
                if whole or not isinstance(error, EOFError):
                    self.faults.append(f"byte {chunk}: a chunk is damaged at its byte {position}: {_words(error)}")
                return
            if message is not None:
                yield message
            position = end

    def _describe(self, header: Mapping[str, bytes], data: bytes) -> None:
        texts = {name: value.decode("utf-8", "replace") for name, value in parse_pairs(data).items()}
        connection = Connection(
            topic=header["topic"].decode("utf-8", "replace"),
            type=texts["type"],
            md5=texts["md5sum"],
            definition=texts["message_definition"],
            caller=texts.get("callerid", ""),
            latched=texts.get("latching") == "1",
        )
        self._connections[_u32(header["conn"])[0]] = self._equal.setdefault(connection, connection)


def _head(file: BinaryIO, position: int, size: int) -> Tuple[Dict[str, bytes], int, int]:
    """Read the header of a record of the file; say where its data begins and ends."""
    file.seek(position)
    length = _length(file.read(4), 0)
    if position + 8 + length > size:
        raise EOFError(_CUT)
    if length > _LONGEST_HEADER:
        raise ValueError(f"a record claims a header of {length} bytes; at most {_LONGEST_HEADER} are believed")
    header = parse_pairs(file.read(length))
    begin = position + 8 + length
    return header, begin, begin + _length(file.read(4), 0)


def _record(data: bytes, position: int) -> Tuple[Dict[str, bytes], int, int]:
    """Read the header of a record of a chunk; say where its data begins and ends."""
    end = position + 4 + _length(data, position)
    begin = end + 4
    length = _length(data, end)
    return parse_pairs(data[position + 4 : end]), begin, begin + length


def _length(data: bytes, position: int) -> int:
    if position + 4 > len(data):
        raise EOFError(_CUT)
    length: int = _u32(data, position)[0]
    return length


def _words(error: Exception) -> str:
    return f"nothing says what {error} is" if isinstance(error, LookupError) else str(error)
