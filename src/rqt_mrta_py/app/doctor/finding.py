"""From what the user names to the packages that are meant."""

from __future__ import annotations

import os
from pathlib import Path
from typing import Dict, Iterator, List, Mapping, NamedTuple, Sequence, Tuple

from rqt_mrta_py.app.compose import Host, compose
from rqt_mrta_py.app.doctor.clashes import standing_back
from rqt_mrta_py.app.doctor.subject import Subject
from rqt_mrta_py.config.discovery.manifest import HOSTS, MANIFEST, ROSBUILD_MANIFEST, read_manifest
from rqt_mrta_py.config.discovery.search import discover, own_packages
from rqt_mrta_py.config.discovery.source import find_registrations
from rqt_mrta_py.config.files import read_file
from rqt_mrta_py.errors import ConfigError, DiscoveryError, Problem
from rqt_mrta_py.wording import accepted

__all__ = ["Found", "find_subjects"]

_PATH = "ROS_PACKAGE_PATH"
_FILE = "rqt_mrta.xml"
_MENTION = HOSTS[0].encode("ascii")


class Found(NamedTuple):
    """What is to be examined.

    Attributes:
        subjects: each package once, by folder.
        problems: of manifests that name no package.
        notes: what is well, and yet to be known.
    """

    subjects: Tuple[Subject, ...]
    problems: Tuple[Problem, ...]
    notes: Tuple[Problem, ...] = ()


def find_subjects(names: Sequence[str], environ: Mapping[str, str]) -> Found:
    """Find the packages that are meant, and load the plugins that know of their contents.

    Args:
        names: each a package's name, its folder, its manifest, an rqt_mrta.xml, or a folder with packages below;
            none: all packages on the path that take part or mean to, and all that this project brings.
        environ: the environment; ``ROS_PACKAGE_PATH`` and ``CMAKE_PREFIX_PATH`` are read.

    Raises:
        DiscoveryError: there is nothing of a name.
    """
    places = _places(names, environ)
    # What is named stands before everything else, or else another package of its name would be examined.
    before = os.pathsep.join(dict.fromkeys(map(str, places)))
    joined = os.pathsep.join(part for part in (before, environ.get(_PATH, "")) if part)
    registry = discover({**environ, _PATH: joined})
    host = compose(registry, forgiving=True)
    subjects: Dict[Tuple[Path, object], Subject] = {}
    for subject in _named(names, host) if names else _all(host):
        subjects.setdefault((subject.folder, subject.registrations if subject.manifest is None else None), subject)
    told = {str(subject.manifest) for subject in subjects.values()}
    problems = tuple(
        problem
        for problem in registry.problems
        if problem.path not in told and (not names or any(_is_below(Path(problem.path), each) for each in places))
    )
    meant = {subject.name for subject in subjects.values()}
    notes = tuple(note for note in standing_back(registry) if not names or note.element in meant)
    return Found(tuple(subjects.values()), problems, notes)


def _places(names: Sequence[str], environ: Mapping[str, str]) -> List[Path]:
    """List the folders that are named; a registered name goes before a folder of that name."""
    paths = [(name, path) for name, path in zip(names, map(_path, names)) if _is_there(path)]
    plain = any(os.sep not in name and path.is_dir() for name, path in paths)
    registered = discover(environ).packages if plain else {}
    folders = []
    for name, path in paths:
        if path.is_dir() and name not in registered:
            folders.append(path)
        elif path.is_file() and _manifest(path.parent).is_file():
            folders.append(path.parent)
    return folders


def _path(name: str) -> Path:
    return Path(os.path.abspath(name))  # noqa: PTH100 - resolve() would follow links


def _is_there(path: Path) -> bool:
    return os.path.exists(path)  # noqa: PTH110 - Path.exists() raises at long names


def _is_below(path: Path, folder: Path) -> bool:
    return folder in path.parents


def _all(host: Host) -> Iterator[Subject]:
    own = own_packages()
    for name, folder in host.registry.packages.items():
        manifest = _manifest(folder)
        if any(folder == each or _is_below(folder, each) for each in own) or _MENTION in read_file(manifest):
            yield _package(name, manifest, host)


def _named(names: Sequence[str], host: Host) -> Iterator[Subject]:
    for name in names:
        path = _path(name)
        is_there = _is_there(path)
        if name in host.registry.packages and not (os.sep in name or (is_there and path.is_file())):
            yield _package(name, _manifest(host.registry.packages[name]), host)
        elif not is_there:
            known = dict.fromkeys([entry.package for entry in host.registry.registrations])
            message = "there is no such package, file or folder" if os.sep in name else "no package has this name"
            raise DiscoveryError(f"{name}: {message}; {accepted(name, known)}")
        elif path.name in (MANIFEST, ROSBUILD_MANIFEST) or _manifest(path).is_file():
            manifest = path if path.is_file() else _manifest(path)
            yield _package(manifest.parent.name, manifest, host)
        elif path.is_file():
            registrations = find_registrations(host.registry, str(path))
            yield Subject(registrations[0].package, path.parent, None, registrations, host)
        else:
            yield from _below(name, path, host)


def _below(name: str, folder: Path, host: Host) -> Iterator[Subject]:
    found = discover({_PATH: str(folder)}, prefix=os.devnull, own=(), shares=(), distributions=())
    manifests = {_manifest(each) for each in found.packages.values()} | {_manifest(each) for _, each in found.shadowed}
    if manifests or found.problems:
        for manifest in sorted(manifests):
            yield _package(manifest.parent.name, manifest, host)
    elif not (folder / _FILE).is_file():
        raise DiscoveryError(f"{name}: holds neither a package nor an {_FILE}")
    else:
        for registration in find_registrations(host.registry, str(folder)):
            yield Subject(registration.package, folder, None, (registration,), host)


def _manifest(folder: Path) -> Path:
    rosbuild = folder / ROSBUILD_MANIFEST
    return rosbuild if rosbuild.is_file() and not (folder / MANIFEST).is_file() else folder / MANIFEST


def _package(name: str, path: Path, host: Host) -> Subject:
    """Make a subject of a package; one whose manifest cannot be read has the name of its folder."""
    try:
        manifest = read_manifest(path)
    except ConfigError:
        return Subject(name, path.parent, path, (), host)
    return Subject(manifest.name, manifest.folder, path, manifest.registrations, host)
