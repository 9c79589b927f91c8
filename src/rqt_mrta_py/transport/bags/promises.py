"""How many messages a bag's indexes tell of, so that what a damaged bag has lost can be counted."""

from __future__ import annotations

import struct
from typing import Dict, Mapping, Optional

__all__ = ["Promises"]

_MOST = 2**20
_u32 = struct.Struct("<I").unpack_from
_two = struct.Struct("<II").iter_unpack


class Promises:
    """Takes in the counts of both indexes: the one behind each chunk, and the one at the end of the bag.

    Either alone may be damaged, and counts may be a stranger's: they are held against one another by who calls this,
    and never allocated for.

    Attributes:
        chunks: number of chunks that the index at the end told of so far.
        chunks_in_all: number of chunks by the file's header; None if that tells nothing.
    """

    def __init__(self) -> None:
        self.chunks = 0
        self.chunks_in_all: Optional[int] = None
        self._behind_chunks: Dict[int, int] = {}
        self._at_end: Dict[int, int] = {}

    @property
    def whole(self) -> bool:
        """Whether the index at the end was read whole, so that the counts are those of the whole bag."""
        return self.chunks_in_all is not None and self.chunks == self.chunks_in_all

    def counts(self) -> Mapping[int, int]:
        """Give the number of messages by that of their connection; there may have been more, if not ``whole``."""
        if self.whole:
            return self._at_end
        numbers = {**self._behind_chunks, **self._at_end}
        return {each: max(self._behind_chunks.get(each, 0), self._at_end.get(each, 0)) for each in numbers}

    def take_file_header(self, header: Mapping[str, bytes]) -> None:
        """Take in the header of the file; one without an index says nothing."""
        count = header.get("chunk_count", b"")
        if len(count) == 4 and header.get("index_pos", b"").strip(b"\0"):
            self.chunks_in_all = _u32(count)[0]

    def take_index(self, header: Mapping[str, bytes]) -> None:
        """Take in a record of the index behind a chunk."""
        count = header.get("count", b"")
        if len(count) == 4:
            self._add(self._behind_chunks, _u32(header["conn"])[0], _u32(count)[0])

    def take_chunk_info(self, header: Mapping[str, bytes], data: bytes) -> None:
        """Take in a record of the index at the end."""
        if len(data) % 8 or header.get("count", b"") != struct.pack("<I", len(data) // 8):
            return
        self.chunks += 1
        for number, count in _two(data):
            self._add(self._at_end, number, count)

    @staticmethod
    def _add(counts: Dict[int, int], number: int, count: int) -> None:
        if number in counts or len(counts) < _MOST:
            counts[number] = counts.get(number, 0) + count
