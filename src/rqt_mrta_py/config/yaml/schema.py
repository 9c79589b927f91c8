"""YAML forms as data: from these tables files are checked, and their documentation is written.

``rows`` reads by them.
"""

from __future__ import annotations

from dataclasses import dataclass, field
from enum import Enum
from typing import Any, Mapping, Optional, Tuple

__all__ = ["REQUIRED", "Key", "Table", "ValueType"]


class ValueType(Enum):
    """What a key holds; the value is how messages and documentation call it."""

    TEXT = "a text"
    WHOLE = "a whole number"
    NUMBER = "a number"
    SWITCH = "true or false"
    TEXTS = "a list of texts"
    NUMBERS = "a list of numbers"
    GROUPS = "a list of lists of texts"
    FREE = "a mapping"
    TABLE = "a mapping of known keys"
    TABLES = "a list of mappings"


class _Required(Enum):
    REQUIRED = "required"


REQUIRED = _Required.REQUIRED
"""The default of a key that must be given."""


@dataclass(frozen=True)
class Key:
    """One key of a mapping.

    Attributes:
        name: as written.
        type: what it holds.
        summary: one sentence.
        unit: of a number; empty for a text, a count or a ratio.
        default: where it is not given; ``REQUIRED`` if it must be.
        minimum, maximum: of a number, both included; None if there is none.
        above: of a number, not included; None if there is none.
        choices: of a text; empty if any text will do.
        blank: of a text or texts, whether one without anything but blanks will do.
        count: of a list of numbers; None if any.
        table: of TABLE and TABLES.
    """

    name: str
    type: ValueType
    summary: str
    unit: str = ""
    default: Any = REQUIRED
    minimum: Optional[float] = None
    maximum: Optional[float] = None
    above: Optional[float] = None
    choices: Tuple[str, ...] = ()
    count: Optional[int] = None
    table: Optional[Table] = None
    blank: bool = False


@dataclass(frozen=True)
class Table:
    """The keys of one kind of mapping.

    Attributes:
        name: what such a mapping is.
        summary: one sentence.
        keys: in the order of the documentation.
        further: True if further keys are accepted, as parameters of whatever the mapping names.
        by: the key whose value decides which keys follow; empty if none does.
        variants: the keys that follow, by that value.
    """

    name: str
    summary: str
    keys: Tuple[Key, ...]
    further: bool = False
    by: str = ""
    variants: Mapping[str, Table] = field(default_factory=dict)
