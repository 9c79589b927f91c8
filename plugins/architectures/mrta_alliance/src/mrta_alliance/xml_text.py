"""XML documents with whatever ids of robots and tasks may hold."""

from __future__ import annotations

import re
from xml.etree import ElementTree

__all__ = ["document", "plain"]

_FORBIDDEN = re.compile("[^\t\n\r\x20-\ud7ff\ue000-\ufffd\U00010000-\U0010ffff]")
"""What XML 1.0 has no way to write."""


def plain(text: str) -> str:
    """Give a text with what XML cannot hold replaced by U+FFFD."""
    return _FORBIDDEN.sub("\ufffd", text)


def document(root: ElementTree.Element) -> bytes:
    """Write a document, an element a line."""
    _indent(root, "\n")
    body: str = ElementTree.tostring(root, encoding="unicode")
    return f'<?xml version="1.0" encoding="UTF-8"?>\n{body}\n'.encode()


def _indent(element: ElementTree.Element, edge: str) -> None:
    """Put each child on a line of its own; ElementTree can do so from Python 3.9 on."""
    if len(element) == 0:
        return
    element.text = edge + "  "
    for child in element:
        _indent(child, edge + "  ")
        child.tail = edge + "  "
    element[-1].tail = edge
