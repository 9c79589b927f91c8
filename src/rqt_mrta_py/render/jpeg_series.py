"""Pictures one after another as JPEG, of which only what differs from the picture before is encoded anew.

Behind a restart marker the coding of a JPEG begins as at its start, so what stands between two markers depends on the
pixels of one tile alone. Most tiles of a mission's pictures are as in the picture before.
"""

from __future__ import annotations

import re
from typing import TYPE_CHECKING, List, Tuple

import numpy as np

from rqt_mrta_py.render.encode import jpeg
from rqt_mrta_py.render.libraries import opencv

if TYPE_CHECKING:
    from numpy.typing import NDArray

__all__ = ["JpegSeries", "restart_interval"]

# Height and width of what JPEG encodes as one, where colour has half the resolution of light [pixels].
_BLOCK = 16
_WIDEST_TILE = 5
# Of tiles one upon the other, for no JPEG is higher than 65535 pixels.
_HIGHEST_PILE = 4000
_START_OF_SCAN = 0xDA
_END = b"\xff\xd9"
# Among coded pixels a zero follows each byte 0xff, so that none of them looks like a marker.
_RESTART = re.compile(rb"\xff[\xd0-\xd7]")


class JpegSeries:
    """Encodes pictures of a series; the bytes of each are a function of its pixels, whatever was encoded before.

    They are those of ``jpeg(image, quality, restart_interval(image.shape))``. Not to be called from two threads at
    once.

    Args:
        quality: from 1, worst, to 100, best.
    """

    def __init__(self, quality: int = 85) -> None:
        self._quality = quality
        self._shown: NDArray[np.uint8] = np.empty((0, 0, 3), dtype=np.uint8)
        # Of the file: its head; then by turns a tile, row by row, and what stands behind it.
        self._parts: List[bytes] = []

    def __call__(self, image: NDArray[np.uint8]) -> bytes:
        """Encode the next picture.

        Args:
            image: (height, width, 3), blue, green, red.

        Returns:
            The file's bytes.

        Raises:
            RenderError: the picture cannot be encoded.
            ValueError: the quality is out of range.
        """
        if image.shape != self._shown.shape or image.dtype != self._shown.dtype:
            return self._begin(image)
        tile = restart_interval(image.shape)
        rows, columns = _changed_tiles(image, self._shown, tile)
        if len(rows) > min(len(self._parts) // 4, _HIGHEST_PILE):
            return self._begin(image)
        if len(rows):
            pile = _tiles(image, tile)[rows, :, columns]
            _, coded = _taken_apart(jpeg(pile.reshape(-1, tile * _BLOCK, 3), self._quality, tile))
            across = image.shape[1] // (tile * _BLOCK)
            for number, part in zip((across * rows + columns).tolist(), coded):
                self._parts[1 + 2 * number] = part
            _tiles(self._shown, tile)[rows, :, columns] = pile
        return b"".join(self._parts)

    def _begin(self, image: NDArray[np.uint8]) -> bytes:
        """Encode a picture as a whole, and keep it if it has tiles."""
        tile = restart_interval(image.shape)
        data = jpeg(image, self._quality, tile)
        if tile:
            head, coded = _taken_apart(data)
            # Restart markers count from 0 to 7, then begin again.
            ends = [bytes((0xFF, 0xD0 + number % 8)) for number in range(len(coded) - 1)] + [_END]
            self._parts = [head, *(part for both in zip(coded, ends) for part in both)]
            self._shown = np.array(image, order="C")
        return data


def restart_interval(shape: Tuple[int, ...]) -> int:
    """Give how many blocks of 16 x 16 pixels side by side are a tile, such that equal tiles fill a row.

    Args:
        shape: of the picture: height, width [pixels] and whatever.

    Returns:
        At least 1; 0, for no tiles, if blocks do not fill the picture.
    """
    height, width = shape[:2]
    if height % _BLOCK or width % _BLOCK:
        return 0
    return max(count for count in range(1, _WIDEST_TILE + 1) if width // _BLOCK % count == 0)


def _tiles(image: NDArray[np.uint8], tile: int) -> NDArray[np.uint8]:
    """Give a picture as its tiles: (rows of tiles, 16, tiles in a row, bytes)."""
    height, width, _ = image.shape
    return image.reshape(height // _BLOCK, _BLOCK, width // (tile * _BLOCK), -1)


def _changed_tiles(
    image: NDArray[np.uint8], shown: NDArray[np.uint8], tile: int
) -> Tuple[NDArray[np.intp], NDArray[np.intp]]:
    """Give the rows and columns of the tiles that differ."""
    cv2 = opencv()
    across = image.shape[1] // (tile * _BLOCK)
    differs = np.zeros((image.shape[0] // _BLOCK, across), dtype=bool)
    for row in range(len(differs)):
        strip = slice(row * _BLOCK, (row + 1) * _BLOCK)
        now, before = image[strip], shown[strip]
        # Most strips do not differ, and this tells it at once.
        if cv2.norm(now, before, cv2.NORM_INF):
            lines = np.bitwise_xor(now, before).reshape(_BLOCK, -1)
            differs[row] = np.bitwise_or.reduce(lines, axis=0).reshape(across, -1).any(axis=1)
    rows, columns = np.nonzero(differs)
    return rows, columns


def _taken_apart(data: bytes) -> Tuple[bytes, List[bytes]]:
    """Split a file into what comes before the coded pixels, and these at each restart marker."""
    start = 2
    while data[start + 1] != _START_OF_SCAN:
        start = _after(data, start)
    start = _after(data, start)
    return data[:start], _RESTART.split(data[start : -len(_END)])


def _after(data: bytes, start: int) -> int:
    """Give where the segment ends that begins at a marker."""
    return start + 2 + int.from_bytes(data[start + 2 : start + 4], "big")
