"""How a form of an XML file is told as data: its elements, what they hold, who reads them."""

from __future__ import annotations

from dataclasses import dataclass
from enum import Enum
from typing import Dict, Iterator, Mapping, Tuple

__all__ = ["Content", "ElementForm", "XmlForm"]


class Content(Enum):
    """What an element holds; the value is how the documentation calls it."""

    ELEMENTS = "elements"
    TEXT = "a text"
    ID = "a name without blanks"
    TOPIC = "an absolute topic"
    MESSAGE_TYPE = "a message type"
    FIELD = "a path of fields"
    WHOLE = "a whole number from 0"
    SECONDS = "a number above 0"
    NOTHING = "nothing"


@dataclass(frozen=True)
class ElementForm:
    """One element.

    Attributes:
        name: as written, without the number of a numbered one.
        summary: one sentence.
        content: what it holds.
        reader: who makes use of it.
        unit: of a number; empty for a text or a count.
        default: what its absence means, in words or as text; empty if nothing.
        required: True if its parent, unless itself left out, must hold it.
        numbered: True if it stands as ``<name>_0``, ``<name>_1`` and so on.
        plain: True if it may stand without a number; where it may do both, any number of times.
        ours: True if the original does not know it.
        spellings: texts that are understood, where not every text is.
        children: in the order of the documentation.
        group: name of a group of further children, which may hold one another; empty if none.
        blank: True if it is passed over where none of its children of content text says anything.
    """

    name: str
    summary: str
    content: Content = Content.ELEMENTS
    reader: str = ""
    unit: str = ""
    default: str = ""
    required: bool = False
    numbered: bool = False
    plain: bool = True
    ours: bool = False
    spellings: Tuple[str, ...] = ()
    children: Tuple[ElementForm, ...] = ()
    group: str = ""
    blank: bool = False

    @property
    def step(self) -> str:
        """Its name in paths."""
        return self.names[0]

    @property
    def names(self) -> Tuple[str, ...]:
        """The names that it may bear, ``<n>`` for a number."""
        numbered = (f"{self.name}_<n>",) if self.numbered else ()
        return (self.name, *numbered) if self.plain else numbered


@dataclass(frozen=True)
class XmlForm:
    """The form of one kind of file.

    Attributes:
        name: of the kind.
        summary: one sentence.
        root: the root element.
        format: what its attribute ``format`` says where it is given.
        groups: groups of elements that may hold one another, by name.
    """

    name: str
    summary: str
    root: ElementForm
    format: str
    groups: Mapping[str, Tuple[ElementForm, ...]]

    def inside(self, element: ElementForm) -> Tuple[ElementForm, ...]:
        """List all children that an element may have, those of its group last."""
        return (*element.children, *self.groups.get(element.group, ()))

    def walk(self) -> Iterator[Tuple[str, ElementForm]]:
        """Give every element below the root with its path; those of a group only where they are met first."""
        pending = [(child.step, child) for child in reversed(self.inside(self.root))]
        seen: Dict[str, None] = {}
        while pending:
            path, element = pending.pop()
            yield path, element
            inner = element.children if element.group in seen else self.inside(element)
            seen[element.group] = None
            pending.extend((f"{path}/{child.step}", child) for child in reversed(inner))
