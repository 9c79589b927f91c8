"""Headers of many records at once: those of a kind are equally long and differ in a few numbers only."""

from __future__ import annotations

from typing import Any, Mapping

import numpy as np
from numpy.typing import NDArray

from rqt_mrta_py.transport.bags.records import OP_INDEX, OP_MESSAGE, record
from rqt_mrta_py.transport.bags.windows import put

__all__ = ["INDEX_HEADERS", "MESSAGE_HEADERS", "Headers"]


class Headers:
    """Headers of one kind of record, up to where the data begins.

    Attributes:
        sample: one of them, whatever its numbers.
        length: of each [bytes].

    Args:
        sample: see above.
        places: where the numbers of 32 bits stand, by name.
    """

    def __init__(self, sample: bytes, places: Mapping[str, int]) -> None:
        self.sample = sample
        self.length = len(sample)
        self._whole = np.dtype(f"V{self.length}")
        self._row = np.dtype(
            {
                "names": list(places),
                "formats": ["<u4"] * len(places),
                "offsets": list(places.values()),
                "itemsize": self.length,
            }
        )

    def put(self, buffer: NDArray[np.uint8], places: NDArray[np.int64], numbers: Mapping[str, NDArray[Any]]) -> None:
        """Put headers into a buffer.

        Args:
            buffer: bytes, without gaps.
            places: where each header begins, shape (headers,) [bytes].
            numbers: those of all headers, by name, each of shape (headers,).
        """
        content = bytearray(self.sample) * len(places)
        rows = np.frombuffer(content, self._row)
        for name, column in numbers.items():
            rows[name] = column
        put(buffer, places, np.frombuffer(content, self._whole))


_MESSAGE = record({"op": OP_MESSAGE, "conn": bytes(4), "time": bytes(8)}, b"")
_TIME = _MESSAGE.index(b"time=") + 5
_INDEX = record({"op": OP_INDEX, "ver": b"\1\0\0\0", "conn": bytes(4), "count": bytes(4)}, b"")

MESSAGE_HEADERS = Headers(
    _MESSAGE,
    {
        "connection": _MESSAGE.index(b"conn=") + 5,
        "seconds": _TIME,
        "nanoseconds": _TIME + 4,
        "size": len(_MESSAGE) - 4,
    },
)
"""Those of messages; ``size`` is the length of the message."""

INDEX_HEADERS = Headers(
    _INDEX,
    {"connection": _INDEX.index(b"conn=") + 5, "count": _INDEX.index(b"count=") + 6, "size": len(_INDEX) - 4},
)
"""Those of the indexes that follow a chunk; ``size`` is the length of the entries."""
