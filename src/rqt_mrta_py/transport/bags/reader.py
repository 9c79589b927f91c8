"""Bags as they are read, this project's own and any other: one stream in the order of receipt."""

from __future__ import annotations

import struct
from dataclasses import dataclass
from pathlib import Path
from typing import BinaryIO, Collection, Dict, Iterator, List, Optional, Sequence, Tuple

import numpy as np

from rqt_mrta_py.errors import TransportError
from rqt_mrta_py.hooks import Connection, Stamped
from rqt_mrta_py.transport.bags.blocks import Block, ConnectionList, ordered
from rqt_mrta_py.transport.bags.chunk_content import ChunkReader
from rqt_mrta_py.transport.bags.chunk_rescue import rescued
from rqt_mrta_py.transport.bags.faults import BagFault, BagFaults
from rqt_mrta_py.transport.bags.index import BagIndex, ChunkPlace, open_bag, read_index

__all__ = ["BagInfo", "Excerpt", "read_bag", "read_bag_info", "read_blocks"]

_MOST_WAITING = 2**28
"""Chunks whose times overlap wait for one another as long as they take no more than this together [bytes]."""

_TOGETHER = 2**20
"""Small neighbours are read together up to about so many bytes of the file."""

_DAMAGES = (ArithmeticError, EOFError, LookupError, MemoryError, OSError, RuntimeError, ValueError, struct.error)
"""What reading a damaged chunk may raise, its decompression included."""


@dataclass(frozen=True)
class BagInfo:
    """What a bag holds.

    Attributes:
        path: of the bag.
        start_ns: receipt of the first message [ns]; None if there is none.
        end_ns: receipt of the last message [ns]; None if there is none.
        connections: every connection with its number of messages, in the order of the bag.
    """

    path: Path
    start_ns: Optional[int]
    end_ns: Optional[int]
    connections: Tuple[Tuple[Connection, int], ...]

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


@dataclass(frozen=True)
class Excerpt:
    """A part of a bag.

    Attributes:
        topics: what to read; None: all.
        start_ns: what was received before is left out [ns]; None: nothing.
        end_ns: what was received later is left out [ns]; None: nothing.
    """

    topics: Optional[Collection[str]] = None
    start_ns: Optional[int] = None
    end_ns: Optional[int] = None

    def wants(self, connection: Connection) -> bool:
        """Tell whether messages of a connection belong to it."""
        return self.topics is None or connection.topic in self.topics

    def touches(self, chunk: ChunkPlace) -> bool:
        """Tell whether a chunk may hold messages of that time."""
        before = self.end_ns is not None and chunk.start_ns > self.end_ns
        return not before and (self.start_ns is None or chunk.end_ns >= self.start_ns)

    def of(self, block: Block) -> Block:
        """Leave out of a block, which is in order, what was received at other times."""
        if self.start_ns is None and self.end_ns is None:
            return block
        begin = 0 if self.start_ns is None else int(np.searchsorted(block.receipts, self.start_ns, "left"))
        end = len(block) if self.end_ns is None else int(np.searchsorted(block.receipts, self.end_ns, "right"))
        return block.part(slice(begin, end))


def read_bag_info(path: Path) -> BagInfo:
    """Read what a bag holds, without its messages.

    Args:
        path: of the bag.

    Raises:
        TransportError: the file is no whole bag; says what to do.
    """
    with open_bag(path) as file:
        index = read_index(file, path)
    counts: Dict[int, int] = dict.fromkeys(index.connections, 0)
    for chunk in index.chunks:
        for number, count in chunk.counts.items():
            if number in counts:
                counts[number] += count
    start_ns = min((chunk.start_ns for chunk in index.chunks), default=None)
    end_ns = max((chunk.end_ns for chunk in index.chunks), default=None)
    connections = tuple((index.connections[number], count) for number, count in counts.items())
    return BagInfo(path, start_ns, end_ns, connections)


def read_bag(path: Path, topics: Optional[Collection[str]] = None) -> Iterator[Stamped]:
    """Read the messages of a bag by time of receipt; equal times keep the order of the file.

    Chunks are read one by one; besides the current one only where they stand is held in memory.

    Args:
        path: of the bag.
        topics: the topics to read; None: all.

    Yields:
        The messages. Equal connections are the same object.

    Raises:
        TransportError: the file is no whole bag; says what to do.
        MissingDependencyError: the library for its compression is not installed.
    """
    for block in read_blocks(path, ConnectionList(), Excerpt(topics)):
        yield from block


