"""An XML document that is edited in place: comments, layout and everything around the root stay as they are."""

from __future__ import annotations

import re
from typing import Dict, List, NamedTuple, Optional, Sequence, Tuple
from xml.parsers import expat

from lxml import etree

from rqt_mrta_py.config.xml.text import decode_xml, parse_xml

__all__ = ["NumberedNode", "XmlDocument"]

_NUMBERED = re.compile(r"(\w+?)_([0-9]{1,9})\Z")
_ENCODING = re.compile(r"""(\A\s*<\?xml[^>]*?encoding\s*=\s*["'])[A-Za-z0-9._-]+""")
_UNIT = "    "


class NumberedNode(NamedTuple):
    """A numbered element: its kind (``param`` of ``param_3``), its number, itself."""

    kind: str
    number: int
    node: etree._Element


class XmlDocument:
    """The tree of an rqt_mrta.xml, with the operations that edits are made of.

    Args:
        raw: the whole file.
        path: by which problems name it.

    Raises:
        ConfigError: it is not XML that is accepted here.
    """

    def __init__(self, raw: bytes, path: str) -> None:
        parse_xml(raw, path)
        text = _ENCODING.sub(r"\1UTF-8", decode_xml(raw))
        start, end = _extent(text)
        self._before, self._after = text[:start], text[end:]
        self._breaks = "\r\n" if "\r\n" in text else "\n"
        self.root = etree.fromstring(text[start:end].encode("utf-8"), _parser())
        self.path = path

    def text(self) -> str:
        """Give the whole file, to be written as UTF-8."""
        body = etree.tostring(self.root, encoding="unicode", with_tail=False)
        if self._breaks != "\n":
            body = body.replace("\n", self._breaks)
        return f"{self._before}{body}{self._after}"

    def child(self, parent: etree._Element, name: str) -> etree._Element:
        """Give the child of a name, which is made where it is missing."""
        found = parent.find(name)
        return found if found is not None else self.add(parent, name)

    def numbered(self, parent: Optional[etree._Element], kinds: Sequence[str]) -> List[NumberedNode]:
        """Give the numbered children of some kinds that are not empty, sorted by number; none without a parent."""
        found = []
        for node in _elements(parent) if parent is not None else ():
            match = _NUMBERED.match(str(node.tag))
            if match is not None and match.group(1) in kinds and (len(node) or (node.text or "").strip()):
                found.append(NumberedNode(match.group(1), int(match.group(2)), node))
        return sorted(found, key=lambda each: each.number)

    def add_numbered(
        self, parent: etree._Element, kind: str, kinds: Sequence[str], leaves: Sequence[Tuple[str, str]] = ()
    ) -> etree._Element:
        """Add a numbered child after all others.

        Args:
            parent: of the new element.
            kind: of the new element.
            kinds: that share the counter.
            leaves: tags and texts of its children.
        """
        taken = [
            int(match.group(2))
            for node in _elements(parent)
            for match in [_NUMBERED.match(str(node.tag))]
            if match is not None and match.group(1) in kinds
        ]
        return self.add(parent, f"{kind}_{max(taken, default=-1) + 1}", leaves)

    def add(self, parent: etree._Element, tag: str, leaves: Sequence[Tuple[str, str]] = ()) -> etree._Element:
        """Add a child after all others, laid out as they are.

        Args:
            parent: of the new element.
            tag: of the new element.
            leaves: tags and texts of its children.
        """
        siblings = _elements(parent)
        model = next((node for node in reversed(siblings) if len(node)), None)
        one_line = model is not None and "\n" not in (model.text or "")
        depth = sum(1 for _ in parent.iterancestors()) + 1
        if siblings:
            last = parent[-1]
            gap = parent.text or ""
            closing, last.tail = last.tail, gap
        else:
            gap, closing = self._indent(depth), self._indent(depth - 1)
            parent.text = gap
        node = etree.SubElement(parent, tag)
        node.tail = closing
        for index, (name, text) in enumerate(leaves):
            leaf = etree.SubElement(node, name)
            leaf.text = text
            is_last = index == len(leaves) - 1
            leaf.tail = " " if one_line else self._indent(depth if is_last else depth + 1)
        if leaves:
            node.text = " " if one_line else self._indent(depth + 1)
        return node

    def remove(self, node: etree._Element) -> None:
        """Take an element away with the line that it stands on."""
        parent = node.getparent()
        if parent is None:
            raise ValueError("the root cannot be removed")
        before = node.getprevious()
        if node.getnext() is None:
            # The last one: what stands before it takes over the line break before the end of the parent.
            if before is not None:
                before.tail = node.tail
            else:
                parent.text = node.tail
        parent.remove(node)

    def renumber(self, parent: Optional[etree._Element], kinds: Sequence[str]) -> None:
        """Let numbers count on from 0 without gaps, as the original wants them."""
        for number, (kind, _, node) in enumerate(self.numbered(parent, kinds)):
            node.tag = f"{kind}_{number}"

    def _indent(self, depth: int) -> str:
        first = self.root.text or ""
        unit = first.rsplit("\n", 1)[1] if "\n" in first else _UNIT
        return "\n" + (unit or _UNIT) * depth


def _elements(parent: etree._Element) -> List[etree._Element]:
    return [node for node in parent if isinstance(node.tag, str)]


def _extent(text: str) -> Tuple[int, int]:
    """Find where the root element begins and ends."""
    raw = text.encode("utf-8")
    walker = expat.ParserCreate("utf-8")
    where: Dict[str, int] = {}
    depth = 0

    def opened(_name: str, _attributes: object) -> None:
        nonlocal depth
        where.setdefault("start", walker.CurrentByteIndex)
        depth += 1

    def closed(_name: str) -> None:
        nonlocal depth
        depth -= 1
        if not depth:
            where["end"] = raw.index(b">", walker.CurrentByteIndex) + 1

    walker.StartElementHandler = opened
    walker.EndElementHandler = closed
    walker.Parse(raw, True)
    return len(raw[: where["start"]].decode("utf-8")), len(raw[: where["end"]].decode("utf-8"))


def _parser() -> etree.XMLParser:
    return etree.XMLParser(
        encoding="utf-8", resolve_entities=False, no_network=True, load_dtd=False, strip_cdata=False, recover=False
    )
