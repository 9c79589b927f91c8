"""Bags as they are read, this project's own and any other: one stream in the order of receipt."""

from __future__ import annotations

import re
import struct
from contextlib import contextmanager
from dataclasses import dataclass
from pathlib import Path
from typing import Any, Collection, Dict, Iterator, NamedTuple, Optional, Tuple

from rqt_mrta_py.errors import TransportError
from rqt_mrta_py.hooks import Connection, Stamped
from rqt_mrta_py.transport.rosbags_door import rosbag1

__all__ = ["BagInfo", "read_bag", "read_bag_info"]


class _Entry(NamedTuple):
    """Where a message stands. rosbags' own entries compare by time alone, which mixes up messages of equal times."""

    time: int
    chunk_pos: int
    offset: int


@dataclass(frozen=True)
class BagInfo:
    """What a bag holds.

    Attributes:
        path: of the bag.
        start_ns: receipt of the first message [ns]; None if there is none.
        end_ns: receipt of the last message [ns]; None if there is none.
        connections: every connection with its number of messages, in the order of the bag.
        spans: receipt of the first and the last message of each of them that has any, with it and its number [ns].
    """

    path: Path
    start_ns: Optional[int]
    end_ns: Optional[int]
    connections: Tuple[Tuple[Connection, int], ...]
    spans: Tuple[Tuple[Connection, int, int, int], ...] = ()

    @property
    def messages(self) -> int:
        """Tell how many messages the bag holds."""
        return sum(count for _, count in self.connections)

    @property
    def topics(self) -> Dict[str, int]:
        """Give the number of messages by topic, sorted by name."""
        counts: Dict[str, int] = {}
        for connection, count in sorted(self.connections, key=lambda pair: pair[0].topic):
            counts[connection.topic] = counts.get(connection.topic, 0) + count
        return counts


def read_bag_info(path: Path) -> BagInfo:
    """Read what a bag holds, without its messages.

    Args:
        path: of the bag.

    Raises:
        TransportError: the file is no whole bag; says what to do.
        MissingDependencyError: rosbags is not installed.
    """
    with _opened(path) as reader:
        connections, spans = [], []
        for found in reader.connections:
            connection = _connection(found)
            connections.append((connection, found.msgcount))
            times = [entry.time for entry in reader.indexes.get(found.id, ())]
            if times:
                spans.append((connection, len(times), min(times), max(times)))
    start_ns = min((start for _, _, start, _ in spans), default=None)
    end_ns = max((end for _, _, _, end in spans), default=None)
    return BagInfo(path, start_ns, end_ns, tuple(connections), tuple(spans))


def read_bag(path: Path, topics: Optional[Collection[str]] = None) -> Iterator[Stamped]:
    """Read the messages of a bag by time of receipt; equal times keep the order of the file.

    Chunks are read one by one; besides the current one only the index is held in memory.

    Args:
        path: of the bag.
        topics: the topics to read; None: all.

    Yields:
        The messages. Equal connections are the same object.

    Raises:
        TransportError: the file is no whole bag; says what to do.
        MissingDependencyError: rosbags is not installed.
    """
    with _opened(path) as reader:
        chosen = [found for found in reader.connections if topics is None or found.topic in topics]
        equal: Dict[Connection, Connection] = {}
        connections: Dict[int, Connection] = {}
        for found in chosen:
            connection = _connection(found)
            connections[found.id] = equal.setdefault(connection, connection)
            reader.indexes[found.id] = sorted(_Entry(*entry) for entry in reader.indexes[found.id])
        if chosen:
            for found, receipt_ns, raw in reader.messages(chosen):
                yield Stamped(connections[found.id], receipt_ns, raw)


@contextmanager
def _opened(path: Path) -> Iterator[Any]:
    """Open a bag, and turn whatever rosbags raises for it, then and later, into one kind of error."""
    library = rosbag1()
    # rosbags checks by assertions here and there, and hands on what decompression and decoding raise.
    failures = (
        library.ReaderError,
        ArithmeticError,
        AssertionError,
        EOFError,
        LookupError,
        MemoryError,
        OSError,
        RuntimeError,
        ValueError,
        struct.error,
    )
    if not Path(path).exists():
        raise TransportError(f"{path}: no such file; give the path of a bag")
    reader = library.Reader(path)
    try:
        reader.open()
        yield reader
    except failures as error:
        raise TransportError(f"{path}: not a whole ROS 1 bag: {_reason(error)}{_remedy(error)}") from error
    finally:
        # Where opening fails, some versions have closed the file and some have not.
        if reader.bio is not None:
            reader.close()


def _reason(error: BaseException) -> str:
    # rosbags wraps some of its own errors with their arguments, a tuple of one sentence.
    plain = re.sub(r"\('([^']*)',\)", r"\1", str(error))
    return (plain or type(error).__name__).rstrip(".")


def _remedy(error: BaseException) -> str:
    if "not indexed" in str(error):
        return "; its recording was never completed, save what it holds with 'mrta salvage'"
    if "index looks damaged" in str(error):
        return "; its end is missing, save what it holds with 'mrta salvage'"
    return "; give a file that 'rosbag info' reads"


def _connection(found: Any) -> Connection:
    package, _, message = found.msgtype.partition("/msg/")
    return Connection(
        topic=found.topic,
        type=f"{package}/{message}" if message else found.msgtype,
        md5=found.digest,
        # rosbags up to 0.9 gives the text itself.
        definition=getattr(found.msgdef, "data", found.msgdef),
        caller=found.ext.callerid or "",
        latched=found.ext.latching == 1,
    )