def read_blocks(
    path: Path, connections: ConnectionList, excerpt: Optional[Excerpt] = None, faults: Optional[BagFaults] = None
) -> Iterator[Block]:
    """Read the messages of a bag, many at a time, as ``read_bag`` reads them one by one.

    Args:
        path: of the bag.
        connections: of the blocks; those of the bag are added as they are met.
        excerpt: what to read; None: all.
        faults: is told of chunks that do not hold what the index says, and of what is lost; what can be had of them
            is read. None: such a chunk ends the reading.

    Yields:
        The messages, some hundred or thousand at a time.

    Raises:
        UnindexedBagError: the bag has no index, or it is damaged; says what to do.
        TransportError: the file is no whole bag; says what to do.
        MissingDependencyError: the library for its compression is not installed.
    """
    with open_bag(path) as file:
        yield from _Reading(file, read_index(file, path), connections, excerpt or Excerpt(), faults).blocks()


class _Reading:
    """Reads one bag, some chunks at a time."""

    def __init__(
        self,
        file: BinaryIO,
        index: BagIndex,
        connections: ConnectionList,
        excerpt: Excerpt,
        faults: Optional[BagFaults],
    ) -> None:
        self._file = file
        self._index = index
        self._connections = connections
        self._excerpt = excerpt
        self._faults = faults
        self._numbers = {
            number: connections.number(each) for number, each in index.connections.items() if excerpt.wants(each)
        }
        positions = sorted(chunk.position for chunk in index.chunks)
        self._ends = dict(zip(positions, [*positions[1:], index.begins]))
        # By where their chunks begin.
        self._waiting: List[Tuple[int, Block]] = []

    def blocks(self) -> Iterator[Block]:
        """Yield everything in order, though the times of chunks overlap."""
        if not self._numbers:
            return
        reader = ChunkReader(self._file, self._connections, self._numbers)
        for chunks in self._groups():
            yield from self._due(chunks[0])
            for position, block in self._read(reader, chunks):
                wanted = self._excerpt.of(block)
                if len(wanted):
                    self._waiting.append((position, wanted))
        yield from self._due(None)

    def _groups(self) -> Iterator[List[ChunkPlace]]:
        """Yield the chunks that matter, small neighbours together, which neither overlap nor stand elsewhere."""
        group: List[ChunkPlace] = []
        for chunk in self._index.chunks:
            if not self._excerpt.touches(chunk) or self._numbers.keys().isdisjoint(chunk.counts):
                continue
            if group:
                last = group[-1]
                apart = self._ends[last.position] != chunk.position or chunk.start_ns < last.end_ns
                if apart or self._ends[chunk.position] - group[0].position > _TOGETHER:
                    yield group
                    group = []
            group.append(chunk)
        if group:
            yield group

    def _read(self, reader: ChunkReader, chunks: Sequence[ChunkPlace]) -> Iterator[Tuple[int, Block]]:
        """Read chunks together; one by one if there is anything wrong with them."""
        try:
            yield chunks[0].position, reader.read(chunks, self._ends[chunks[-1].position])
        except _DAMAGES as error:
            if len(chunks) > 1:
                for chunk in chunks:
                    yield from self._read(reader, (chunk,))
                return
            (chunk,) = chunks
            reason = str(error) or type(error).__name__
            if self._faults is None:
                raise TransportError(
                    f"{self._index.path}: not a whole ROS 1 bag: the chunk at byte {chunk.position} is damaged: "
                    f"{reason}; save what it holds with 'mrta salvage'"
                ) from error
            yield chunk.position, self._rescued(chunk, reason, self._faults)

    def _due(self, following: Optional[ChunkPlace]) -> Iterator[Block]:
        """Yield what comes before all that is still to be read."""
        if sum(len(block.content) for _, block in self._waiting) > _MOST_WAITING:
            following = None
        parts, rest = [], []
        for position, block in sorted(self._waiting, key=lambda each: each[0]):
            upto = len(block)
            if following is not None:
                start_ns, receipts = following.start_ns, block.receipts
                first = position < following.position
                upto = int(np.searchsorted(receipts, start_ns, "right" if first else "left"))
            if upto:
                parts.append(block if upto == len(block) else block.part(slice(0, upto)))
            if upto < len(block):
                rest.append((position, block.part(slice(upto, None))))
        self._waiting = rest
        if parts:
            yield ordered(parts)

    def _rescued(self, chunk: ChunkPlace, reason: str, faults: BagFaults) -> Block:
        """Read what can be read of a damaged chunk, and tell how many messages are lost."""
        messages = rescued(self._file, self._index, chunk.position, faults)
        lost = sum(chunk.counts.values()) - len(messages)
        what = f"lost of it: {lost} message{'' if lost == 1 else 's'}" if lost > 0 else "all its messages were found"
        faults.tell(BagFault(chunk.position, f"a chunk is damaged: {reason}; {what}"))
        wanted = [stamped for stamped in messages if self._excerpt.wants(stamped.connection)]
        wanted.sort(key=lambda stamped: stamped.receipt_ns)
        return Block.of(self._connections, wanted)
