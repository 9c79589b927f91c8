"""Bags as they are recorded: ROS 1 format 2.0, chunk by chunk, so that a killed recording is lost by a second at most.

Messages wait as they are until their chunk is written, which happens in one piece; those of a batch wait run by run,
and nothing is made for each of them. rosbags' own writer is not used: ROS refuses its LZ4 frames, ``rosbag reindex``
and appending destroy its first chunk, and each of its writes searches all connections.
"""

from __future__ import annotations

import logging
import struct
from contextlib import suppress
from itertools import repeat
from pathlib import Path
from types import TracebackType
from typing import List, NamedTuple, Optional, Tuple, Type

import numpy as np
from numpy.typing import NDArray

from rqt_mrta_py.errors import TransportError
from rqt_mrta_py.hooks import Connection, Stamped
from rqt_mrta_py.transport.bags.chunks import build_chunk
from rqt_mrta_py.transport.bags.compression import Compression, compress
from rqt_mrta_py.transport.bags.headers import MESSAGE_HEADERS
from rqt_mrta_py.transport.bags.numbering import Numbering
from rqt_mrta_py.transport.bags.pending import Pending
from rqt_mrta_py.transport.bags.records import (
    FILE_HEADER_END,
    MAGIC,
    chunk_header,
    chunk_info,
    file_header,
)
from rqt_mrta_py.transport.batch import Batch

__all__ = ["BagWriter"]

_LOG = logging.getLogger(__name__)

_END_OF_TIME_NS = 2**32 * 10**9
_CHUNK_BYTES = 4 * 2**20
"""When a chunk is closed before its period is over. rosbag closes chunks at 768 KiB; with a thousand robots that is 22
chunks a second with nearly an index for each message, which doubles the time of writing and adds 40 % to the file. Any
tool reads larger ones, but holds one in memory."""

_LONGEST = 2**31
"""The longest message [bytes]; a chunk has 32 bits for its length."""

_WORTH_A_LOOK = 8
"""Fewer messages of a batch are written one by one, which is quicker."""

_WORTH_A_BLOCK = 32
"""Fewer messages a run wait one by one."""

_HEADER_BYTES = MESSAGE_HEADERS.length
_u32 = struct.Struct("<I").pack


class _Written(NamedTuple):
    """What stands in the file: its last chunk's info, where it ends, how many connections it describes.

    Of the chunk besides: receipt of its first and last message [ns], and what at its end counts messages [bytes].
    """

    info: bytes
    end: int
    described: int
    start_ns: int = 0
    end_ns: int = 0
    counts: int = 0


