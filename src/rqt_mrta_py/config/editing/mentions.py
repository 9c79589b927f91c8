"""Where a scenario names a robot or task, and what tasks name one another."""

from __future__ import annotations

from typing import Iterator, List, NamedTuple, Optional

import yaml

from rqt_mrta_py.config.editing.yaml_document import YamlDocument
from rqt_mrta_py.errors import Problem
from rqt_mrta_py.model import normalise_id

__all__ = ["Mention", "entry_index", "event_mentions", "predecessor_mentions", "problems_of"]


class Mention(NamedTuple):
    """A scalar that names a robot or task.

    Attributes:
        node: the scalar.
        element: where it stands, such as ``events[0]/robot``.
    """

    node: yaml.ScalarNode
    element: str


def entry_index(document: YamlDocument, key: str, name: str) -> Optional[int]:
    """Give the index of the entry with an id, in the list under a key; None if there is none."""
    for index, entry in enumerate(document.entries(key)):
        if any(_names(node, name) for node in _scalars(entry, "id")):
            return index
    return None


def id_mentions(document: YamlDocument, key: str, name: str) -> List[Mention]:
    """Find the id of an entry itself, in the list under a key."""
    return [
        Mention(node, f"{key}[{index}]/id")
        for index, entry in enumerate(document.entries(key))
        for node in _scalars(entry, "id")
        if _names(node, name)
    ]


def event_mentions(document: Optional[YamlDocument], key: str, name: str) -> List[Mention]:
    """Find the events of a scenario that name a robot (``robot``, and groups of a partition) or a task (``task``)."""
    found = []
    for index, entry in enumerate(document.entries("events") if document is not None else ()):
        found += [Mention(node, f"events[{index}]/{key}") for node in _scalars(entry, key) if _names(node, name)]
        if key == "robot":
            for name_node, parameters in entry.value:
                if name_node.value == "parameters" and isinstance(parameters, yaml.MappingNode):
                    inside = _scalars(parameters, "groups")
                    element = f"events[{index}]/parameters/groups"
                    found += [Mention(node, element) for node in inside if _names(node, name)]
    return found


def predecessor_mentions(document: Optional[YamlDocument], name: str) -> List[Mention]:
    """Find the tasks that come after a task."""
    return [
        Mention(node, f"tasks[{index}]/predecessors")
        for index, entry in enumerate(document.entries("tasks") if document is not None else ())
        for node in _scalars(entry, "predecessors")
        if _names(node, name)
    ]


def problems_of(document: Optional[YamlDocument], mentions: List[Mention], what: str) -> List[Problem]:
    """Say of each mention that it stands in the way of a removal."""
    path = document.path if document is not None else ""
    message = f"names {what}, which is to be removed; change this first"
    return [Problem(path, each.node.start_mark.line + 1, each.element, message) for each in mentions]


def _scalars(entry: yaml.MappingNode, key: str) -> List[yaml.ScalarNode]:
    return [scalar for name, value in entry.value if name.value == key for scalar in _leaves(value)]


def _leaves(node: yaml.Node) -> Iterator[yaml.ScalarNode]:
    if isinstance(node, yaml.ScalarNode):
        yield node
    elif isinstance(node, yaml.SequenceNode):
        for inner in node.value:
            yield from _leaves(inner)


def _names(node: yaml.ScalarNode, name: str) -> bool:
    return normalise_id(node.value) == name
