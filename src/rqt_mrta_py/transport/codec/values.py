"""Values as writers of messages take them: Python's own, NumPy's, and what does not fit at all.

What does not fit raises whatever is at hand; ``misfits`` finds the words for it.
"""

from __future__ import annotations

import struct
from typing import Any, Callable, Dict, List, Tuple

__all__ = ["Texts", "bytes_of", "elements_of", "truth_of", "truths_of", "words_of"]

_LONGEST_KEPT = 64
_MOST_KEPT = 4096


class Texts(Dict[str, bytes]):
    """From a string to how it stands on the wire; short ones are kept, for most recur in every message."""

    def __missing__(self, value: Any) -> bytes:
        if not isinstance(value, str):
            raise TypeError("not a string")
        raw = value.encode()
        raw = struct.pack("<I", len(raw)) + raw
        if len(raw) <= _LONGEST_KEPT:
            if len(self) >= _MOST_KEPT:
                self.clear()
            self[value] = raw
        return raw


def elements_of(value: Any) -> Any:
    """Give the elements of an array's value: a list or tuple as it is, a NumPy array as a list."""
    if isinstance(value, (list, tuple, bytes, bytearray)):
        return value
    if getattr(value, "ndim", None) == 1:
        return value.tolist()
    raise TypeError("not an array")


def bytes_of(value: Any) -> bytes:
    """Give an array of bytes as bytes."""
    if isinstance(value, (bytes, bytearray, memoryview)):
        return bytes(value)
    if getattr(value, "dtype", None) == "uint8" and value.ndim == 1:
        raw: bytes = value.tobytes()
        return raw
    return bytes(elements_of(value))


def truth_of(value: Any) -> bool:
    """Give a truth value, which may also be NumPy's or 0 or 1."""
    if value in (0, 1) and not isinstance(value, float):
        return bool(value)
    raise TypeError("not a truth value")


def truths_of(value: Any) -> List[bool]:
    """Give an array of truth values."""
    return [truth_of(item) for item in elements_of(value)]


def words_of(split: Callable[[float], Tuple[int, int]], value: Any) -> List[int]:
    """Give the seconds and nanoseconds of an array of times or durations, one after the other."""
    return [word for item in elements_of(value) for word in split(item)]
