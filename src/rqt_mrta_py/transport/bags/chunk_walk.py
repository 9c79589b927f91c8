"""Bags without an index: what a recording left that was killed, filled its disk, or lost its end.

Only what proves itself is believed: a compressed chunk unpacks; a message ends where its chunk does, or is followed by
another record or by the end of the file. So a message right before a damaged place is left out, for its length may be
what is damaged. Where no record stands, the next one is searched for, byte by byte.
"""

from __future__ import annotations

import io
import struct
from pathlib import Path
from typing import BinaryIO, Dict, Iterator, List, Mapping, NamedTuple, Optional, Tuple

from rqt_mrta_py.errors import TransportError
from rqt_mrta_py.hooks import Stamped
from rqt_mrta_py.transport.bags.compression import Compression, decompress
from rqt_mrta_py.transport.bags.connections import ConnectionTable
from rqt_mrta_py.transport.bags.faults import BagFault, BagFaults
from rqt_mrta_py.transport.bags.promises import Promises
from rqt_mrta_py.transport.bags.records import (
    MAGIC,
    OP_CHUNK,
    OP_CHUNK_INFO,
    OP_CONNECTION,
    OP_FILE_HEADER,
    OP_INDEX,
    OP_MESSAGE,
)
from rqt_mrta_py.transport.bags.scan import LARGEST_RECORD, Record, find_record, follows, read_record

__all__ = ["ChunkWalk", "Stretch"]

_u32 = struct.Struct("<I").unpack_from
_u64 = struct.Struct("<Q").unpack_from
_two = struct.Struct("<II").unpack_from


class Stretch(NamedTuple):
    """Records one after another: those of the file, or those of a compressed chunk.

    ``chunk`` is where the chunk begins in the file, None for the file itself. ``cut`` says that it is known already
    that the end is missing.
    """

    file: BinaryIO
    size: int
    chunk: Optional[int] = None
    cut: bool = False


