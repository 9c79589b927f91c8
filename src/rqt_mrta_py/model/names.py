"""Names of the ROS graph, resolved as ROS resolves them."""

from __future__ import annotations

import re
from typing import Mapping, Optional

__all__ = ["ROBOT_TOKEN", "TASK_TOKEN", "is_legal_name", "resolve_name"]

ROBOT_TOKEN = "@robot_id@"
"""Stands for the id of a robot, in names of topics and in parameters."""

TASK_TOKEN = "@task_id@"
"""Stands for the id of a task likewise."""

_LEGAL = re.compile(r"[~/A-Za-z][A-Za-z0-9_/]*\Z")


def is_legal_name(name: str) -> bool:
    """Tell whether ROS accepts a name: a letter, ``/`` or ``~`` first, then letters, digits, ``_`` and ``/``."""
    return _LEGAL.match(name) is not None and "//" not in name and not (len(name) > 1 and name.endswith("/"))


def resolve_name(name: str, node: str, remappings: Optional[Mapping[str, str]] = None) -> str:
    """Resolve a name for one node.

    Args:
        name: global (``/img``), relative (``img``) or private (``~img``).
        node: resolved name of the node, with its leading slash.
        remappings: from name to name, either side in any of the three forms.

    Returns:
        The global name.

    Raises:
        ValueError: the name is empty or not legal.
    """
    resolved = _resolve(name, node)
    for source, target in (remappings or {}).items():
        if _resolve(source, node) == resolved:
            return _resolve(target, node)
    return resolved


def _resolve(name: str, node: str) -> str:
    if not is_legal_name(name):
        raise ValueError(f"{name!r} is not a name that ROS accepts: letters, digits, _ and /, a letter, / or ~ first")
    if name.startswith("/"):
        return name
    if name.startswith("~"):
        return f"{node}/{name[1:].lstrip('/')}"
    return f"{node.rsplit('/', 1)[0]}/{name}"
