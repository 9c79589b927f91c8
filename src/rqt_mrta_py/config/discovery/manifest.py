"""From a package.xml, of format 1, 2 or 3, or a rosbuild manifest.xml, to what its package registers.

A package takes part if it depends directly, at run time, on ``rqt_mrta`` or ``rqt_mrta_py`` and exports a tag of
either name. A ``condition=`` is disregarded, as rospack does; a metapackage registers nothing, as there.
"""

from __future__ import annotations

import os
import re
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Dict, List, Optional, Tuple

from lxml import etree

from rqt_mrta_py.config.discovery.registration import Registration, RegistrationKind
from rqt_mrta_py.config.files import read_file
from rqt_mrta_py.config.problems import Problems
from rqt_mrta_py.config.xml.text import line_of, parse_xml
from rqt_mrta_py.errors import Problem
from rqt_mrta_py.wording import accepted, shown

__all__ = ["HOSTS", "MANIFEST", "ROSBUILD_MANIFEST", "Manifest", "drop_namespace", "parse_manifest", "read_manifest"]

HOSTS = ("rqt_mrta", "rqt_mrta_py")
"""Packages that can be depended on, and names of export tags."""

MANIFEST = "package.xml"
"""Of a package as catkin builds it."""

ROSBUILD_MANIFEST = "manifest.xml"
"""Of a package from before catkin; it has the name of its folder."""

_RUN_TIME = ("run_depend", "exec_depend", "depend")
_FILES = ("scenario", "tasks")
_ATTRIBUTES = ("architecture", "application", "plugin", *_FILES)
_NAME = re.compile(r"[A-Za-z0-9][A-Za-z0-9_-]*\Z")
_MODULE = re.compile(r"[A-Za-z_]\w*(\.[A-Za-z_]\w*)*\Z", re.ASCII)


@dataclass(frozen=True)
class Manifest:
    """What matters here of one manifest.

    Attributes:
        name: of the package.
        folder: that holds the manifest.
        metapackage: True if it only names other packages; ROS does not count it as one itself.
        registrations: in file order; of one tag the architecture first, then application, then plugin.
        problems: of tags that register nothing.
    """

    name: str
    folder: Path
    registrations: Tuple[Registration, ...] = ()
    problems: Tuple[Problem, ...] = ()
    metapackage: bool = False


def read_manifest(path: Path) -> Manifest:
    """Read a package.xml or, if the file is called so, a rosbuild manifest.xml.

    Args:
        path: of the file.

    Raises:
        ConfigError: it cannot be read, is not XML that is accepted here, or names no package that catkin would accept.
    """
    return parse_manifest(read_file(path), path)


def parse_manifest(raw: bytes, path: Path) -> Manifest:
    """Read the content of a manifest.

    Args:
        raw: the whole file.
        path: of the file.

    Raises:
        ConfigError: as of ``read_manifest``.
    """
    problems = Problems(str(path))
    root = parse_xml(raw, str(path))
    drop_namespace(root)
    if root.tag != "package":
        problems.add(line_of(root), str(root.tag), "is not the root of a manifest; accepted: package")
    is_rosbuild = path.name == ROSBUILD_MANIFEST
    node = root.find("name")
    name = path.absolute().parent.name if is_rosbuild else (root.findtext("name") or "").strip()
    if not name:
        problems.add(line_of(root), "name", "is missing or empty; give the name of the package")
    elif node is not None and not is_rosbuild and not _NAME.match(name):
        # Files and folders are named after packages; a name such as "../x" would lead out of them.
        problems.add(line_of(node), "name", f"must be letters, digits, _ and - (got {shown(name)}); give such a name")
    problems.raise_if_any()
    return _Reader(path, name, problems).read(root)


