"""Finding packages as ROS finds them, with or without ROS.

Search order: ``ROS_PACKAGE_PATH``, then the share folders of ``CMAKE_PREFIX_PATH``, of Debian and of the Python
environment, then the packages that this project brings. Of one name the first found wins.

Where another copy of this project is installed in the Python environment, a wheel beside a checkout say, what lies in
that share folder came with the copy: it is then searched last.
"""

from __future__ import annotations

import logging
import os
import re
import sys
from importlib import metadata
from pathlib import Path
from typing import Dict, Iterable, Iterator, List, Mapping, Optional, Sequence, Set, Tuple

from rqt_mrta_py.config.discovery.manifest import HOSTS, MANIFEST, ROSBUILD_MANIFEST, Manifest, parse_manifest
from rqt_mrta_py.config.discovery.registration import Registration, RegistrationKind, Registry
from rqt_mrta_py.config.files import read_file
from rqt_mrta_py.errors import ConfigError, Problem

__all__ = ["discover", "own_packages"]

_log = logging.getLogger("rqt_mrta_py.config")

_GROUP = "rqt_mrta_py"
_OWN = "rqt_mrta_py"
_DEBIAN = (Path("/usr/share"),)
_MENTION = HOSTS[0].encode("ascii")
_COMMENT = re.compile(rb"<!--.*?-->", re.DOTALL)
_NAME = re.compile(rb"<name>\s*([A-Za-z][A-Za-z0-9_-]*)\s*</name>")
_METAPACKAGE = b"<metapackage"
_IGNORE = "CATKIN_IGNORE"
_STOP = "rospack_nosubdirs"
_MARKS = frozenset((MANIFEST, ROSBUILD_MANIFEST, _IGNORE, _STOP))


def discover(
    environ: Mapping[str, str],
    prefix: str = sys.prefix,
    own: Optional[Sequence[Path]] = None,
    shares: Sequence[Path] = _DEBIAN,
    distributions: Optional[Iterable[metadata.Distribution]] = None,
) -> Registry:
    """Search for packages and for what they register; imports no plugin.

    Args:
        environ: the environment; ``ROS_PACKAGE_PATH`` and ``CMAKE_PREFIX_PATH`` are read.
        prefix: of the Python environment.
        own: folders with the packages that this project brings; None: those of this checkout or installation.
        shares: the operating system's share folders.
        distributions: whose entry points of the group ``rqt_mrta_py`` count as plugins; None: all installed ones.

    Returns:
        What was found. Manifests that cannot be read are reported there and skipped.
    """
    search = _Search()
    for folder in _split(environ.get("ROS_PACKAGE_PATH", "")):
        search.place(folder)
    for folder in [*(entry / "share" for entry in _split(environ.get("CMAKE_PREFIX_PATH", ""))), *shares]:
        search.share(folder)
    brought = list(own_packages() if own is None else own)
    installed = Path(prefix) / "share"
    is_of_another_copy = (installed / _OWN / MANIFEST).is_file() and installed.resolve() not in brought
    for folder in [*brought, installed] if is_of_another_copy else [installed, *brought]:
        search.place(folder)
    search.entry_points(metadata.distributions() if distributions is None else distributions)
    _log.debug("event=discovered packages=%d registrations=%d", len(search.packages), len(search.registrations))
    return Registry(
        search.packages, tuple(search.registrations), tuple(sorted(set(search.problems))), tuple(search.shadowed)
    )


def own_packages() -> Tuple[Path, ...]:
    """Locate the packages that this project brings.

    Returns:
        Of a source checkout its root and its ``plugins`` folder; of an installation the share folder and, last, that
        of its stubs; nothing if neither is there.
    """
    parents = Path(__file__).resolve().parents
    root = parents[4]
    if (root / MANIFEST).is_file() and (root / "src" / _OWN).is_dir():
        return (root, root / "plugins")
    for parent in parents:
        if (parent / "share" / _OWN / MANIFEST).is_file():
            return (parent / "share", parent / "share" / _OWN / "stubs")
    return ()