class BagWriter:
    """Writes one bag, as ``<name>.active`` until it is closed.

    The bytes depend on nothing but what is written. Leaving the ``with`` block closes the bag with a complete index,
    also when an exception leaves it.

    Args:
        path: of the bag; unless it may be replaced, it must not exist.
        compression: of its chunks.
        checkpoint_period: how much of the stream's time may be lost when the process is killed [s].
        replace: take the place of a bag of this name, once this one is complete, and of a leftover ``.active`` file.

    Raises:
        TransportError: the bag or its ``.active`` file exists and may not be replaced, or cannot be made.
        MissingDependencyError: the library for the compression is not installed.
    """

    def __init__(
        self,
        path: Path,
        compression: Compression = Compression.LZ4,
        checkpoint_period: float = 1.0,
        *,
        replace: bool = False,
    ) -> None:
        self.path = Path(path)
        self.active_path = self.path.with_name(self.path.name + ".active")
        if self.path.exists() and not replace:
            raise TransportError(f"{self.path}: exists already; choose another name or remove it")
        compress(compression, b"")
        self._compression = compression
        self._period_ns = round(checkpoint_period * 1e9)
        # The chunk takes in what was received from here to before there; nothing before the first message.
        self._since_ns = self._until_ns = 0
        self._chunk_bytes = 0
        self._pending = Pending()
        self._singles = self._pending.singles
        self._numbering = Numbering(self.path)
        self._recognised = self._numbering.recognised
        self._written: List[_Written] = [_Written(b"", FILE_HEADER_END, 0)]
        self._closed = self._complete = False
        try:
            if replace and self.active_path.exists():
                self.active_path.unlink()
            # Unbuffered: what is written once stands in the file, and a chunk that finds no room is taken back.
            self._file = self.active_path.open("xb", buffering=0)
        except FileExistsError as error:
            raise TransportError(
                f"{self.active_path}: cannot be written: exists already; a recording of this name is under way or was "
                "never completed, choose another name or remove it"
            ) from error
        except OSError as error:
            raise TransportError(f"{self.active_path}: cannot be written: {error}") from error
        try:
            self._put(0, MAGIC + file_header(0, 0, 0))
        except TransportError:
            self._let_go()
            raise

    def write(self, stamped: Stamped) -> None:
        """Write one message.

        Args:
            stamped: the message; its connection is written before its first message.

        Raises:
            TransportError: the message does not fit into a bag, the disk is full, or the bag is closed.
        """
        connection, receipt_ns, raw = stamped
        size = len(raw)
        if not self._since_ns <= receipt_ns < self._until_ns or self._chunk_bytes > _CHUNK_BYTES or size > _LONGEST:
            self._make_room(connection, receipt_ns, size)
        number = self._recognised.get(id(connection))
        if number is None:
            self._introduce(stamped)
        else:
            self._chunk_bytes += _HEADER_BYTES + size
            self._singles.append((number, receipt_ns, raw))

    def write_batch(self, batch: Batch) -> None:
        """Write messages one after another; the bag is the same, and so are errors.

        Args:
            batch: the messages.

        Raises:
            TransportError: as for one; the messages before it are written.
        """
        numbers = self._numbering.line_up(batch.connections) if len(batch) >= _WORTH_A_LOOK else None
        if numbers is None:
            for stamped in batch:
                self.write(stamped)
        elif len(batch) < _WORTH_A_BLOCK * len(batch.runs):
            self._write_mixed(batch, numbers)
        else:
            self._write_runs(batch, numbers)

    def checkpoint(self) -> None:
        """Bring everything written so far to the file, where it survives this process.

        Raises:
            TransportError: the disk is full or gone; nothing is lost but for the process, it may be tried again.
        """
        if not self._pending:
            return
        known, fresh = len(self._written), Pending()
        try:
            chunk = build_chunk(self._pending, self._numbering.descriptions, self._written[-1].described)
            data = compress(self._compression, chunk.body)
            head = chunk_header(self._compression.value, len(chunk.body))
            position = self._written[-1].end
            end = self._put(position, b"".join((head, _u32(len(data)), data, chunk.indexes)))
            info = chunk_info(position, chunk.start_ns, chunk.end_ns, chunk.counts)
            written = _Written(info, end, chunk.described, chunk.start_ns, chunk.end_ns, len(chunk.counts))
            self._written.append(written)
        finally:
            # After an interrupt the bag goes on: a chunk counts as written, or its messages wait on.
            if len(self._written) > known:
                self._pending, self._singles, self._chunk_bytes = fresh, fresh.singles, 0

    def spans(self) -> Tuple[Tuple[Connection, int, int, int], ...]:
        """Say how much stands in the file, without reading it.

        Returns:
            Connections that have any messages in the order of the bag, each with their number, and with the receipt of
            the first and last message of the first and last chunk that has one of them [ns].
        """
        connections = self._numbering.connections
        totals = np.zeros((3, len(connections)), np.int64)
        counts, first, last = totals
        for written in self._written[1:]:
            pairs = np.frombuffer(written.info[len(written.info) - written.counts :], "<u4").reshape(-1, 2)
            numbers = pairs[:, 0]
            first[numbers[counts[numbers] == 0]] = written.start_ns
            last[numbers] = written.end_ns
            counts[numbers] += pairs[:, 1]
        found = zip(connections, *totals.tolist())
        return tuple(span for span in found if span[1])

    def close(self) -> None:
        """Write the index and give the bag its name; safe to call twice.

        Raises:
            TransportError: the index cannot be written, or the bag cannot be renamed.
        """
        if self._closed:
            return
        self._closed = True
        self._until_ns = self._since_ns
        try:
            self.checkpoint()
            position = self._written[-1].end
            infos = [written.info for written in self._written]
            descriptions = self._numbering.descriptions
            self._put(position, b"".join(descriptions + infos))
            self._put(0, MAGIC + file_header(position, len(descriptions), len(infos) - 1))
            self._file.close()
            self.active_path.replace(self.path)
            self._complete = True
        except (TransportError, OSError) as error:
            self._let_go()
            raise TransportError(
                f"{self.active_path}: cannot be completed: {error.__cause__ or error}; "
                "save what it holds with 'mrta salvage'"
            ) from error

    def discard(self) -> None:
        """Give the bag up: nothing of it stays, and what it was to replace stands. A complete bag is left alone."""
        if self._complete:
            return
        self._closed = True
        self._until_ns = self._since_ns
        self._pending = Pending()
        self._singles = self._pending.singles
        self._let_go()
        with suppress(OSError):
            self.active_path.unlink()
        self._complete = True

    def __enter__(self) -> BagWriter:
        return self

    def __exit__(
        self, kind: Optional[Type[BaseException]], error: Optional[BaseException], trace: Optional[TracebackType]
    ) -> None:
        try:
            self.close()
        except TransportError as failure:
            if error is None:
                raise
            # What went wrong first is what the user must hear of.
            _LOG.warning("bag not completed reason=%s", failure)

    def _make_room(self, connection: Connection, receipt_ns: int, size: int) -> None:
        """See that the present chunk takes in a message; it is begun anew if need be."""
        if not self._since_ns <= receipt_ns < self._until_ns or self._chunk_bytes > _CHUNK_BYTES:
            if self._closed:
                raise TransportError(f"{self.path}: is closed; a message of {connection.topic} came too late")
            if not 0 <= receipt_ns < _END_OF_TIME_NS:
                raise TransportError(
                    f"{self.path}: a message of {connection.topic} at {receipt_ns} ns cannot be written; a bag holds "
                    f"times from 0 to below {_END_OF_TIME_NS} ns"
                )
            self.checkpoint()
            self._since_ns, self._until_ns = receipt_ns, min(receipt_ns + self._period_ns, _END_OF_TIME_NS)
        if size > _LONGEST:
            raise TransportError(
                f"{self.path}: a message of {connection.topic} cannot be written; it has {size} bytes, at most "
                f"{_LONGEST} are accepted"
            )

    def _write_runs(self, batch: Batch, numbers: NDArray[np.int64]) -> None:
        """Write messages run by run; a chunk may end within one."""
        begin = start = 0
        for messages, size in batch.runs:
            end = begin + messages
            while begin < end:
                self._make_room(batch.connections[begin], batch.receipt_ns, size)
                fitting = 1 + max(0, _CHUNK_BYTES - self._chunk_bytes) // (_HEADER_BYTES + size)
                chosen = numbers[begin : min(end, begin + fitting)]
                content: NDArray[np.void] = np.ndarray(chosen.shape, f"V{size}", batch.content, start)
                self._chunk_bytes += len(chosen) * (_HEADER_BYTES + size)
                self._pending.append_block(chosen, batch.receipt_ns, content)
                begin, start = begin + len(chosen), start + content.nbytes

    def _write_mixed(self, batch: Batch, numbers: NDArray[np.int64]) -> None:
        """Write messages that differ in length, in one go if they end in one chunk."""
        self._make_room(batch.connections[0], batch.receipt_ns, batch.runs[0].size)
        size = len(batch.content) + _HEADER_BYTES * len(batch)
        if self._chunk_bytes + size <= _CHUNK_BYTES:
            self._chunk_bytes += size
            self._singles.extend(zip(numbers.tolist(), repeat(batch.receipt_ns), batch.raws))
        else:
            for stamped in batch:
                self.write(stamped)

    def _introduce(self, stamped: Stamped) -> None:
        """Write a message whose connection is not recognised: it is new, or equals one that is known."""
        connection, receipt_ns, raw = stamped
        number = self._numbering.find(connection)
        new = number is None
        if number is None:
            number = self._numbering.describe(connection)
            self._chunk_bytes += len(self._numbering.descriptions[number])
        self._chunk_bytes += _HEADER_BYTES + len(raw)
        self._singles.append((number, receipt_ns, raw))
        if new:
            # Not before a single message of it waits: a block describes nobody, and an interrupt comes at any step.
            self._recognised[id(connection)] = number

    def _put(self, position: int, data: bytes) -> int:
        """Write at a position of the file, and say where it ends; what finds no room is taken back whole."""
        left = memoryview(data)
        try:
            self._file.seek(position)
            while left:
                left = left[self._file.write(left) or 0 :]
        except OSError as error:
            if position:
                with suppress(OSError):
                    self._file.truncate(position)
            raise TransportError(f"{self.active_path}: cannot be written: {error}") from error
        return position + len(data)

    def _let_go(self) -> None:
        with suppress(OSError):
            self._file.close()
