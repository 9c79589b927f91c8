"""The ``launches`` element of the rqt_mrta grammar."""

from __future__ import annotations

from typing import Dict, List, Tuple

from rqt_mrta_py.config.xml.element import Element
from rqt_mrta_py.config.xml.ids import read_id
from rqt_mrta_py.model import IncludeSpec, LaunchArgument, LaunchTemplate

__all__ = ["read_launches"]


def read_launches(root: Element, places: Dict[str, str]) -> Tuple[LaunchTemplate, ...]:
    """Read all launches of a file.

    Args:
        root: the document's root element.
        places: is given the id of each launch that is returned, by its element.

    Returns:
        The launches in the order of their numbers.
    """
    holder = root.child("launches")
    if holder is None:
        return ()
    launches: Dict[str, LaunchTemplate] = {}
    for _, _, element in holder.numbered(["launch"]):
        name = read_id(element)
        includes = element.child("includes")
        found: List[IncludeSpec] = []
        if includes is not None:
            found = [_read_include(entry.element) for entry in includes.numbered(["include"])]
            includes.finish()
        element.finish()
        if name in launches:
            element.problem("id", f"{name!r} names two launches")
        elif name:
            launches[name] = LaunchTemplate(name, tuple(found))
            places[element.path] = name
    holder.finish()
    return tuple(launches.values())


def _read_include(element: Element) -> IncludeSpec:
    file = element.required("file")
    holder = element.child("args")
    arguments: List[LaunchArgument] = []
    if holder is not None:
        for _, _, entry in holder.numbered(["arg"]):
            arguments.append(LaunchArgument(entry.required("name"), entry.string("value"), entry.string("default")))
            entry.finish()
        holder.finish()
    element.finish()
    return IncludeSpec(file, tuple(arguments))
