"""Mappings of a YAML file, read by the tables that say which keys they have."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Any, Dict, List, Mapping, Optional, Tuple

from rqt_mrta_py.config.problems import Problems
from rqt_mrta_py.config.yaml.schema import REQUIRED, Key, Table, ValueType
from rqt_mrta_py.config.yaml.text import YamlNode
from rqt_mrta_py.wording import accepted, shown

__all__ = ["Row", "read_document", "read_table"]


@dataclass(frozen=True)
class Row:
    """A mapping that was read.

    Attributes:
        values: by key; the default where a key is not given, None where its value is not acceptable.
        lines: of the keys given; of others the mapping's own.
        given: keys that the file gives.
        further: what further keys hold, as nested builtins.
        line: where the mapping begins.
        element: by which problems name it.
        is_sound: True if nothing in it is wrong by its table.
    """

    values: Dict[str, Any]
    lines: Dict[str, int]
    given: Tuple[str, ...]
    further: Dict[str, Any]
    line: int
    element: str
    is_sound: bool = False

    def at(self, key: str) -> Tuple[int, str]:
        """Give line and element of a key, for a problem."""
        return self.lines.get(key, self.line), _join(self.element, key)


def read_document(node: Optional[YamlNode], table: Table, problems: Problems) -> Row:
    """Read a whole document by its table.

    Args:
        node: the document; None if it is empty.
        table: its keys.
        problems: where to note what is wrong.
    """
    if node is None:
        problems.add(1, "", f"is empty; {_keys(table)}")
        return _nothing(table.keys, 1, "")
    return read_table(node, table, "", problems)


def read_table(node: YamlNode, table: Table, element: str, problems: Problems) -> Row:
    """Read a mapping by its table.

    Args:
        node: the mapping.
        table: its keys.
        element: by which problems name the mapping.
        problems: where to note what is wrong: unknown and missing keys, wrong types, numbers out of range.
    """
    if not isinstance(node.value, dict):
        problems.add(node.line, element, f"must be a mapping (got {shown(node.plain())}); {_keys(table)}")
        return _nothing(table.keys, node.line, element)
    before = len(problems)
    keys, strange = _keys_of(node, table)
    known = {key.name: key for key in keys}
    row = _nothing(keys, node.line, element)
    row.lines.update(node.lines)
    given = []
    for name, child in node.value.items():
        if name in known:
            if child.value is not None:
                row.values[name] = _read_value(child, known[name], _join(element, name), problems)
                given.append(name)
        elif table.further:
            row.further[name] = child.plain()
        elif name not in strange:
            problems.add(node.lines[name], _join(element, name), f"is not known; {accepted(name, known)}")
        elif strange[name]:
            problems.add(node.lines[name], _join(element, name), f"{strange[name]}; accepted: {', '.join(known)}")
    for key in keys:
        if key.default is REQUIRED and key.name not in given:
            line = node.lines.get(key.name, node.line)
            problems.add(line, _join(element, key.name), f"is missing; give {_wanted(key)}")
    return Row(row.values, row.lines, tuple(given), row.further, node.line, element, len(problems) == before)


def _keys_of(node: YamlNode, table: Table) -> Tuple[Tuple[Key, ...], Mapping[str, str]]:
    """Give the keys that a mapping may have, and what to say of other variants' keys: nothing, if any may be meant."""
    value = node.value[table.by].value if isinstance(node.value, dict) and table.by in node.value else None
    variant = table.variants.get(value) if isinstance(value, str) else None
    keys = (*table.keys, *(variant.keys if variant is not None else ()))
    message = "" if variant is None else f"does not go with {table.by} {value}"
    others = [key.name for other in table.variants.values() for key in other.keys]
    return keys, {name: message for name in others if all(name != key.name for key in keys)}


