"""Values of parameters: from text or YAML to the type that a template asks for."""

from __future__ import annotations

import math
import re
from typing import Any, Union

from rqt_mrta_py.model import ParameterType
from rqt_mrta_py.wording import shown

__all__ = ["WANTED", "Scalar", "check_value", "parse_text"]

Scalar = Union[bool, int, float, str]

_INT = re.compile(r"[+-]?[0-9]{1,18}\Z")
_DOUBLE = re.compile(r"[+-]?([0-9]+(\.[0-9]*)?|\.[0-9]+)([eE][+-]?[0-9]+)?\Z")
WANTED = {
    ParameterType.BOOL: "true or false",
    ParameterType.INT: "a whole number",
    ParameterType.DOUBLE: "a finite number",
    ParameterType.STRING: "a text",
}
"""What a type accepts, in words."""


def parse_text(text: str, kind: ParameterType) -> Scalar:
    """Turn the text of an XML file or of the command line into a value.

    Args:
        text: trimmed, without tokens.
        kind: the type asked for.

    Raises:
        ValueError: the text is no value of that type; the message says what is accepted.
    """
    if kind is ParameterType.STRING:
        return text
    if kind is ParameterType.BOOL and text.lower() in ("true", "false"):
        return text.lower() == "true"
    if kind is ParameterType.INT and _INT.match(text):
        return int(text)
    if kind is ParameterType.DOUBLE and _DOUBLE.match(text):
        value = float(text)
        if math.isfinite(value):
            return value
    raise ValueError(f"must be {WANTED[kind]} (got {shown(text)})")


def check_value(value: Any, kind: ParameterType) -> Scalar:
    """Take a value from YAML as a value of a type; whole numbers pass as finite numbers, nothing else is converted.

    Args:
        value: as YAML gives it.
        kind: the type asked for.

    Raises:
        ValueError: the value is not of that type; the message says what is accepted.
    """
    if kind is ParameterType.BOOL and isinstance(value, bool):
        return value
    if kind is ParameterType.INT and isinstance(value, int) and not isinstance(value, bool):
        return value
    if kind is ParameterType.DOUBLE and isinstance(value, (int, float)) and not isinstance(value, bool):
        try:
            number = float(value)
        except OverflowError:
            number = math.inf
        if math.isfinite(number):
            return number
    if kind is ParameterType.STRING and isinstance(value, str):
        return value
    hint = "; put it in quotes" if kind is ParameterType.STRING and isinstance(value, (bool, int, float)) else ""
    raise ValueError(f"must be {WANTED[kind]} (got {shown(value)}){hint}")
