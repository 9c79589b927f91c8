"""Whether an installation would hold what the package registers: else it works in the workspace and nowhere else."""

from __future__ import annotations

from pathlib import Path
from typing import Iterator, List, NamedTuple, Tuple

from rqt_mrta_py.app.doctor.install_rules import InstallRules, read_install_rules
from rqt_mrta_py.app.doctor.subject import Subject
from rqt_mrta_py.config.discovery.manifest import MANIFEST
from rqt_mrta_py.config.discovery.registration import RegistrationKind
from rqt_mrta_py.config.files import read_file
from rqt_mrta_py.errors import Problem

__all__ = ["check_installation"]

_SHARE = "${CATKIN_PACKAGE_SHARE_DESTINATION}"
_FOLDERS = (("launch", "*.launch"), ("config", "*.yaml"))
_ELEMENT = "install"


class _Needed(NamedTuple):
    """A file that an installation must hold: relative to the package, and who wants it."""

    file: str
    why: str


def check_installation(subject: Subject) -> Iterator[Problem]:
    """Find exported files, launch and parameter files, and plugins that CMakeLists.txt does not install."""
    if subject.manifest is None or subject.manifest.name != MANIFEST or not subject.registrations:
        return
    path = subject.folder / "CMakeLists.txt"
    if not path.is_file():
        # An installed package has none; elsewhere catkin cannot build without.
        if subject.folder.parent.name != "share" and _is_built_by_catkin(subject):
            message = "wants catkin, but there is no CMakeLists.txt beside it; write one"
            line = subject.line(subject.manifest, "buildtool_depend")
            yield Problem(str(subject.manifest), line, "buildtool_depend", message)
        return
    rules = read_install_rules(read_file(path).decode("utf-8", "replace"), subject.folder, subject.name)
    if not rules.is_clear:
        return
    told = set()
    for needed in (*_exported(subject), *_in_folders(subject)):
        # Of a folder the first file says enough.
        about = needed.file if needed.why else needed.file.partition("/")[0]
        if about not in told and not rules.covers(needed.file):
            told.add(about)
            yield _missing(path, needed, rules)
    yield from _plugins(subject, path, rules)


def _is_built_by_catkin(subject: Subject) -> bool:
    root = subject.root(subject.manifest) if subject.manifest is not None else None
    return root is not None and any((node.text or "").strip() == "catkin" for node in root.iterfind("buildtool_depend"))


def _exported(subject: Subject) -> List[_Needed]:
    needed = {}
    for entry in subject.registrations:
        for file in (entry.file, entry.tasks, entry.scenario):
            if file is not None and file.is_file():
                name = file.relative_to(subject.folder).as_posix()
                needed[name] = _Needed(name, f"{MANIFEST}:{entry.line} exports it")
    return [needed[name] for name in sorted(needed)]


def _in_folders(subject: Subject) -> Iterator[_Needed]:
    """Give the files that launch files and roslaunch look for."""
    for folder, pattern in _FOLDERS:
        for file in sorted((subject.folder / folder).rglob(pattern)):
            yield _Needed(file.relative_to(subject.folder).as_posix(), "")


def _missing(path: Path, needed: _Needed, rules: InstallRules) -> Problem:
    folder = needed.file.rpartition("/")[0]
    to = f"{_SHARE}/{folder}" if folder else _SHARE
    top = needed.file.partition("/")[0]
    if needed.why:
        rule = f"install(FILES {needed.file} DESTINATION {to})"
        what = f"{needed.file!r} is not installed, though {needed.why}"
    else:
        rule = f"install(DIRECTORY {top} DESTINATION {_SHARE})"
        what = f"{needed.file!r} is not installed"
    place, line = rules.astray(needed.file)
    if place:
        what = f"{needed.file!r} is installed to {place}, where nobody looks for it"
    return Problem(str(path), line, _ELEMENT, f"{what}; give {rule}")


def _plugins(subject: Subject, path: Path, rules: InstallRules) -> Iterator[Problem]:
    for entry in subject.registrations:
        if entry.kind is not RegistrationKind.PLUGIN:
            continue
        top = entry.plugin.partition(":")[0].partition(".")[0]
        source = _source(subject.folder, top)
        if not source:
            continue
        if not rules.brings_module(source):
            message = f"{source!r}, which {MANIFEST}:{entry.line} exports as plugin, is not installed; "
            yield Problem(str(path), 0, _ELEMENT, f"{message}give catkin_python_setup() and a setup.py")
        elif rules.sets_python_up and not (subject.folder / "setup.py").is_file():
            message = "needs a setup.py, which is missing; write one that names the package's modules"
            yield Problem(str(path), rules.python_line, "catkin_python_setup", message)


def _source(folder: Path, top: str) -> str:
    """Give where a module lies within a package; empty if it comes from elsewhere."""
    candidates: Tuple[str, ...] = (f"src/{top}", f"src/{top}.py")
    return next((name for name in candidates if (folder / name).exists()), "")
