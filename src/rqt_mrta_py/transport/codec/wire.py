"""How values stand on the wire: ROS 1 serialisation, little endian, without padding."""

from __future__ import annotations

import math
from typing import Dict, Tuple

from rqt_mrta_py.errors import TransportError
from rqt_mrta_py.transport.codec.definitions import Definition, Field

__all__ = ["BYTE_TYPES", "INTEGER_RANGES", "MOST_EMPTY", "NUMBERS", "WORDS", "Sizes", "duration_words", "time_words"]

NUMBERS: Dict[str, str] = {
    "bool": "?",
    "byte": "b",
    "char": "B",
    "float32": "f",
    "float64": "d",
    "int16": "h",
    "int32": "i",
    "int64": "q",
    "int8": "b",
    "uint16": "H",
    "uint32": "I",
    "uint64": "Q",
    "uint8": "B",
}
"""The struct code of each type that is one number; ``byte`` is signed and ``char`` is not, as genpy has it."""

WORDS: Dict[str, str] = {"time": "II", "duration": "ii"}
"""The struct codes of seconds and nanoseconds."""

BYTE_TYPES = frozenset(("uint8", "char"))
"""Arrays of these are bytes."""

INTEGER_RANGES: Dict[str, Tuple[int, int]] = {
    "byte": (-(2**7), 2**7 - 1),
    "char": (0, 2**8 - 1),
    "int8": (-(2**7), 2**7 - 1),
    "int16": (-(2**15), 2**15 - 1),
    "int32": (-(2**31), 2**31 - 1),
    "int64": (-(2**63), 2**63 - 1),
    "uint8": (0, 2**8 - 1),
    "uint16": (0, 2**16 - 1),
    "uint32": (0, 2**32 - 1),
    "uint64": (0, 2**64 - 1),
}

MOST_EMPTY = 16
"""How many messages without content one message or array may hold: they take no bytes, so bytes set no bound."""

_MOST_FIELDS = 4096
"""How many fields a type may have, those of contained types included; the largest known types have about 300."""

_SIZES = {"?": 1, "b": 1, "B": 1, "f": 4, "d": 8, "h": 2, "i": 4, "q": 8, "H": 2, "I": 4, "Q": 8}


class Sizes:
    """How many bytes the types of one definition take.

    Args:
        definition: whose types are measured.

    Raises:
        TransportError: a type is too large to be meant seriously.
    """

    def __init__(self, definition: Definition) -> None:
        self._least: Dict[str, int] = {}
        self._fixed: Dict[str, bool] = {}
        counts: Dict[str, int] = {}
        empties: Dict[str, int] = {}
        for name in definition.contained_first:
            least, fixed, count, empty = 0, True, 0, 0
            for item in definition.specs[name].fields:
                size = self.element(item)
                count += 1 + counts.get(item.type, 0)
                if item.is_array and item.length is None:
                    least, fixed = least + 4, False
                else:
                    times = 1 if item.length is None else item.length
                    least += size * times
                    empty += (empties.get(item.type, 0) + (size == 0)) * times
                    fixed = fixed and self.is_fixed(item.type)
            if count > _MOST_FIELDS:
                raise TransportError(
                    f"{name}: {count} fields with those it contains; at most {_MOST_FIELDS} are accepted"
                )
            if empty > MOST_EMPTY:
                raise TransportError(
                    f"{name}: holds {empty} messages without content; at most {MOST_EMPTY} are accepted"
                )
            self._least[name], self._fixed[name], counts[name], empties[name] = least, fixed, count, empty

    def element(self, item: Field) -> int:
        """Give the least number of bytes that one element of a field takes."""
        if item.type in NUMBERS:
            return _SIZES[NUMBERS[item.type]]
        if item.type in WORDS:
            return 8
        return 4 if item.type == "string" else self._least[item.type]

    def is_fixed(self, type_name: str) -> bool:
        """Tell whether all values of a type take equally many bytes."""
        return self._fixed.get(type_name, type_name != "string")


def time_words(value: float) -> Tuple[int, int]:
    """Split a time into the wire's seconds and nanoseconds, rounded to the nearest nanosecond.

    Args:
        value: [s], at least 0 after rounding.

    Raises:
        ValueError: not finite, negative, or too late for 32 bits.
    """
    words = duration_words(value)
    if words[0] < 0:
        raise ValueError("a time is never negative")
    return words


def duration_words(value: float) -> Tuple[int, int]:
    """Split a duration into the wire's seconds and nanoseconds, rounded to the nearest nanosecond.

    Args:
        value: [s]; of a negative one the seconds are rounded down, so that the nanoseconds are positive.

    Raises:
        ValueError: not finite.
    """
    if value.__class__ is bool:
        raise ValueError("a truth value is no time")
    seconds = math.floor(value)
    nanoseconds = round((value - seconds) * 1e9)
    if nanoseconds == 1_000_000_000:
        return seconds + 1, 0
    return seconds, nanoseconds
