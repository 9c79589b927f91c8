"""From columns of numbers to how they stand on the wire; what a field does not take is refused as for one message."""

from __future__ import annotations

import struct
from functools import lru_cache
from typing import Any, Sequence, Tuple

import numpy as np
from numpy.typing import NDArray

from rqt_mrta_py.transport.codec.values import truth_of
from rqt_mrta_py.transport.codec.wire import NUMBERS, WORDS, duration_words, time_words

__all__ = ["part_types", "parts_of_column", "parts_of_number"]

_Numbers = NDArray[Any]

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
        ArithmeticError, TypeError, ValueError, struct.error: a value does not fit.
    """
    if type_name in ("float32", "float64"):
        return (_floats(type_name, column),)
    if column.size:
        # Where the least and the greatest fit, all do.
        for extreme in (column.min(), column.max()):
            parts_of_number(type_name, extreme.item())
    return _words(column) if type_name in WORDS else (column,)


def _floats(type_name: str, column: _Numbers) -> _Numbers:
    if type_name == "float64":
        return column
    # By way of float64, as Python's integers go: rounding twice may differ from rounding once.
    with np.errstate(over="raise"):
        return column.astype(np.float64, copy=False).astype(np.float32)


def _words(column: _Numbers) -> Tuple[_Numbers, _Numbers]:
    """Split times as ``duration_words`` does."""
    values = column.astype(np.float64, copy=False)
    seconds = np.floor(values)
    nanoseconds = np.rint((values - seconds) * _BILLION)
    full = nanoseconds == _BILLION
    seconds += full
    nanoseconds[full] = 0.0
    return seconds, nanoseconds
