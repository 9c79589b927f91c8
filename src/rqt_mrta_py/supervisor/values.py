"""What fields of messages hold, as texts and times."""

from __future__ import annotations

from typing import Any, Mapping

from rqt_mrta_py.hooks import Heard

__all__ = ["STAMP", "meets", "stamp_of", "text_of"]

STAMP = "header/stamp"


def text_of(fields: Mapping[str, Any], path: str) -> str:
    """Read an id: a text as it stands, a whole number as its digits; empty if it is anything else or not there."""
    value = fields.get(path, "") if path else ""
    if isinstance(value, str):
        return value
    return str(value) if isinstance(value, int) and not isinstance(value, bool) else ""


def meets(fields: Mapping[str, Any], path: str, text: str) -> bool:
    """Tell whether a field has a value, given as a text: a string, a whole number, ``true`` or ``false``."""
    value = fields.get(path)
    if isinstance(value, bool):
        return text == ("true" if value else "false")
    return isinstance(value, (str, int)) and str(value) == text


def stamp_of(heard: Heard) -> float:
    """Read a message's header stamp [s]; 0 if it has none or its subscriber did not ask for it."""
    value = heard.fields.get(STAMP, 0.0)
    return float(value) if isinstance(value, (int, float)) else 0.0
