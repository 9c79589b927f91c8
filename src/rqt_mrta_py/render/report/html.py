"""HTML that is escaped by the way it is made: only what ``element`` gave is HTML, everything else is text."""

from __future__ import annotations

import json
from html import escape
from typing import Any, Iterable, Union

from rqt_mrta_py.render.text import printable

__all__ = ["Html", "element", "joined", "json_block", "words"]

_VOID = frozenset({"br", "col", "hr", "img", "input", "link", "meta"})
_LONGEST = 2000


class Html(str):
    """Text that is HTML already."""

    __slots__ = ()


Content = Union[str, int, float, None]
Attribute = Union[str, int, float, bool, None]


def element(tag: str, *content: Content, **attributes: Attribute) -> Html:
    """Make one element.

    Args:
        tag: its name, ours.
        content: text, which is escaped, and elements, which are not; None for nothing.
        attributes: by name, values are escaped; ``_`` stands for ``-``, one at the end is dropped (``class_``). True
            gives the name alone; None and False give nothing. Html is escaped too, but may be of any length.
    """
    parts = [tag]
    for key, value in attributes.items():
        if value is None or value is False:
            continue
        name = key.rstrip("_").replace("_", "-")
        told = value if isinstance(value, Html) else words(value)
        parts.append(name if value is True else f'{name}="{escape(told, quote=True)}"')
    head = f"<{' '.join(parts)}>"
    return Html(head if tag in _VOID else f"{head}{joined(content)}</{tag}>")


def joined(content: Iterable[Content]) -> Html:
    """Put content one after another; what is no HTML is escaped."""
    return Html(
        "".join(
            each if isinstance(each, Html) else escape(words(each), quote=True) for each in content if each is not None
        )
    )


def words(value: Any, longest: int = _LONGEST) -> str:
    """Make one printable line of anything, shortened where it is longer than a person would read."""
    return printable(str(value), longest)


def json_block(name: str, value: Any) -> Html:
    """Make a block of data for the page's script, which no browser takes for a script or an element.

    Args:
        name: id of the element.
        value: plain JSON.
    """
    text = json.dumps(value, ensure_ascii=True, allow_nan=False, separators=(",", ":"))
    for letter in "<>&'":
        text = text.replace(letter, f"\\u{ord(letter):04x}")
    return Html(f'<script type="application/json" id="{name}">{text}</script>')
