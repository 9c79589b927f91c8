"""What a manifest says of dependencies and exports that works here, but not everywhere or not as it is meant."""

from __future__ import annotations

import os
import re
from pathlib import Path
from typing import Dict, Iterator, List

from lxml import etree

from rqt_mrta_py.app.doctor.dependencies import declared_dependencies
from rqt_mrta_py.app.doctor.subject import Subject
from rqt_mrta_py.config.discovery.manifest import HOSTS, MANIFEST
from rqt_mrta_py.config.xml.text import line_of
from rqt_mrta_py.errors import Problem
from rqt_mrta_py.wording import shown

__all__ = ["check_manifest"]

_FILES = ("architecture", "application", "tasks", "scenario")
_PREFIX = "${prefix}/"
_BARE_PREFIX = re.compile(r"(?<!\$)\{prefix\}")
_USERS = (".launch", ".msg", ".srv", ".action", ".py", ".cpp", ".h", ".hpp", ".xml", ".test", ".sh")
_MOST = 1_000_000


def check_manifest(subject: Subject) -> Iterator[Problem]:
    """Find dependencies without export, tags without their own dependency, and exports that ROS cannot resolve."""
    if subject.manifest is None:
        return
    root = subject.root(subject.manifest)
    dependencies = declared_dependencies(root)
    tags = [tag for export in root.iterfind("export") for host in HOSTS for tag in export.iterfind(host)]
    if not tags and root.find("export/metapackage") is None:
        yield from _without_export(subject, dependencies)
    for tag in tags:
        yield from _spelling(subject, tag)
        if tag.tag not in dependencies and any(host in dependencies for host in HOSTS):
            message = (
                f"is found here, but rospack plugins wants a dependency on {tag.tag} itself; "
                f"add <exec_depend>{tag.tag}</exec_depend>"
            )
            yield Problem(str(subject.manifest), line_of(tag), f"export/{tag.tag}", message)


def _without_export(subject: Subject, dependencies: Dict[str, int]) -> Iterator[Problem]:
    for host in HOSTS:
        if host not in dependencies or subject.name in HOSTS or _uses(subject.folder, host):
            continue
        message = (
            f"{host!r} is depended on, but nothing is exported to it and no file uses it; export "
            f'<{host} application="${{prefix}}/rqt_mrta.xml"/> or the like, or drop the dependency'
        )
        yield Problem(str(subject.manifest), dependencies[host], "depend", message)


def _uses(folder: Path, host: str) -> bool:
    """Tell whether a launch file, a message or code of a package speaks of another package."""
    mention = re.compile(rb"\b" + host.encode("ascii") + rb"\b")
    for here, folders, files in os.walk(folder):
        folders[:] = sorted(name for name in folders if not name.startswith("."))
        for name in sorted(files):
            path = Path(here, name)
            if not name.endswith(_USERS) or path == folder / MANIFEST:
                continue
            text = _content(path)
            # Of a registration that was forgotten the root element is all that mentions us.
            if mention.search(
                text.replace(b"<rqt_mrta", b"").replace(b"</rqt_mrta", b"").replace(b"rqt_mrta.xml", b"")
            ):
                return True
    return False


def _content(path: Path) -> bytes:
    try:
        with path.open("rb") as file:
            return file.read(_MOST)
    except OSError:
        return b""


def _spelling(subject: Subject, tag: etree._Element) -> Iterator[Problem]:
    for attribute in _FILES:
        value = (tag.get(attribute) or "").strip()
        found: List[str] = []
        if _BARE_PREFIX.search(value):
            found.append(f"has no dollar before {{prefix}} (got {shown(value)}), which ROS then leaves as it is")
        elif value and not value.startswith(_PREFIX):
            if not value.startswith(str(subject.folder)):
                found.append(f"is relative (got {shown(value)}), which ROS leaves to whoever asks")
            else:
                found.append(f"is absolute (got {shown(value)}), which holds on this machine only")
        for what in found:
            rest = value.rpartition("{prefix}/")[2] if "prefix" in value else Path(value).name
            message = f"{what}; write {_PREFIX}{rest}"
            yield Problem(str(subject.manifest), line_of(tag), f"export/{tag.tag}/@{attribute}", message)