class _Search:
    """Collects packages; the first of a name wins."""

    def __init__(self) -> None:
        self.packages: Dict[str, Path] = {}
        self.registrations: List[Registration] = []
        self.problems: List[Problem] = []
        self.shadowed: List[Tuple[str, Path]] = []
        self._visited: Set[Tuple[int, int]] = set()

    def place(self, folder: Path) -> None:
        """Search a folder by its kind: an installation's share folder is flat, and may well be all of /usr/share."""
        if folder.name == "share":
            self.share(folder)
        else:
            self.crawl(folder)

    def crawl(self, folder: Path) -> None:
        """Descend from a folder; a package is a leaf, links are followed, each folder is visited once."""
        pending = [str(folder)]
        while pending:
            here = pending.pop()
            try:
                status = os.stat(here)  # noqa: PTH116 - paths of all folders below would be felt
                with os.scandir(here) as entries:
                    found = sorted(entries, key=lambda entry: entry.name)
            except OSError:
                continue
            marks = {entry.name for entry in found if entry.name in _MARKS and _is_file(entry)}
            identity = (status.st_dev, status.st_ino)
            if identity in self._visited or _IGNORE in marks:
                continue
            self._visited.add(identity)
            if MANIFEST in marks:
                self._take(Path(here, MANIFEST))
            elif ROSBUILD_MANIFEST in marks:
                self._take(Path(here, ROSBUILD_MANIFEST))
            elif _STOP not in marks:
                pending.extend(entry.path for entry in reversed(found) if _is_open_folder(entry))

    def share(self, folder: Path) -> None:
        """Take the packages right below a share folder; such folders are large, so nothing else is looked at."""
        try:
            with os.scandir(folder) as entries:
                names = sorted(entry.name for entry in entries if not entry.name.startswith("."))
        except OSError:
            return
        for name in names:
            manifest = os.path.join(folder, name, MANIFEST)  # noqa: PTH118 - most of many names have none
            if not os.path.isfile(manifest):  # noqa: PTH113 - the same
                continue
            if not (folder / name / _IGNORE).is_file():
                self._take(Path(manifest))

    def entry_points(self, distributions: Iterable[metadata.Distribution]) -> None:
        """Take the plugins of installed distributions, by name; of one distribution the first on the path."""
        found: Dict[Tuple[str, str], Registration] = {}
        for distribution in distributions:
            for entry_point in distribution.entry_points:
                if entry_point.group != _GROUP:
                    continue
                name = str(distribution.metadata["Name"])
                folder = Path(str(distribution.locate_file("")))
                registration = Registration(
                    name, folder, RegistrationKind.PLUGIN, plugin=entry_point.value, manifest=folder / name
                )
                found.setdefault((name, entry_point.name), registration)
        known = {registration.plugin for registration in self.registrations}
        self.registrations.extend(found[key] for key in sorted(found) if found[key].plugin not in known)

    def _take(self, path: Path) -> None:
        try:
            manifest = _skim(path)
        except ConfigError as error:
            self.problems.extend(error.problems)
            return
        if manifest.metapackage:
            self.problems.extend(manifest.problems)
            return
        if manifest.name in self.packages:
            self.shadowed.append((manifest.name, manifest.folder))
            return
        self.packages[manifest.name] = manifest.folder
        self.registrations.extend(manifest.registrations)
        self.problems.extend(manifest.problems)


def _skim(path: Path) -> Manifest:
    """Read a manifest; one that does not mention us is not parsed if its name is all that matters.

    Where the encoding hides a mention, it hides the name too, and the manifest is parsed.
    """
    raw = read_file(path)
    if _MENTION not in raw and _METAPACKAGE not in raw:
        if path.name == ROSBUILD_MANIFEST:
            return Manifest(path.parent.name, path.parent)
        name = _NAME.search(_COMMENT.sub(b"", raw))
        if name is not None:
            return Manifest(name.group(1).decode("ascii"), path.parent)
    return parse_manifest(raw, path)


def _is_file(entry: os.DirEntry[str]) -> bool:
    try:
        return entry.is_file()
    except OSError:
        return False


def _is_open_folder(entry: os.DirEntry[str]) -> bool:
    try:
        return not entry.name.startswith(".") and entry.is_dir()
    except OSError:
        return False


def _split(value: str) -> Iterator[Path]:
    return (Path(part).absolute() for part in value.split(os.pathsep) if part)
