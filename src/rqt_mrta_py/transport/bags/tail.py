"""Bags that somebody still records: what whole chunks have been added since one last looked.

A chunk that has not been written to its end is left alone until it has: ours go to the file in one piece, rosbag writes
their lengths last. What is damaged is passed over and told, as by ``ChunkWalk``.
"""

from __future__ import annotations

import io
from pathlib import Path
from typing import Iterator, Optional

from rqt_mrta_py.errors import TransportError
from rqt_mrta_py.hooks import Stamped
from rqt_mrta_py.transport.bags.chunk_walk import ChunkWalk, Stretch
from rqt_mrta_py.transport.bags.records import MAGIC, OP_CHUNK
from rqt_mrta_py.transport.bags.scan import Record, find_record, read_record

__all__ = ["BagTail"]


class BagTail(ChunkWalk):
    """Follows one bag, chunk by chunk in the order of the file; the file is kept open though it be renamed.

    Args:
        path: of the bag, or of its ``.active`` file; it has begun.

    Attributes:
        complete: True once the bag has an index and everything before it has been read.

    Raises:
        TransportError: the file cannot be read or is no ROS 1 bag.
    """

    def __init__(self, path: Path) -> None:
        super().__init__(path)
        self.complete = False
        self._file = self._opened()
        self.position = len(MAGIC)

    @property
    def indexed(self) -> bool:
        """Tell whether the bag has an index, so that its recording is over."""
        self.size = self._file.seek(0, io.SEEK_END)
        return self._index_begins(self._file) > 0

    def close(self) -> None:
        """Let the file go."""
        self._file.close()

    def read(self) -> Iterator[Stamped]:
        """Yield the messages that whole chunks have brought since this was last asked.

        Raises:
            TransportError: the file has become shorter, so it is another recording by now.
        """
        file = self._file
        self.size = file.seek(0, io.SEEK_END)
        if self.size < self.position:
            raise TransportError(f"{self.path}: has become shorter while it was followed; it is another bag by now")
        self._index_position = self._index_begins(file)
        while True:
            record = self._next_record()
            if record is None:
                break
            self.position = record.end
            if record.op != OP_CHUNK:
                yield from self._message(Stretch(file, self.size), record)
            elif record.next == record.end:
                yield from self._chunk(file, record)
            else:
                stretch = Stretch(file, record.end)
                for inner in self._records(stretch, record.begin):
                    yield from self._message(stretch, inner)
        self.complete = 0 < self._index_position <= self.position

    def _next_record(self) -> Optional[Record]:
        """Give the next record that stands there whole; None if it is still to be written."""
        try:
            record = read_record(self._file, self.position, self.size)
        except EOFError:
            return None
        except ValueError as error:
            found = find_record(self._file, self.position + 1, self.size, chunks_only=True)
            if found is None:
                return None
            self._tell(None, self.position, str(error), found - self.position)
            self.position = found
            return self._next_record()
        unwritten = record.op == OP_CHUNK and record.begin == record.end and not self._index_position
        return None if unwritten or record.end > self.size else record