def _read_value(node: YamlNode, key: Key, element: str, problems: Problems) -> Any:
    if key.type is ValueType.TABLE and key.table is not None:
        return read_table(node, key.table, element, problems)
    if key.type is ValueType.TABLES and key.table is not None:
        if isinstance(node.value, tuple):
            return [
                read_table(child, key.table, f"{element}[{index}]", problems) for index, child in enumerate(node.value)
            ]
    elif key.type is ValueType.FREE:
        if isinstance(node.value, dict):
            return node.plain()
    elif key.type in (ValueType.TEXTS, ValueType.NUMBERS):
        if isinstance(node.value, tuple) and key.count in (None, len(node.value)):
            values = [_scalar(child, key) for child in node.value]
            if None not in values:
                return tuple(values)
    elif key.type is ValueType.GROUPS:
        groups = _groups(node, key)
        if groups is not None:
            return groups
    else:
        value = _scalar(node, key)
        if value is not None:
            return value
    problems.add(node.line, element, f"must be {_wanted(key)} (got {shown(node.plain())}){_hint(node, key)}")
    return None


def _groups(node: YamlNode, key: Key) -> Optional[Tuple[Tuple[str, ...], ...]]:
    """Give lists of texts; None if one of them is something else."""
    if not isinstance(node.value, tuple):
        return None
    groups: List[Tuple[str, ...]] = []
    for group in node.value:
        names: List[Any] = [_scalar(child, key) for child in group.value] if isinstance(group.value, tuple) else [None]
        if None in names:
            return None
        groups.append(tuple(names))
    return tuple(groups)


def _scalar(node: YamlNode, key: Key) -> Any:
    """Give a scalar in the type of the key; None if it does not fit."""
    value = node.value
    if key.type is ValueType.SWITCH:
        return value if isinstance(value, bool) else None
    if key.type in (ValueType.TEXT, ValueType.TEXTS, ValueType.GROUPS):
        fits = isinstance(value, str) and (key.blank or value.strip()) and (not key.choices or value in key.choices)
        return value if fits else None
    if isinstance(value, bool) or not isinstance(value, (int, float)):
        return None
    if key.type is ValueType.WHOLE and not isinstance(value, int):
        return None
    try:
        number = float(value)
    except OverflowError:
        return None
    if (
        not math.isfinite(number)
        or (key.minimum is not None and number < key.minimum)
        or (key.maximum is not None and number > key.maximum)
        or (key.above is not None and number <= key.above)
    ):
        return None
    return value if key.type is ValueType.WHOLE else number


def _wanted(key: Key) -> str:
    """Say in words what a key accepts."""
    if key.choices:
        return f"one of {', '.join(key.choices)}"
    words = [f"a list of {key.count} numbers" if key.count is not None else key.type.value]
    unit = f" {key.unit}" if key.unit else ""
    if key.minimum is not None and key.maximum is not None:
        words.append(f"from {key.minimum:g} to {key.maximum:g}{unit}")
    elif key.minimum is not None:
        words.append(f"from {key.minimum:g}{unit}")
    elif key.maximum is not None:
        words.append(f"up to {key.maximum:g}{unit}")
    elif key.above is not None:
        words.append(f"above {key.above:g}{unit}")
    elif unit:
        words.append(f"[{key.unit}]")
    if key.table is not None:
        words.append(f"({', '.join(entry.name for entry in key.table.keys)})")
    return " ".join(words)


def _hint(node: YamlNode, key: Key) -> str:
    if key.type in (ValueType.WHOLE, ValueType.NUMBER) and isinstance(node.value, str):
        return "; YAML takes this for a text: no quotes, and a dot before an exponent, such as 1.0e-3"
    if key.type is ValueType.TEXT and isinstance(node.value, (bool, int, float)):
        return "; put it in quotes"
    return ""


def _keys(table: Table) -> str:
    return f"accepted: {', '.join(key.name for key in table.keys)}"


def _nothing(keys: Tuple[Key, ...], line: int, element: str) -> Row:
    values: Dict[str, Any] = {key.name: None if key.default is REQUIRED else key.default for key in keys}
    lines: Dict[str, int] = {}
    further: Dict[str, Any] = {}
    given: List[str] = []
    return Row(values, lines, tuple(given), further, line, element)


def _join(element: str, name: str) -> str:
    return f"{element}/{name}" if element else name
