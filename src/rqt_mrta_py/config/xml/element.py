"""A cursor over an XML element: typed getters that note problems with their line, and a check that all was read."""

from __future__ import annotations

import re
from typing import Dict, List, NamedTuple, Optional, Sequence, Tuple, Union

from lxml import etree

from rqt_mrta_py.config.parameters.values import parse_text
from rqt_mrta_py.config.problems import Problems
from rqt_mrta_py.config.xml.text import joined, line_of, lines_of, parse_xml
from rqt_mrta_py.model import ParameterType
from rqt_mrta_py.wording import accepted, shown

__all__ = ["Element", "Numbered", "Text", "open_document"]

_NUMBER = re.compile(r"_[0-9]+\Z")
_NUMBERED = re.compile(r"(\w+?)_([0-9]{1,9})\Z")


class Text(NamedTuple):
    """The trimmed text of a leaf element, and its line."""

    value: str
    line: int


class Numbered(NamedTuple):
    """A numbered element: its kind (``param`` of ``param_3``), its number, itself."""

    kind: str
    number: int
    element: Element


class Element:
    """One element of a document, read once from top to bottom.

    Args:
        node: the element.
        path: names of the elements from below the root down to this one, joined by ``/``; empty for the root.
        problems: where to note what is wrong.
    """

    def __init__(self, node: etree._Element, path: str, problems: Problems) -> None:
        self._node = node
        self._problems = problems
        self._children: List[etree._Element] = [child for child in node if isinstance(child.tag, str)]
        self._unread = dict(enumerate(self._children))
        self._known: Dict[str, None] = {}
        self._unread_attributes = {str(name): str(value) for name, value in node.attrib.items()}
        self._known_attributes: Dict[str, None] = {}
        self.path = path

    @property
    def line(self) -> int:
        """The 1-based line on which it begins."""
        return line_of(self._node)

    @property
    def lines(self) -> Tuple[int, int]:
        """The 1-based lines on which it begins, and the last element within it."""
        return lines_of(self._node)

    @property
    def tag(self) -> str:
        """Its name."""
        return str(self._node.tag)

    @property
    def empty(self) -> bool:
        """True if it holds neither elements nor text; equals an absent one."""
        return not self._children and not joined(self._node.text)

    @property
    def flaws(self) -> Tuple[str, ...]:
        """Elements of the document of which a problem was noted so far, as problems name them."""
        return self._problems.elements

    def has(self, name: str) -> bool:
        """Tell whether there is a child of a name that is not empty, without counting it as read."""
        return any(node.tag == name and (len(node) or joined(node.text)) for node in self._unread.values())

    def problem(self, name: str, message: str, line: Optional[int] = None) -> None:
        """Note a problem of this element, or of the child called ``name`` where that is not empty."""
        self._problems.add(self.line if line is None else line, self._at(name), message)

    def attribute(self, name: str) -> Optional[str]:
        """Give an attribute's trimmed value; None if it is absent."""
        self._known_attributes[name] = None
        value = self._unread_attributes.pop(name, None)
        return None if value is None else value.strip()

    def child(self, name: str) -> Optional[Element]:
        """Give the child of a name; None if it is absent or empty."""
        found = self.repeated(name)
        for extra in found[1:]:
            extra.problem("", f"stands twice; the first one is in line {found[0].line}")
        return found[0] if found and not found[0].empty else None

    def repeated(self, name: str) -> List[Element]:
        """Give all children of a name, in file order."""
        self._known[name] = None
        indices = [index for index, node in self._unread.items() if node.tag == name]
        return [Element(self._unread.pop(index), self._at(name), self._problems) for index in indices]

    def numbered(self, kinds: Sequence[str]) -> List[Numbered]:
        """Give the numbered children of some kinds, sorted by number, whatever their order in the file.

        Args:
            kinds: for instance ``param`` for ``param_0``, ``param_1`` and so on; all kinds share one counter.

        Returns:
            The children, empty ones left out. Numbers only order, so gaps are accepted; a number that stands twice
            is a problem.
        """
        self._known.update(dict.fromkeys(f"{kind}_<number>" for kind in kinds))
        found: Dict[int, Numbered] = {}
        for index, node in list(self._unread.items()):
            match = _NUMBERED.match(str(node.tag))
            if match is None or match.group(1) not in kinds:
                continue
            element = Element(self._unread.pop(index), self._at(str(node.tag)), self._problems)
            number = int(match.group(2))
            if element.empty:
                continue
            if number in found:
                first = found[number].element
                element.problem("", f"number {number} is taken by {first.tag} in line {first.line}; count on")
            else:
                found[number] = Numbered(match.group(1), number, element)
        return [found[number] for number in sorted(found)]

    def text(self, name: str) -> Optional[Text]:
        """Give the text of a leaf child, trimmed, wrapped lines joined by one space; None if absent or empty."""
        child = self.child(name)
        if child is None:
            return None
        value = child.leaf()
        return Text(value, child.line) if value else None

    def string(self, name: str, default: str = "") -> str:
        """Give the text of a leaf child, or the default if it is absent or empty."""
        found = self.text(name)
        return default if found is None else found.value

    def required(self, name: str) -> str:
        """Give the text of a leaf child that must be there; its absence is a problem."""
        found = self.text(name)
        if found is None:
            self.problem(name, "is missing or empty; give a text")
            return ""
        return found.value

    def whole(self, name: str, default: int) -> int:
        """Give a whole number, not negative, or the default if it is absent."""
        found = self.text(name)
        if found is None:
            return default
        if not re.match(r"[0-9]{1,9}\Z", found.value):
            self.problem(name, f"must be a whole number from 0 (got {shown(found.value)})", found.line)
            return default
        return int(found.value)

    def seconds(self, name: str, default: float) -> float:
        """Give a duration above 0 [s], or the default if it is absent."""
        found = self.text(name)
        if found is None:
            return default
        try:
            value = parse_text(found.value, ParameterType.DOUBLE)
        except ValueError:
            value = 0.0
        if not (isinstance(value, float) and value > 0.0):
            self.problem(name, f"must be above 0 s (got {shown(found.value)}); give a positive number", found.line)
            return default
        return value

    def leaf(self) -> str:
        """Give this element's own text; elements within are a problem."""
        value = joined(self._node.text)
        self._known.clear()
        self.finish(text_allowed=True)
        return value

    def ignore(self, *names: str) -> None:
        """Accept children that the original is known to write and nothing reads."""
        for name in names:
            for child in self.repeated(name):
                child.skip()

    def skip(self) -> None:
        """Count everything within as read."""
        self._unread.clear()
        self._unread_attributes.clear()

    def finish(self, text_allowed: bool = False) -> None:
        """Note as problems what nobody asked for: elements, attributes and, in a container, text."""
        for node in self._unread.values():
            name = str(node.tag)
            if f"{name}_<number>" in self._known:
                message = f"bears no number; call it {name}_0, the next one {name}_1 and so on"
            else:
                message = f"is not expected here; {accepted(_NUMBER.sub('_<number>', name), self._known)}"
            self._problems.add(line_of(node), self._at(name), message)
        for name in self._unread_attributes:
            self.problem(f"@{name}", f"is not expected here; {accepted(name, self._known_attributes)}")
        if not text_allowed:
            texts = [self._node.text, *(child.tail for child in self._children)]
            stray = next((text for text in texts if joined(text)), None)
            if stray is not None:
                self.problem("", f"holds the text {shown(joined(stray))}; only elements are expected here")
        self.skip()

    def _at(self, name: str) -> str:
        return "/".join(part for part in (self.path, name) if part)


def open_document(text: Union[str, bytes], path: str, root: str, problems: Problems) -> Element:
    """Parse a document and put a cursor on its root.

    Args:
        text: the document.
        path: by which problems name it.
        root: the name that its root element must have.
        problems: where the cursor notes what is wrong.

    Raises:
        ConfigError: the text is not XML that is accepted here, or its root is another one.
    """
    node = parse_xml(text, path)
    if node.tag != root:
        problems.add(line_of(node), str(node.tag), f"is not the root of such a file; accepted: {root}")
        problems.raise_if_any()
    return Element(node, "", problems)
