"""Ids in rqt_mrta files: robots, tasks, configs, launches."""

from __future__ import annotations

from rqt_mrta_py.config.xml.element import Element
from rqt_mrta_py.model import normalise_id
from rqt_mrta_py.wording import shown

__all__ = ["read_id", "written_id"]


def read_id(element: Element, name: str = "id") -> str:
    """Read the id of an element, without a leading slash.

    Args:
        element: robot, task, config or launch.
        name: of the child that holds the id.

    Returns:
        The id; empty where it is missing or not acceptable, which then is noted as a problem.
    """
    text = element.required(name)
    if any(character.isspace() for character in text):
        element.problem(name, f"must not contain a space (got {shown(text)})")
        return ""
    return normalise_id(text)


def written_id(name: str) -> str:
    """Spell an id so that its reader, who drops one leading slash, gives the same again."""
    return f"/{name}" if name.startswith("/") else name