class _Reader:
    """Reads the export tags of one manifest."""

    def __init__(self, path: Path, name: str, problems: Problems) -> None:
        self._path = path
        self._folder = Path(os.path.abspath(path.parent))  # noqa: PTH100 - resolve() would follow links
        self._name = name
        self._problems = problems
        self._files: Dict[str, Tuple[Path, int]] = {}
        self._file_problems: List[Problem] = []

    def read(self, root: etree._Element) -> Manifest:
        tags = [tag for export in root.iterfind("export") for host in HOSTS for tag in export.iterfind(host)]
        tags.sort(key=line_of)
        metapackage = root.find("export/metapackage") is not None
        if tags and metapackage:
            self._note(tags[0], "", "counts for nothing in a metapackage; export it from a package of its own")
            tags = []
        elif tags and not (self._name in HOSTS or _depends(root, self._path.name == ROSBUILD_MANIFEST)):
            self._note(tags[0], "", f"counts only with a direct <exec_depend>{tags[0].tag}</exec_depend>; add it")
            tags = []
        registrations = [registration for tag in tags for registration in self._registrations(tag)]
        applications = [entry for entry in registrations if entry.kind is RegistrationKind.APPLICATION]
        if self._files and not applications:
            for attribute, (_, line) in self._files.items():
                self._problems.add(line, f"@{attribute}", "goes with an application; export application= as well")
        return Manifest(
            self._name,
            self._folder,
            tuple(self._with_files(entry) if entry in applications else entry for entry in registrations),
            self._problems.found,
            metapackage,
        )

    def _with_files(self, application: Registration) -> Registration:
        if not self._files and not self._file_problems:
            return application
        scenario, tasks = (self._files[name][0] if name in self._files else None for name in ("scenario", "tasks"))
        problems = (*application.problems, *self._file_problems)
        return replace(application, scenario=scenario, tasks=tasks, problems=problems)

    def _registrations(self, tag: etree._Element) -> List[Registration]:
        for attribute in tag.attrib:
            if attribute not in _ATTRIBUTES:
                self._note(tag, str(attribute), f"is not known; {accepted(str(attribute), _ATTRIBUTES)}")
        for attribute in _FILES:
            self._take_file(tag, attribute)
        found = []
        for kind in RegistrationKind:
            value = (tag.get(kind.value) or "").strip()
            if kind.value not in tag.attrib:
                continue
            if kind is not RegistrationKind.PLUGIN:
                file, problems = self._resolve(tag, kind.value, value)
                found.append(self._registration(tag, kind, file=file, problems=tuple(problems)))
            elif _MODULE.match(value):
                found.append(self._registration(tag, kind, plugin=value))
            else:
                self._note(tag, "plugin", f"must be a dotted module (got {shown(value)}), such as {self._name}.plugin")
        return found

    def _registration(
        self,
        tag: etree._Element,
        kind: RegistrationKind,
        file: Optional[Path] = None,
        plugin: str = "",
        problems: Tuple[Problem, ...] = (),
    ) -> Registration:
        return Registration(
            package=self._name,
            folder=self._folder,
            kind=kind,
            file=file,
            plugin=plugin,
            manifest=self._path,
            line=line_of(tag),
            problems=problems,
        )

    def _take_file(self, tag: etree._Element, attribute: str) -> None:
        if attribute not in tag.attrib:
            return
        if attribute in self._files:
            first = self._files[attribute][1]
            self._note(tag, attribute, f"is given twice; the one in line {first} counts")
            return
        path, problems = self._resolve(tag, attribute, (tag.get(attribute) or "").strip())
        self._file_problems.extend(problems)
        if path is not None:
            self._files[attribute] = (path, line_of(tag))

    def _resolve(self, tag: etree._Element, attribute: str, value: str) -> Tuple[Optional[Path], List[Problem]]:
        """Find the exported file; relative paths and both spellings of the prefix start at the package."""

        def problem(message: str) -> List[Problem]:
            return [Problem(str(self._path), line_of(tag), f"export/{tag.tag}/@{attribute}", message)]

        if not value:
            return None, problem("is empty; give a file, such as ${prefix}/rqt_mrta.xml")
        folder = str(self._folder)
        # Texts, not paths: of thousands of packages these lines are felt.
        file = os.path.normpath(
            os.path.join(folder, value.replace("${prefix}", folder).replace("{prefix}", folder))  # noqa: PTH118
        )
        if not file.startswith(os.path.join(folder, "")):  # noqa: PTH118
            return None, problem(f"must name a file within the package (got {shown(value)}); begin with ${{prefix}}/")
        if not os.path.isfile(file):  # noqa: PTH113
            return Path(file), problem(f"names a file that does not exist (got {shown(value)}): {file}")
        return Path(file), []

    def _note(self, tag: etree._Element, attribute: str, message: str) -> None:
        element = f"export/{tag.tag}/@{attribute}" if attribute else f"export/{tag.tag}"
        self._problems.add(line_of(tag), element, message)


def _depends(root: etree._Element, is_rosbuild: bool) -> bool:
    if is_rosbuild:
        return any(node.get("package") in HOSTS for node in root.iterfind("depend"))
    return any((node.text or "").strip() in HOSTS for tag in _RUN_TIME for node in root.iterfind(tag))


def drop_namespace(root: etree._Element) -> None:
    """Call elements by their plain names where the root declares a namespace for all; ROS's tools know none."""
    space, _, _ = str(root.tag).rpartition("}")
    if not space:
        return
    for node in root.iter():
        if str(node.tag).startswith(f"{space}}}"):
            node.tag = str(node.tag)[len(space) + 1 :]
