"""One chunk of a bag that does not hold what the index says: what can be had by walking over its records."""

from __future__ import annotations

from typing import BinaryIO, List

from rqt_mrta_py.hooks import Stamped
from rqt_mrta_py.transport.bags.chunk_walk import ChunkWalk, Stretch
from rqt_mrta_py.transport.bags.faults import BagFaults
from rqt_mrta_py.transport.bags.index import BagIndex
from rqt_mrta_py.transport.bags.records import OP_CHUNK

__all__ = ["rescued"]


class _Rescue(ChunkWalk):
    """Walks over a part of a bag."""

    def part(self, file: BinaryIO, index: BagIndex, begin: int, end: int, faults: BagFaults) -> List[Stamped]:
        self.all_faults, self.size = faults, index.size
        self._connections.read_index(file, index.begins, index.size)
        found: List[Stamped] = []
        stretch = Stretch(file, end)
        for record in self._records(stretch, begin):
            if record.op == OP_CHUNK:
                found.extend(self._chunk(file, record))
            else:
                found.extend(self._message(stretch, record))
        return found


def rescued(file: BinaryIO, index: BagIndex, position: int, faults: BagFaults) -> List[Stamped]:
    """Read what can be read of a chunk.

    Args:
        file: of the bag.
        index: of the bag.
        position: where the chunk begins.
        faults: is told what cannot be read.

    Returns:
        The messages, in the order of the file.
    """
    end = min((chunk.position for chunk in index.chunks if chunk.position > position), default=index.begins)
    return _Rescue(index.path).part(file, index, position, end, faults)
