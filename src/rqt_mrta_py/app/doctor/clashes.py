"""Packages of one name: only the first on the path is used, and it may not be the one that is meant."""

from __future__ import annotations

import os
from pathlib import Path
from typing import Dict, Iterator, List, Set, Tuple

from rqt_mrta_py.app.doctor.subject import Subject
from rqt_mrta_py.config.discovery.manifest import HOSTS, MANIFEST, ROSBUILD_MANIFEST, read_manifest
from rqt_mrta_py.config.discovery.registration import Registry
from rqt_mrta_py.config.discovery.search import own_packages
from rqt_mrta_py.config.files import read_file
from rqt_mrta_py.config.xml.text import line_of
from rqt_mrta_py.errors import ConfigError, Problem

__all__ = ["ORIGINALS", "check_clashes", "standing_back"]

ORIGINALS = (
    *("alliance", "alliance_msgs", "alliance_test", "rqt_alliance", "rqt_mrta"),
    *("murdoch", "talmech", "talmech_msgs"),
)
"""Packages that people have whose files this project reads."""

_STUB = "rqt_mrta"
_MESSAGES = (("msg", "*.msg"), ("srv", "*.srv"), ("action", "*.action"))
_SOURCE = "src"
_SHARE = "share"
_MOST = 3


def check_clashes(subject: Subject) -> Iterator[Problem]:
    """Find packages that hide this one or are hidden by it and differ, and names that belong to the original ones."""
    if subject.manifest is None:
        return
    yield from _taken_name(subject)
    registry = subject.host.registry
    winner = registry.packages.get(subject.name)
    if winner is None or subject.name == HOSTS[1]:
        return
    hidden: List[Path] = []
    for name, folder in registry.shadowed:
        if name == subject.name and folder not in hidden and os.path.realpath(folder) != os.path.realpath(winner):
            hidden.append(folder)
    for folder in hidden:
        if subject.folder in (winner, folder) and not (subject.name == _STUB and _is_ours(folder)):
            yield from _clash(subject, winner, folder)


def standing_back(registry: Registry) -> Tuple[Problem, ...]:
    """Tell which packages of this project give way to others of their names, as they should.

    Args:
        registry: what is found, and what is hidden.

    Returns:
        A note for each, with the package's name as its element; sorted.
    """
    own = [os.path.realpath(each) for each in own_packages()]
    notes = []
    for name, folder in registry.shadowed:
        winner = registry.packages.get(name)
        is_own = any(os.path.realpath(folder).startswith(f"{each}{os.sep}") for each in own)
        if winner is not None and is_own and not _is_ours(winner):
            notes.append(
                Problem(str(_manifest(winner)), 0, name, f"is used; this project's own, in {folder}, stands back")
            )
    return tuple(sorted(set(notes)))


def _taken_name(subject: Subject) -> Iterator[Problem]:
    """Find a package for this project that has the name of an original one, which knows nothing of this project."""
    if subject.manifest is None or subject.name not in ORIGINALS or _is_ours(subject.folder):
        return
    tag = next(iter(subject.root(subject.manifest).iterfind(f"export/{HOSTS[1]}")), None)
    if tag is not None:
        message = (
            f"{subject.name!r} is the name of an original package; where that is installed too, only one of them is "
            "found; give this one another name"
        )
        line = subject.line(subject.manifest, "name")
        yield Problem(str(subject.manifest), line, "name", message)


def _clash(subject: Subject, winner: Path, hidden: Path) -> Iterator[Problem]:
    differing = _differing(winner, hidden)
    if differing:
        rest = f" and {len(differing) - _MOST} more" if len(differing) > _MOST else ""
        what = f"they differ in {', '.join(differing[:_MOST])}{rest}"
    elif _SHARE not in (winner.parent.name, hidden.parent.name) and not _is_ours(hidden):
        what = "catkin refuses two of one name in a workspace"
    else:
        return
    ours = "this project's own, " if _is_ours(hidden) else "the one "
    message = f"{subject.name!r} hides {ours}in {hidden}, and {what}; rename one, or take it off the path"
    manifest = _manifest(winner)
    yield Problem(str(manifest), _name_line(subject, manifest), "name", message)


def _name_line(subject: Subject, manifest: Path) -> int:
    try:
        node = subject.root(manifest).find("name")
    except ConfigError:
        return 0
    return line_of(node) if node is not None else 0


def _differing(one: Path, other: Path) -> List[str]:
    """List what matters here and is not the same in two packages: what they register, and their messages."""
    ones, others = _contents(one), _contents(other)
    differing = {name for name in {**ones, **others} if ones.get(name) != others.get(name)}
    if not all((folder / _SOURCE).is_dir() for folder in (one, other)):
        # An installed package has its code elsewhere.
        differing = {name for name in differing if not name.startswith(f"{_SOURCE}/")}
    return sorted(differing)


def _contents(folder: Path) -> Dict[str, bytes]:
    files: Set[Path] = {path for part, kind in _MESSAGES for path in folder.glob(f"{part}/{kind}")}
    try:
        registrations = read_manifest(_manifest(folder)).registrations
    except ConfigError:
        registrations = ()
    for entry in registrations:
        files.update(path for path in (entry.file, entry.tasks, entry.scenario) if path is not None and path.is_file())
        if entry.plugin:
            files.update((folder / _SOURCE / entry.plugin.partition(":")[0].partition(".")[0]).rglob("*.py"))
    return {path.relative_to(folder).as_posix(): read_file(path) for path in sorted(files)}


def _manifest(folder: Path) -> Path:
    rosbuild = folder / ROSBUILD_MANIFEST
    return rosbuild if rosbuild.is_file() and not (folder / MANIFEST).is_file() else folder / MANIFEST


def _is_ours(folder: Path) -> bool:
    return any(each in folder.parents for each in own_packages())
