"""Packages that files of a package need: each is to be declared, or an installation may lack it."""

from __future__ import annotations

from pathlib import Path
from typing import Dict, Iterator, Set, Tuple

from lxml import etree

from rqt_mrta_py.app.doctor.subject import Subject
from rqt_mrta_py.config.xml.text import joined, line_of
from rqt_mrta_py.errors import ConfigError, Problem
from rqt_mrta_py.wording import accepted

__all__ = ["check_dependencies", "declared_dependencies", "package_problem"]

_RUN_TIME = ("depend", "exec_depend", "run_depend")
_ROS = "roslaunch"


def declared_dependencies(root: etree._Element) -> Dict[str, int]:
    """List what a package depends on directly at run time.

    Args:
        root: of its package.xml or manifest.xml.

    Returns:
        Line by name, in file order.
    """
    found: Dict[str, int] = {}
    for node in root:
        if node.tag in _RUN_TIME:
            name = node.get("package") or joined(node.text)
            found.setdefault(name, line_of(node))
    return found


def check_dependencies(subject: Subject) -> Iterator[Problem]:
    """Find architectures and message packages that rqt_mrta.xml speaks of and the manifest does not declare."""
    told: Set[str] = set()
    for path, line, element, package in (*_architectures(subject), *_message_packages(subject)):
        if package not in told:
            told.add(package)
            yield from package_problem(subject, package, path, line, element)


def package_problem(subject: Subject, package: str, path: Path, line: int, element: str) -> Iterator[Problem]:
    """Say what is wrong with one use of another package.

    Where ROS is not installed, a package that is declared and not there is no mistake of who declares it.

    Args:
        subject: who uses it.
        package: that is used.
        path: of the file that does.
        line: there.
        element: there.
    """
    if package == subject.name or subject.manifest is None:
        return
    try:
        declared = declared_dependencies(subject.root(subject.manifest))
    except ConfigError:
        return
    packages = subject.host.registry.packages
    if package in declared:
        if package not in packages and _ROS in packages:
            yield Problem(str(path), line, element, f"needs the package {package!r}, which is not on the path")
    elif package in packages:
        message = (
            f"needs the package {package!r}, which {subject.manifest.name} does not depend on; "
            f"add <exec_depend>{package}</exec_depend>"
        )
        yield Problem(str(path), line, element, message)
    else:
        known = dict.fromkeys((subject.name, *declared, *packages))
        message = (
            f"needs the package {package!r}, which is neither on the path nor declared; {accepted(package, known)}"
        )
        yield Problem(str(path), line, element, message)


_Use = Tuple[Path, int, str, str]


def _architectures(subject: Subject) -> Iterator[_Use]:
    element = "application/architecture"
    for application in subject.applications:
        if application.architecture is not None:
            path = application.path
            yield path, subject.line(path, element), element, application.architecture.package


def _message_packages(subject: Subject) -> Iterator[_Use]:
    for architecture in subject.architectures:
        root = subject.root(architecture.path)
        for part in root.iterfind("architecture/*"):
            for place in ("type", "join/type"):
                for node in part.iterfind(f"*/*/{place}"):
                    package, slash, _ = joined(node.text).partition("/")
                    if slash and package:
                        yield architecture.path, line_of(node), f"architecture/{part.tag}/topic/{place}", package
