"""Launch files of a package: what they include, find and pass on has to be there."""

from __future__ import annotations

import re
from pathlib import Path
from typing import Iterator, List, Mapping, Optional, Tuple

from lxml import etree

from rqt_mrta_py.app.doctor.dependencies import package_problem
from rqt_mrta_py.app.doctor.launch_text import (
    Inclusion,
    active_nodes,
    arguments_of,
    inclusions_of,
    packages_in,
    resolved_path,
)
from rqt_mrta_py.app.doctor.subject import Subject
from rqt_mrta_py.config.xml.text import line_of
from rqt_mrta_py.errors import ConfigError, Problem
from rqt_mrta_py.wording import accepted, shown

__all__ = ["check_inclusion", "check_launch_files", "packages_of"]

_ARGUMENT = re.compile(r"\$\(\s*arg\s+([^()\s]+)\s*\)")
_FILES = ("file", "textfile")
_VALUES = ("value", "default")
_SUFFIXES = (".launch", ".yaml", ".yml", ".xml", ".urdf", ".xacro", ".rviz", ".world")


def check_launch_files(subject: Subject) -> Iterator[Problem]:
    """Find inclusions of what is not there, arguments that do not fit, and packages that are unknown or undeclared."""
    if subject.manifest is None:
        return
    for path in sorted((subject.folder / "launch").rglob("*.launch")):
        try:
            yield from _file(subject, path)
        except ConfigError as error:
            yield from error.problems


def packages_of(subject: Subject) -> Mapping[str, Path]:
    """Give the folder of each package, as ROS would find it; the subject's own name is itself."""
    return {**subject.host.registry.packages, subject.name: subject.folder}


def check_inclusion(
    subject: Subject, inclusion: Inclusion, path: Path, element: str, fixed: Optional[Mapping[str, str]] = None
) -> Iterator[Problem]:
    """Hold an inclusion against the file that it names.

    Args:
        subject: whose it is.
        inclusion: what is included.
        path: of the file that includes.
        element: there.
        fixed: what is given in the place of tokens; None: nothing.
    """
    file = inclusion.file
    for token, value in (fixed or {}).items():
        file = file.replace(token, value)
    found = resolved_path(file, path.parent, packages_of(subject))
    if found is None:
        return
    target, _ = found
    if not target.is_file():
        names = [each.name for each in sorted(target.parent.glob("*.launch"))]
        message = f"includes a file that does not exist (got {shown(file)}): {target}; {accepted(target.name, names)}"
        yield Problem(str(path), inclusion.line, element, message)
        return
    try:
        declared = arguments_of(subject.root(target))
    except ConfigError as error:
        yield from (problem for problem in error.problems if subject.folder not in target.parents)
        return
    for name, line in inclusion.arguments.items():
        if name not in declared:
            if inclusion.passes_all:
                # roslaunch then asks for no use of any.
                continue
            message = f"{target.name} declares no argument {name!r}; {accepted(name, declared)}"
            yield Problem(str(path), line, f"{element}/arg", message)
        elif declared[name].value is not None:
            message = f"{target.name}:{declared[name].line} fixes the argument {name!r}; leave it out"
            yield Problem(str(path), line, f"{element}/arg", message)
    if inclusion.passes_all:
        return
    for name, argument in declared.items():
        if argument.is_mandatory and name not in inclusion.arguments:
            message = f"gives no value to the argument {name!r}, which {target.name}:{argument.line} has no default for"
            yield Problem(str(path), inclusion.line, element, message)


def _file(subject: Subject, path: Path) -> Iterator[Problem]:
    root = subject.root(path)
    if root.tag != "launch":
        yield Problem(str(path), line_of(root), str(root.tag), "is not the root of a launch file; accepted: launch")
        return
    for inclusion in inclusions_of(root):
        yield from check_inclusion(subject, inclusion, path, "include")
    declared = arguments_of(root)
    told: List[str] = []
    for node in active_nodes(root):
        yield from _missing_files(subject, path, node)
        for name in _arguments_in(node):
            if name not in declared:
                message = f"$(arg {name}) is used, but not declared; {accepted(name, declared)}"
                yield Problem(str(path), line_of(node), str(node.tag), message)
        for package in _packages_in(node):
            if package not in told:
                told.append(package)
                yield from package_problem(subject, package, path, line_of(node), str(node.tag))


def _missing_files(subject: Subject, path: Path, node: etree._Element) -> Iterator[Problem]:
    """Find files that are loaded or handed on and are not there; inclusions are held against their files elsewhere."""
    if node.tag == "include" or (node.tag == "rosparam" and node.get("command", "load") != "load"):
        return
    for attribute in (*_FILES, *_VALUES):
        text = node.get(attribute) or ""
        found = resolved_path(text, path.parent, packages_of(subject))
        if found is None or found[0].exists() or (attribute in _VALUES and not text.endswith(_SUFFIXES)):
            continue
        target = found[0]
        names = [each.name for each in sorted(target.parent.glob(f"*{target.suffix}"))]
        message = f"names a file that does not exist (got {shown(text)}): {target}; {accepted(target.name, names)}"
        yield Problem(str(path), line_of(node), f"{node.tag}/@{attribute}", message)


def _arguments_in(node: etree._Element) -> Iterator[str]:
    texts: Tuple[str, ...] = (*map(str, node.attrib.values()), node.text or "")
    for text in texts:
        yield from _ARGUMENT.findall(text)


def _packages_in(node: etree._Element) -> Iterator[str]:
    for text in (*map(str, node.attrib.values()), node.text or ""):
        yield from packages_in(text)
    package = str(node.get("pkg") or "")
    if node.tag in ("node", "test") and package and "$" not in package:
        yield package
