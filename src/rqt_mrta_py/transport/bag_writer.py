"""Bags as they are recorded: ROS 1 format 2.0, on rosbags' writer with two of its faults mended.

rosbags' LZ4 frames are refused by ROS, which needs independent blocks, a content checksum and no stored size. And
its file header is 8 bytes too short: ``rosbag reindex`` and appending would overwrite the first chunk, so the header
is made as long as ROS makes it when the file is opened.
"""

from __future__ import annotations

import logging
import struct
from contextlib import suppress
from enum import Enum
from pathlib import Path
from types import TracebackType
from typing import Any, BinaryIO, Dict, Optional, Tuple, Type

from rqt_mrta_py.errors import TransportError
from rqt_mrta_py.hooks import Connection, Stamped
from rqt_mrta_py.transport.rosbags_door import rosbag1

__all__ = ["BagWriter", "Compression"]

_LOG = logging.getLogger(__name__)

_ROSBAGS_HEADER_END = 4109
_PADDING = b" " * 8
_DATA_LENGTH_AT = 86
_DATA_LENGTH = struct.pack("<L", 4027)
"""Magic (13 bytes), a header of 4 + 69 bytes, then this length of the padding: the first chunk begins at 4117."""

_END_OF_TIME_NS = 2**32 * 10**9
_NEVER = 2**62
_CHUNK_BYTES = 768 * 1024
"""When a chunk is closed before its second is over, as rosbag does."""


class Compression(Enum):
    """How chunks are compressed; the value is the word that bags use."""

    NONE = "none"
    BZ2 = "bz2"
    LZ4 = "lz4"


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
        MissingDependencyError: rosbags is not installed.
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
        library = rosbag1()
        self._period_ns = round(checkpoint_period * 1e9)
        self._checkpoint_ns: Optional[int] = None
        self._targets: Dict[Connection, Any] = {}
        # Sources hand in the same Connection object again and again: its identity is found faster than its value.
        self._by_identity: Dict[int, Tuple[Connection, Any]] = {}
        self._closed = False
        self._errors = (library.WriterError, OSError, ValueError, struct.error)
        try:
            if replace and self.active_path.exists():
                self.active_path.unlink()
            self._writer = library.Writer(self.active_path)
            self._writer.chunk_threshold = _NEVER
            if compression is not Compression.NONE:
                self._writer.set_compression(library.Writer.CompressionFormat[compression.name])
            if compression is Compression.LZ4:
                self._writer.compressor = _lz4_as_ros_reads_it
            self._writer.open()
            self._lengthen_header()
        except self._errors as error:
            raise TransportError(f"{self.active_path}: cannot be written: {error}") from error

    def write(self, stamped: Stamped) -> None:
        """Write one message.

        Args:
            stamped: the message; its connection is written before its first message.

        Raises:
            TransportError: the time does not fit into a bag, the disk is full, or the bag is closed.
        """
        connection, receipt_ns, raw = stamped
        if self._closed:
            raise TransportError(f"{self.path}: is closed; a message of {connection.topic} came too late")
        if not 0 <= receipt_ns < _END_OF_TIME_NS:
            raise TransportError(
                f"{self.path}: a message of {connection.topic} at {receipt_ns} ns cannot be written; a bag holds times "
                f"from 0 to below {_END_OF_TIME_NS} ns"
            )
        chunk = self._writer.chunks[-1]
        if (
            self._checkpoint_ns is None
            or not 0 <= receipt_ns - self._checkpoint_ns < self._period_ns
            or chunk.data.tell() > _CHUNK_BYTES
        ):
            self.checkpoint()
            self._checkpoint_ns = receipt_ns
            chunk = self._writer.chunks[-1]
        known = self._by_identity.get(id(connection))
        target = known[1] if known is not None else self._target(connection)
        mark = chunk.data.tell()
        try:
            self._writer.write(target, receipt_ns, raw)
        except BaseException as error:
            _undo(chunk, mark)
            if isinstance(error, self._errors):
                raise TransportError(
                    f"{self.path}: a message of {connection.topic} at {receipt_ns} ns cannot be written: {error}"
                ) from error
            raise

    def checkpoint(self) -> None:
        """Bring everything written so far to the file; ``rosbag reindex`` finds it there after a kill.

        Raises:
            TransportError: the disk is full or gone.
        """
        chunk = self._writer.chunks[-1]
        begin = self._writer.bio.tell()
        try:
            self._writer.write_chunk(chunk)
            self._writer.bio.flush()
        except BaseException as error:
            if not chunk.data.closed:
                # The bag goes on after an interrupt, and a chunk must stand in the file whole or not at all.
                self._writer.bio.seek(begin)
                self._writer.bio.truncate()
                chunk.pos = -1
            if isinstance(error, self._errors):
                raise TransportError(f"{self.active_path}: cannot be written: {error}") from error
            raise

    def close(self) -> None:
        """Write the index and give the bag its name; safe to call twice.

        Raises:
            TransportError: the index cannot be written, or the bag cannot be renamed.
        """
        if self._closed:
            return
        self._closed = True
        file = self._writer.bio
        try:
            self._writer.close()
            # Closing has rewritten the file header, with the wrong length.
            with self.active_path.open("r+b") as closed:
                closed.seek(_DATA_LENGTH_AT)
                closed.write(_DATA_LENGTH)
            self.active_path.replace(self.path)
        except self._errors as error:
            _let_go(file)
            raise TransportError(
                f"{self.active_path}: cannot be completed: {error}; 'rosbag reindex' finds what it holds"
            ) from error

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

    def _target(self, connection: Connection) -> Any:
        target = self._targets.get(connection)
        if target is None:
            package, _, message = connection.type.partition("/")
            try:
                target = self._targets[connection] = self._writer.add_connection(
                    connection.topic,
                    f"{package}/msg/{message}",
                    msgdef=connection.definition,
                    md5sum=connection.md5,
                    callerid=connection.caller or None,
                    latching=1 if connection.latched else None,
                )
            except self._errors as error:
                raise TransportError(f"{self.path}: connection {connection} cannot be written: {error}") from error
            self._by_identity[id(connection)] = (connection, target)
        return target

    def _lengthen_header(self) -> None:
        file = self._writer.bio
        if file.tell() != _ROSBAGS_HEADER_END:
            end = file.tell()
            _let_go(file)
            raise TransportError(
                f"{self.active_path}: rosbags writes a file header that ends at byte {end}, known is "
                f"{_ROSBAGS_HEADER_END}; install rosbags>=0.9.20,<0.12"
            )
        file.write(_PADDING)
        file.seek(_DATA_LENGTH_AT)
        file.write(_DATA_LENGTH)
        file.seek(0, 2)
        file.flush()


def _let_go(file: BinaryIO) -> None:
    """Close a file that is given up; what it still holds back may not find room on the disk either."""
    with suppress(OSError):
        file.close()


def _undo(chunk: Any, mark: int) -> None:
    """Take back a message that was written by half, so that the index speaks of whole messages only."""
    chunk.data.seek(mark)
    chunk.data.truncate()
    for number in list(chunk.connections):
        entries = chunk.connections[number]
        if entries and entries[-1][1] >= mark:
            entries.pop()
        if not entries:
            del chunk.connections[number]


def _lz4_as_ros_reads_it(raw: bytes) -> bytes:
    import lz4.frame

    compressed: bytes = lz4.frame.compress(raw, 0, block_linked=False, content_checksum=True, store_size=False)
    return compressed
