"""Columns of whole numbers in few characters: differences, seven bits a byte, base 64."""

from __future__ import annotations

import base64
from typing import Iterator, List, Sequence

__all__ = ["packed", "unpacked"]


def packed(*columns: Sequence[int]) -> str:
    """Pack columns of equal length.

    Each number is told as the difference to the one above it, sign in the lowest bit, in groups of seven bits, lowest
    first; a byte with the highest bit set is followed by another of the same number (Protocol Buffers' encoding of
    ``sint64``). The number of rows stands first.

    Args:
        columns: at least one.
    """
    out = bytearray()
    _put(out, len(columns[0]))
    for column in columns:
        before = 0
        for number in column:
            difference = number - before
            before = number
            _put(out, 2 * difference if difference >= 0 else -2 * difference - 1)
    return base64.b64encode(bytes(out)).decode("ascii")


def unpacked(text: str, columns: int) -> List[List[int]]:
    """Give columns back.

    Args:
        text: from ``packed``.
        columns: how many there are.
    """
    numbers = _numbers(base64.b64decode(text))
    rows = next(numbers)
    found: List[List[int]] = []
    for _ in range(columns):
        column, before = [], 0
        for _ in range(rows):
            code = next(numbers)
            before += -(code + 1) // 2 if code & 1 else code // 2
            column.append(before)
        found.append(column)
    return found


def _put(out: bytearray, number: int) -> None:
    while number > 127:
        out.append(number & 127 | 128)
        number >>= 7
    out.append(number)


def _numbers(content: bytes) -> Iterator[int]:
    number = shift = 0
    for byte in content:
        number |= (byte & 127) << shift
        shift += 7
        if byte < 128:
            yield number
            number = shift = 0
