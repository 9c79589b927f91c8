"""Building an rqt_mrta.xml from top to bottom: leaves, holders, numbered elements, each text checked on the way."""

from __future__ import annotations

import re
from typing import Callable, Iterable, Optional, TypeVar

from lxml import etree

from rqt_mrta_py.config.problems import Problems
from rqt_mrta_py.config.xml.text import joined
from rqt_mrta_py.wording import shown

__all__ = ["Branch", "document_text"]

_Value = TypeVar("_Value")

_DECLARATION = '<?xml version="1.0" encoding="UTF-8"?>\n'
_INDENT = "    "
_NOT_XML = re.compile("[^\t\n\r\u0020-\ud7ff\ue000-\ufffd\U00010000-\U0010ffff]")


class Branch:
    """An element that is being written.

    Args:
        node: the element.
        path: names of the elements from below the root down to this one, joined by ``/``; empty for the root.
        problems: where to note texts that no file can hold.
    """

    def __init__(self, node: etree._Element, path: str, problems: Problems) -> None:
        self._node = node
        self._problems = problems
        self.path = path

    def inner(self, name: str) -> Branch:
        """Append an element that holds others."""
        return Branch(etree.SubElement(self._node, name), self._at(name), self._problems)

    def leaf(self, name: str, text: Optional[str]) -> None:
        """Append an element that holds a text; nothing for None and for an empty text, which mean the same."""
        if not text:
            return
        bad = _NOT_XML.search(text)
        if bad is not None:
            self._problems.add(0, self._at(name), f"holds {shown(bad.group())}, which XML cannot hold; leave it out")
        elif joined(text) != text:
            message = f"must be one line without white space around it, as a reader gives it (got {shown(text)})"
            self._problems.add(0, self._at(name), message)
        else:
            etree.SubElement(self._node, name).text = text

    def numbered(self, kind: str, values: Iterable[_Value], write: Callable[[Branch, _Value], None]) -> None:
        """Append an element for each of some values, numbered from 0.

        Args:
            kind: ``robot`` for ``robot_0``, ``robot_1`` and so on.
            values: in their order.
            write: fills in an element.
        """
        for number, value in enumerate(values):
            write(self.inner(f"{kind}_{number}"), value)

    def refuse(self, message: str) -> None:
        """Note that this element cannot be written as it is."""
        self._problems.add(0, self.path, message)

    def _at(self, name: str) -> str:
        return "/".join(part for part in (self.path, name) if part)


def document_text(root: etree._Element) -> str:
    """Give a document as text: declaration, four spaces a level, a line break at the end."""
    etree.indent(root, space=_INDENT)
    return f"{_DECLARATION}{etree.tostring(root, encoding='unicode')}\n"
