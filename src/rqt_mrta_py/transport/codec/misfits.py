"""What is wrong with the fields of a message that cannot be serialised."""

from __future__ import annotations

import math
import struct
from typing import Any, Mapping, Optional

from rqt_mrta_py.transport.codec.definitions import Definition, Field
from rqt_mrta_py.transport.codec.wire import BYTE_TYPES, INTEGER_RANGES
from rqt_mrta_py.wording import shown

__all__ = ["find_misfit"]

_LATEST = 2**32
_LONGEST = 2**31


def find_misfit(definition: Definition, fields: Any) -> Optional[str]:
    """Find the first value that does not fit, in the order of the fields.

    Args:
        definition: of the message's type.
        fields: as handed to the encoder.

    Returns:
        Path, what was found, what is accepted; None if all fits.
    """
    return _message(definition, definition.type, fields, "")


def _message(definition: Definition, type_name: str, fields: Any, path: str) -> Optional[str]:
    if not isinstance(fields, Mapping):
        return _misfit(path or "the message", fields, f"the fields of a {type_name} by name")
    declared = definition.specs[type_name].fields
    for name in fields:
        if name not in [item.name for item in declared]:
            known = ", ".join(item.name for item in declared) or "none"
            return f"{path}{'/' if path else ''}{name}: {type_name} has no such field; it has: {known}"
    for item in declared:
        if item.name in fields:
            below = f"{path}/{item.name}" if path else item.name
            check = _array if item.is_array else _value
            misfit = check(definition, item, fields[item.name], below)
            if misfit is not None:
                return misfit
    return None


def _array(definition: Definition, item: Field, value: Any, path: str) -> Optional[str]:
    accepted = f"a list of {item.type}" + ("" if item.length is None else f", {item.length} of them")
    if isinstance(value, (bytes, bytearray)) or (isinstance(value, memoryview) and item.type in BYTE_TYPES):
        elements = list(bytes(value))
    elif isinstance(value, (list, tuple)):
        elements = list(value)
    elif getattr(value, "ndim", None) == 1:
        elements = value.tolist()
    else:
        return _misfit(path, value, accepted)
    if item.length is not None and len(elements) != item.length:
        return f"{path}: {len(elements)} elements; accepted is {accepted}"
    for index, element in enumerate(elements):
        misfit = _value(definition, item, element, f"{path}/{index}")
        if misfit is not None:
            return misfit
    return None


def _value(definition: Definition, item: Field, value: Any, path: str) -> Optional[str]:
    if not item.is_primitive:
        return _message(definition, item.type, value, path)
    accepted, fits = _CHECKS.get(item.type, _integer)(item.type, value)
    return None if fits else _misfit(path, value, accepted)


def _integer(type_name: str, value: Any) -> Any:
    low, high = INTEGER_RANGES[type_name]
    accepted = f"an integer from {low} to {high}"
    try:
        struct.pack("<q" if low < 0 else "<Q", value)
    except (struct.error, OverflowError, TypeError):
        return accepted, False
    return accepted, low <= value <= high


def _float(type_name: str, value: Any) -> Any:
    try:
        struct.pack("<f" if type_name == "float32" else "<d", value)
    except (struct.error, OverflowError, TypeError):
        return f"a number in the range of {type_name}", False
    return "", True


def _bool(_: str, value: Any) -> Any:
    try:
        return "True or False", bool(value in (0, 1)) and not isinstance(value, float)
    except (TypeError, ValueError):
        return "True or False", False


def _string(_: str, value: Any) -> Any:
    if not isinstance(value, str):
        return "a string", False
    try:
        value.encode()
    except UnicodeEncodeError:
        return "a string that UTF-8 can express", False
    return "", True


def _time(type_name: str, value: Any) -> Any:
    low, high = (0, _LATEST) if type_name == "time" else (-_LONGEST, _LONGEST)
    accepted = f"finite seconds from {low} to {high}"
    try:
        seconds = float(value)
    except (TypeError, ValueError, OverflowError):
        return accepted, False
    plain = not isinstance(value, (bool, str, bytes))
    return accepted, plain and math.isfinite(seconds) and low - 5e-10 <= seconds < high


def _misfit(path: str, value: Any, accepted: str) -> str:
    return f"{path}: {shown(value)} does not fit; accepted is {accepted}"


_CHECKS = {"float32": _float, "float64": _float, "bool": _bool, "string": _string, "time": _time, "duration": _time}
