"""From columns of numbers to how they stand on the wire; what a field does not take is refused as for one message."""

from __future__ import annotations

import struct
from functools import lru_cache
from typing import Any, Callable, Dict, Sequence, Tuple

import numpy as np
from numpy.typing import NDArray

from rqt_mrta_py.transport.codec.values import truth_of
from rqt_mrta_py.transport.codec.wire import INTEGER_RANGES, NUMBERS, WORDS, duration_words, time_words

__all__ = ["part_types", "parts_of_column", "parts_of_number"]

_Numbers = NDArray[Any]

_WORD_RANGES: Dict[str, Tuple[int, int]] = {"time": (0, 2**32 - 1), "duration": (-(2**31), 2**31 - 1)}
"""Seconds that can be told."""

_BILLION = 1e9


@lru_cache(maxsize=None)
def part_types(type_name: str) -> Tuple[np.dtype[Any], ...]:
    """Give the parts that a value consists of: one number, or the two words of a time.

    Args:
        type_name: a primitive of fixed size.
    """
    return tuple(np.dtype("<" + code) for code in WORDS.get(type_name, NUMBERS.get(type_name, "")))


def parts_of_number(type_name: str, value: Any) -> Sequence[Any]:
    """Give the parts of one value that all messages share.

    Args:
        type_name: a primitive of fixed size.
        value: a number; seconds for a time.

    Raises:
        ArithmeticError, TypeError, ValueError, struct.error: the value does not fit.
    """
    if type_name in WORDS:
        words: Tuple[Any, ...] = (time_words if type_name == "time" else duration_words)(value)
    else:
        words = (truth_of(value) if type_name == "bool" else value,)
    code = "<" + (WORDS.get(type_name) or NUMBERS[type_name])
    return struct.unpack(code, struct.pack(code, *words))


def parts_of_column(type_name: str, column: _Numbers) -> Tuple[_Numbers, ...]:
    """Give the parts of one value or row of each message.

    Args:
        type_name: a primitive of fixed size.
        column: of truth values, integers or floats; seconds for a time, shape (messages,) or (messages, elements).
            Floats only where the type has room for fractions, and no truth values for a time.

    Returns:
        One array for each of ``part_types``, of the column's shape.

    Raises:
        ArithmeticError, ValueError: a value does not fit.
    """
    return _PARTS.get(type_name, _integers)(type_name, column)


def _integers(type_name: str, column: _Numbers) -> Tuple[_Numbers, ...]:
    low, high = INTEGER_RANGES[type_name]
    # Two types of NumPy's may have no third that holds both; Python's integers hold all.
    if column.size and not (low <= int(column.min()) and int(column.max()) <= high):
        raise ValueError("out of range")
    return (column,)


def _truths(_: str, column: _Numbers) -> Tuple[_Numbers, ...]:
    if column.size and not (int(column.min()) >= 0 and int(column.max()) <= 1):
        raise ValueError("neither True nor False")
    return (column,)


def _floats(type_name: str, column: _Numbers) -> Tuple[_Numbers, ...]:
    if type_name == "float64":
        return (column,)
    # By way of float64, as Python's integers go: rounding twice may differ from rounding once.
    with np.errstate(over="raise"):
        return (column.astype(np.float64, copy=False).astype(np.float32),)


def _words(type_name: str, column: _Numbers) -> Tuple[_Numbers, ...]:
    low, high = _WORD_RANGES[type_name]
    values = column.astype(np.float64, copy=False)
    if not np.isfinite(values).all():
        raise ValueError("not finite")
    seconds = np.floor(values)
    nanoseconds = np.rint((values - seconds) * _BILLION)
    full = nanoseconds == _BILLION
    seconds += full
    nanoseconds[full] = 0.0
    if seconds.size and not (seconds.min() >= low and seconds.max() <= high):
        raise ValueError("out of range")
    return seconds, nanoseconds


_PARTS: Dict[str, Callable[[str, _Numbers], Tuple[_Numbers, ...]]] = {
    "bool": _truths,
    "float32": _floats,
    "float64": _floats,
    "time": _words,
    "duration": _words,
}