class ChunkWalk:
    """Walks over the records of a bag from its first byte, and needs no index.

    Iterating yields the messages in the order of the file, as far as whole records stand, also those of a chunk whose
    end is missing. What cannot be read is said in ``faults``, and the walk goes on with the next record that can be
    found. Equal connections are the same object. A connection whose description is lost is taken from the index, if
    that still stands. Memory is held for one chunk and for the connections.

    Args:
        path: of the bag, or of its ``.active`` file.

    Attributes:
        all_faults: what could not be read so far, with sums.
        compression: of the first chunk so far; None if there was none.
        position: how far the walk has come in the file [bytes].
        size: of the file when the walk began [bytes].

    Raises:
        TransportError: the file cannot be read or is no ROS 1 bag.
    """

    def __init__(self, path: Path) -> None:
        self.path = Path(path)
        with self._opened():
            pass
        self._forget()

    @property
    def faults(self) -> List[BagFault]:
        """Give what could not be read so far, in the order it was found."""
        return self.all_faults.told

    @property
    def index_is_whole(self) -> bool:
        """Tell, once the walk is over, whether the index at the bag's end told of all its chunks."""
        return self._promises.whole

    def promised(self) -> Mapping[str, Tuple[str, int]]:
        """Give, once the walk is over, what the bag's indexes tell of topics: type, and number of messages.

        There were at least as many, if ``index_is_whole`` is false. Connections that nothing describes are left out.
        """
        found: Dict[str, Tuple[str, int]] = {}
        for number, count in self._promises.counts().items():
            connection = self._connections.find(number)
            if connection is not None:
                found[connection.topic] = (connection.type, found.get(connection.topic, ("", 0))[1] + count)
        return found

    def __iter__(self) -> Iterator[Stamped]:
        self._forget()
        with self._opened() as file:
            self.size = file.seek(0, io.SEEK_END)
            try:
                self._index_position = self._index_begins(file)
                self._connections.read_index(file, self._index_position, self.size)
                for record in self._records(Stretch(file, self.size), len(MAGIC)):
                    self.position = record.position
                    if record.op != OP_CHUNK:
                        yield from self._message(Stretch(file, self.size), record)
                    else:
                        yield from self._chunk(file, record)
            except OSError as error:
                # A disk that fails tells no more than this; what was read before stands.
                self._tell(None, self.position, f"the file cannot be read further: {error}", self.size - self.position)
            self.position = self.size
            self._judge_end()

    def _forget(self) -> None:
        self.all_faults = BagFaults()
        self.compression: Optional[Compression] = None
        self.position = self.size = 0
        self._connections: ConnectionTable = ConnectionTable()
        self._promises = Promises()
        self._index_position = 0
        self._indexed = False

    def _opened(self) -> BinaryIO:
        try:
            file = self.path.open("rb")
            magic = file.read(len(MAGIC))
        except OSError as error:
            raise TransportError(f"{self.path}: cannot be read: {error}") from error
        if magic != MAGIC:
            file.close()
            raise TransportError(f"{self.path}: begins with {magic!r}; a ROS 1 bag begins with {MAGIC!r}")
        return file

    def _tell(
        self, chunk: Optional[int], position: int, reason: str, lost: int, *, missing: int = 0, joined: bool = False
    ) -> None:
        """Tell a fault at a place of the file, or of the content of the chunk that begins there."""
        if chunk is not None:
            position, reason = chunk, f"a chunk is damaged at its byte {position}: {reason}"
        self.all_faults.tell(BagFault(position, reason, lost, missing), joined=joined and chunk is None)

    def _records(self, stretch: Stretch, position: int) -> Iterator[Record]:
        """Yield the records that prove themselves; of those whose length does not, the compressed chunks."""
        file, size = stretch.file, stretch.size
        content_end = -1
        while position < size:
            try:
                record = read_record(file, position, size)
            except (EOFError, ValueError) as error:
                end = find_record(file, position + 1, size) or size
                self._tell_gap(stretch, position, end, error, content_end)
                position = end
                continue
            if record.next != record.end:
                content_end = record.end
            elif (record.end != content_end or content_end > size) and not follows(file, record.end, size):
                compressed = record.op == OP_CHUNK
                end = find_record(file, record.begin, size, chunks_only=compressed) or size
                self._tell_length(stretch, record, end)
                if compressed:
                    yield record._replace(end=end)
                position = end
                continue
            yield record
            position = record.next

    def _tell_gap(self, stretch: Stretch, position: int, end: int, error: Exception, content_end: int) -> None:
        """Tell that no record begins at a place, up to the next one or the end."""
        missing = content_end - stretch.size
        if end == stretch.size and isinstance(error, EOFError):
            if stretch.cut:
                return
            if stretch.chunk is None and missing > 0:
                reason = f"the file ends {missing} bytes before the chunk of this record does"
                self._tell(None, position, reason, end - position, missing=missing)
                return
        self._tell(stretch.chunk, position, str(error), end - position, joined=True)

    def _tell_length(self, stretch: Stretch, record: Record, end: int) -> None:
        """Tell that a record does not end where it says; the next one, or nothing, stands at another place."""
        position, compressed = record.position, record.op == OP_CHUNK
        missing = record.end - stretch.size
        if end == stretch.size and missing > 0:
            if stretch.cut:
                return
            reason = f"{'the file' if stretch.chunk is None else 'it'} ends {missing} bytes before this record does"
            self._tell(stretch.chunk, position, reason, 0 if compressed else end - position, missing=missing)
            return
        lost = max(0, end - record.end) if compressed else end - position
        reason = "no record follows where this one ends by its length"
        self._tell(stretch.chunk, position, reason, lost, joined=not compressed)

    def _chunk(self, file: BinaryIO, record: Record) -> Iterator[Stamped]:
        position, length = record.position, record.end - record.begin
        word, size = record.header["compression"].decode("ascii", "replace"), _u32(record.header["size"])[0]
        try:
            compression = Compression(word)
        except ValueError:
            known = ", ".join(each.value for each in Compression)
            self._tell(None, position, f"a chunk is compressed by {word!r}; there are {known}", length)
            return
        self.compression = self.compression or compression
        if compression is Compression.NONE:
            return
        if max(size, length) > LARGEST_RECORD:
            reason = f"a chunk claims {max(size, length)} bytes; at most {LARGEST_RECORD} are believed"
            self._tell(None, position, reason, length)
            return
        try:
            file.seek(record.begin)
            data = decompress(compression, file.read(length), size)
        except (EOFError, RuntimeError, OSError, ValueError, MemoryError) as error:
            self._tell(None, position, f"a chunk cannot be decompressed: {error}", length)
            return
        cut = len(data) < size
        if cut and (not self.faults or self.faults[-1].position != position):
            self._tell(None, position, f"a chunk unpacks to {len(data)} of {size} bytes", 0, missing=size - len(data))
        stretch = Stretch(io.BytesIO(data), len(data), position, cut)
        for inner in self._records(stretch, 0):
            yield from self._message(stretch, inner)

    def _message(self, stretch: Stretch, record: Record) -> Iterator[Stamped]:
        """Yield the message that a record is; take in the connection that it describes."""
        length = record.end - record.begin
        if record.op not in (OP_MESSAGE, OP_CONNECTION):
            self._take_index(stretch, record)
            return
        try:
            if length > LARGEST_RECORD:
                raise ValueError(f"a record claims {length} bytes; at most {LARGEST_RECORD} are believed")
            stretch.file.seek(record.begin)
            data = stretch.file.read(length)
            if record.op == OP_CONNECTION:
                self._connections.describe(record.header, data)
                return
            seconds, nanoseconds = _two(record.header["time"])
            if nanoseconds >= 1_000_000_000:
                raise ValueError(f"a message is stamped with {nanoseconds} nanoseconds; below 1000000000 are accepted")
        except (LookupError, ValueError) as error:
            self._tell(stretch.chunk, record.position, _words(error), record.end - record.position)
            return
        number = _u32(record.header["conn"])[0]
        connection = self._connections.find(number)
        if connection is None:
            position = record.position if stretch.chunk is None else stretch.chunk
            reason = f"messages of connection {number}, which nothing describes"
            self.all_faults.tell(BagFault(position, reason, record.end - record.position), once=True)
            return
        yield Stamped(connection, seconds * 1_000_000_000 + nanoseconds, data)

    def _take_index(self, stretch: Stretch, record: Record) -> None:
        """Take in what an index tells, which stands in no chunk."""
        length = record.end - record.begin
        if stretch.chunk is not None:
            return
        if record.op == OP_INDEX:
            self._promises.take_index(record.header)
        elif record.op == OP_CHUNK_INFO:
            self._indexed = True
            if length <= LARGEST_RECORD:
                stretch.file.seek(record.begin)
                self._promises.take_chunk_info(record.header, stretch.file.read(length))

    def _index_begins(self, file: BinaryIO) -> int:
        """Read from the file's header where the index begins; 0 if there is none, or no header."""
        try:
            record = read_record(file, len(MAGIC), self.size)
        except (EOFError, ValueError):
            return 0
        if record.op != OP_FILE_HEADER:
            return 0
        self._promises.take_file_header(record.header)
        return int(_u64(record.header["index_pos"])[0])

    def _judge_end(self) -> None:
        """Tell how much is missing by what the file's header says of the index, if that tells more."""
        missing = self._index_position - self.size
        if missing > self.all_faults.missing and not self._indexed:
            reason = f"the file ends {missing} bytes before its index begins"
            self._tell(None, self.size, reason, 0, missing=missing - self.all_faults.missing)


def _words(error: Exception) -> str:
    return f"nothing says what {error} is" if isinstance(error, LookupError) else str(error)
