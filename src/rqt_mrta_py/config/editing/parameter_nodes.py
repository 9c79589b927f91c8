"""Configs within the tree of an rqt_mrta.xml: values found, set and taken out by their paths."""

from __future__ import annotations

from typing import Iterator, List, NamedTuple, Optional, Tuple

from lxml import etree

from rqt_mrta_py.config.editing.xml_document import XmlDocument
from rqt_mrta_py.config.parameters.context import Path
from rqt_mrta_py.config.parameters.team import file_name
from rqt_mrta_py.model import ParameterType, normalise_id

__all__ = ["ParameterNodes", "PlacedNode", "text_of"]

KINDS = ("param", "params", "array")


class PlacedNode(NamedTuple):
    """A named element of a config.

    Attributes:
        node: ``param_<k>``, ``params_<k>`` or ``array_<k>``.
        is_value: True if it is a single parameter.
        path: its own, from the top of the config.
        depth: how much of the path belongs to what it stands in.
    """

    node: etree._Element
    is_value: bool
    path: Path
    depth: int


class ParameterNodes:
    """The configs of an application's rqt_mrta.xml.

    Args:
        document: is changed.
    """

    def __init__(self, document: XmlDocument) -> None:
        self._document = document

    def configs(self) -> List[Tuple[str, etree._Element]]:
        """Give all configs, each by the name of its file."""
        nodes = self._document.numbered(self._document.root.find("configs"), ["config"])
        return [(file_name(normalise_id(text_of(each.node, "id"))), each.node) for each in nodes]

    def config(self, name: str) -> Optional[etree._Element]:
        """Give the config of a name; None if there is none."""
        return dict(self.configs()).get(name)

    def remove_config(self, name: str) -> None:
        """Take a config out, if there is one of this name."""
        config = self.config(name)
        if config is not None:
            parent = config.getparent()
            self._document.remove(config)
            self._document.renumber(parent, ["config"])

    def walk(self, config: etree._Element, path: Path = ()) -> Iterator[PlacedNode]:
        """Give every named element of a config, groups before what they hold."""
        for kind, _, node in self._document.numbered(config, KINDS):
            here = (*path, *(part for part in text_of(node, "name").split("/") if part))
            yield PlacedNode(node, kind == "param", here, len(path))
            if kind != "param":
                yield from self.walk(node, here)

    def find(self, config: Optional[etree._Element], path: Path) -> Optional[PlacedNode]:
        """Give the element of a path, the last one where several have it; None if there is none."""
        found = [placed for placed in self.walk(config) if placed.path == path] if config is not None else []
        return found[-1] if found else None

    def value(self, config: Optional[etree._Element], path: Path) -> Optional[str]:
        """Give the text that a config has for a parameter; None if it has none."""
        placed = self.find(config, path)
        if placed is None or not placed.is_value:
            return None
        return text_of(placed.node, "value") or text_of(placed.node, "default") or None

    def set_value(self, name: str, path: Path, kind: ParameterType, text: str) -> None:
        """Give a parameter a value; config, groups and parameter are made where they are missing.

        Args:
            name: of the config.
            path: of the parameter.
            kind: type that a new parameter gets.
            text: the value.
        """
        config = self.config(name)
        if config is None:
            holder = self._document.child(self._document.root, "configs")
            config = self._document.add_numbered(holder, "config", ["config"], [("id", name)])
        placed = self.find(config, path)
        if placed is not None and placed.is_value:
            self.set_text(placed, "value", text)
            return
        node, depth = config, 0
        for group in self.walk(config):
            if not group.is_value and path[: len(group.path)] == group.path and depth < len(group.path) < len(path):
                node, depth = group.node, len(group.path)
        for part in path[depth:-1]:
            node = self._document.add_numbered(node, "params", KINDS, [("name", part)])
        leaves = [("name", path[-1]), ("type", kind.value), ("value", text)]
        self._document.add_numbered(node, "param", KINDS, leaves)

    def set_text(self, placed: PlacedNode, leaf: str, text: str) -> None:
        """Give a leaf of an element another text, such as the ``value`` of a parameter."""
        self._document.child(placed.node, leaf).text = text

    def remove(self, placed: PlacedNode) -> None:
        """Take an element out, and the groups that hold nothing more then, and the config."""
        node = placed.node
        while True:
            parent = node.getparent()
            if parent is None:
                raise ValueError(f"{node.tag} does not stand in a config")
            self._document.remove(node)
            self._document.renumber(parent, ["config"] if parent.tag == "configs" else KINDS)
            if parent.tag == "configs" or self._document.numbered(parent, KINDS):
                return
            node = parent

    def rename(self, placed: PlacedNode, part: int, name: str) -> None:
        """Give one part of an element's path another name; it is a part of the element's own name."""
        own = [*placed.path[placed.depth :]]
        own[part - placed.depth] = name
        self.set_text(placed, "name", "/".join(own))


def text_of(node: etree._Element, name: str) -> str:
    """Give the trimmed text of a leaf child; empty where it is absent."""
    return (node.findtext(name) or "").strip()
