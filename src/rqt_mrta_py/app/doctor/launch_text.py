"""roslaunch's XML as far as one file tells it without being launched: arguments, inclusions, ``$(...)``."""

from __future__ import annotations

import re
from pathlib import Path
from typing import Dict, Iterator, Mapping, NamedTuple, Optional, Tuple

from lxml import etree

from rqt_mrta_py.config.xml.text import line_of

__all__ = ["Argument", "Inclusion", "active_nodes", "arguments_of", "inclusions_of", "packages_in", "resolved_path"]

_SUBSTITUTION = re.compile(r"\$\(\s*(\w+)((?:\s[^()]*)?)\)")
_FIND = ("find", "findr")
_GROUPS = ("launch", "group")


class Argument(NamedTuple):
    """An ``arg`` that a launch file declares.

    Attributes:
        name: of the argument.
        value: fixed in the file; None if callers may give it.
        default: taken where a caller gives none; None if there is none.
        line: 1-based.
    """

    name: str
    value: Optional[str]
    default: Optional[str]
    line: int

    @property
    def is_mandatory(self) -> bool:
        """True if a caller has to give a value."""
        return self.value is None and self.default is None


class Inclusion(NamedTuple):
    """An ``include`` of a launch file.

    Attributes:
        file: as it is written.
        arguments: line by name.
        passes_all: True if it hands on what its own file was given.
        line: 1-based.
    """

    file: str
    arguments: Mapping[str, int]
    passes_all: bool
    line: int


def arguments_of(root: etree._Element) -> Dict[str, Argument]:
    """List the arguments that a launch file declares; of one name the first, or one that is optional.

    Args:
        root: its ``launch`` element.
    """
    found: Dict[str, Argument] = {}
    for node in active_nodes(root):
        parent = node.getparent()
        if node.tag != "arg" or not node.get("name") or parent is None or parent.tag not in _GROUPS:
            continue
        argument = Argument(str(node.get("name")), node.get("value"), node.get("default"), line_of(node))
        before = found.get(argument.name)
        if before is None or before.is_mandatory:
            found[argument.name] = argument
    return found


def inclusions_of(root: etree._Element) -> Iterator[Inclusion]:
    """Give the inclusions of a launch file that are not switched off for good.

    Args:
        root: its ``launch`` element.
    """
    for node in active_nodes(root):
        if node.tag == "include" and node.get("file"):
            arguments = {str(arg.get("name")): line_of(arg) for arg in node.iterfind("arg") if arg.get("name")}
            passes_all = (node.get("pass_all_args") or "").strip().lower() in ("true", "1")
            yield Inclusion(str(node.get("file")), arguments, passes_all, line_of(node))


def packages_in(text: str) -> Iterator[str]:
    """Give the packages that a text finds by ``$(find ...)``."""
    for match in _SUBSTITUTION.finditer(text):
        if match.group(1) in _FIND and match.group(2).strip():
            yield match.group(2).strip()


def resolved_path(text: str, folder: Path, packages: Mapping[str, Path]) -> Optional[Tuple[Path, str]]:
    """Find the file that a text names.

    Args:
        text: with ``$(find ...)`` or ``$(dirname)``.
        folder: of the launch file.
        packages: folder by name.

    Returns:
        The path, and the package that it lies in (empty for ``$(dirname)``); None if only a launch can tell.
    """
    match = _SUBSTITUTION.match(text.strip())
    if match is None:
        return None
    rest = text.strip()[match.end() :]
    if "$(" in rest or "@" in rest or not rest.startswith("/"):
        return None
    kind, name = match.group(1), match.group(2).strip()
    if kind == "dirname":
        return folder / rest.lstrip("/"), ""
    if kind in _FIND and name in packages:
        return packages[name] / rest.lstrip("/"), name
    return None


def active_nodes(root: etree._Element) -> Iterator[etree._Element]:
    """Walk through a launch file, leaving out what is switched off for good.

    Args:
        root: its ``launch`` element.
    """
    for node in root:
        if not _is_off(node):
            yield node
            yield from active_nodes(node)


def _is_off(node: etree._Element) -> bool:
    condition, negated = (node.get("if") or "").strip().lower(), (node.get("unless") or "").strip().lower()
    return condition in ("false", "0") or negated in ("true", "1")
