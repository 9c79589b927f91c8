"""How chunks of bags are compressed, so that ROS 1 reads them."""

from __future__ import annotations

import bz2
from enum import Enum
from typing import Any, Union

from rqt_mrta_py.errors import MissingDependencyError

__all__ = ["Compression", "compress", "decompress"]


_BZ2_LEVEL = 3
"""Blocks of 300 kB are sorted within the processor's cache: with a thousand robots a fifth quicker than the 900 kB of
level 9, for 0 to 6 % more bytes. Any reader takes any level."""


class Compression(Enum):
    """How chunks are compressed; the value is the word that bags use."""

    NONE = "none"
    BZ2 = "bz2"
    LZ4 = "lz4"


def compress(compression: Compression, data: Union[bytes, memoryview]) -> Union[bytes, memoryview]:
    """Compress the data of a chunk.

    Raises:
        MissingDependencyError: the library for it is not installed.
    """
    if compression is Compression.BZ2:
        return bz2.compress(data, _BZ2_LEVEL)
    if compression is Compression.LZ4:
        # ROS refuses frames of linked blocks, without checksum or with their size.
        compressed: bytes = _lz4().compress(data, 0, block_linked=False, content_checksum=True, store_size=False)
        return compressed
    return data


def decompress(compression: Compression, data: bytes, size: int) -> bytes:
    """Give back the data of a chunk, whoever compressed it.

    Args:
        compression: of the chunk.
        data: of the chunk, or its beginning if the rest is missing.
        size: of the chunk before compression [bytes]; never is more made.

    Returns:
        The chunk, or as much of its beginning as can be had.

    Raises:
        MissingDependencyError: the library for it is not installed.
        EOFError, OSError, RuntimeError, ValueError: the data is damaged.
    """
    if compression is Compression.BZ2:
        return bz2.BZ2Decompressor().decompress(data, max_length=size)
    if compression is Compression.LZ4:
        whole: bytes = _lz4().LZ4FrameDecompressor().decompress(data, max_length=size)
        return whole
    return data[:size]


def _lz4() -> Any:
    try:
        import lz4.frame
    except ImportError as error:
        raise MissingDependencyError(
            f"lz4 in bags needs the library lz4 ({error}); install it with: pip install 'rqt_mrta_py[bag]'"
        ) from error
    return lz4.frame
