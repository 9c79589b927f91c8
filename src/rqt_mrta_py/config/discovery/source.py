"""Finding what the user calls by a registered name, a package's folder, or the file itself."""

from __future__ import annotations

import os
from pathlib import Path
from typing import NamedTuple, Optional, Tuple

from rqt_mrta_py.config.discovery.manifest import MANIFEST, read_manifest
from rqt_mrta_py.config.discovery.registration import Registration, RegistrationKind, Registry
from rqt_mrta_py.config.files import read_file
from rqt_mrta_py.config.xml.text import parse_xml
from rqt_mrta_py.errors import ConfigError, DiscoveryError, Problem

__all__ = ["Source", "find_registrations", "find_source"]

_FILE = "rqt_mrta.xml"


class Source(NamedTuple):
    """The files of one architecture or application; ``tasks`` and ``scenario`` are None where there are none."""

    package: str
    file: Path
    tasks: Optional[Path] = None
    scenario: Optional[Path] = None


def find_source(registry: Registry, name: str, kind: RegistrationKind) -> Source:
    """Find an architecture or application.

    Args:
        registry: what is registered; a registered name goes before a file of that name.
        name: registered name, package's folder, or rqt_mrta.xml.
        kind: ARCHITECTURE or APPLICATION.

    Raises:
        DiscoveryError: there is nothing of this name.
        ConfigError: there is, but its registration has problems.
    """
    if any(registration.package == name for registration in registry.of_kind(kind)):
        return _from_registration(registry.find(name, kind))
    path = Path(os.path.abspath(name))  # noqa: PTH100 - resolve() would follow links
    if not _is_path(name, path):
        return _from_registration(registry.find(name, kind))
    if not os.path.exists(path):  # noqa: PTH110 - Path.exists() raises at long names
        raise DiscoveryError(f"{name}: there is no such file or folder; give a registered name or an {_FILE}")
    folder, file = (path, None) if path.is_dir() else (path.parent, path)
    if not (folder / MANIFEST).is_file():
        if not (folder / _FILE).is_file() and file is None:
            raise DiscoveryError(f"{name}: holds neither {MANIFEST} nor {_FILE}")
        return Source(_name_of(file or folder / _FILE), file or folder / _FILE)
    manifest = read_manifest(folder / MANIFEST)
    for registration in manifest.registrations:
        if registration.kind is kind and file in (None, registration.file):
            return _from_registration(registration)
    if file is None:
        raise DiscoveryError(f"{name}: its {MANIFEST} registers no {kind.value}; name the {_FILE} itself")
    return Source(manifest.name, file)


def find_registrations(registry: Registry, name: str) -> Tuple[Registration, ...]:
    """Find everything that a package registers.

    Args:
        registry: what is registered; a registered name goes before a file of that name.
        name: registered name, package's folder, or rqt_mrta.xml, which need not be registered.

    Returns:
        At least one registration, in the manifest's order; of a file its own.

    Raises:
        DiscoveryError: there is nothing of this name, or it registers nothing.
        ConfigError: a manifest cannot be read, or a file does not say what it is.
    """
    found = tuple(registration for registration in registry.registrations if registration.package == name)
    path = Path(os.path.abspath(name))  # noqa: PTH100 - resolve() would follow links
    if found or not _is_path(name, path):
        return found or (registry.find(name),)
    if not os.path.exists(path):  # noqa: PTH110 - Path.exists() raises at long names
        raise DiscoveryError(f"{name}: there is no such file or folder; give a registered name or an {_FILE}")
    folder, file = (path, path / _FILE) if path.is_dir() else (path.parent, path)
    has_manifest = (folder / MANIFEST).is_file()
    manifest = read_manifest(folder / MANIFEST) if has_manifest else None
    if manifest is not None:
        found = tuple(entry for entry in manifest.registrations if path.is_dir() or entry.file == file)
        if found:
            return found
    if not file.is_file():
        raise DiscoveryError(f"{name}: {'registers nothing and ' if has_manifest else ''}holds no {_FILE}")
    package = manifest.name if manifest is not None else _name_of(file)
    return (Registration(package, folder, _kind_of(file), file=file, manifest=file),)


def _name_of(file: Path) -> str:
    """Name what is in no package: a file by its own name, one of the usual name by its folder's."""
    return file.parent.name if file.name == _FILE else file.stem


def _kind_of(file: Path) -> RegistrationKind:
    """Tell from its content what an rqt_mrta.xml describes."""
    root = parse_xml(read_file(file), str(file))
    for kind in (RegistrationKind.ARCHITECTURE, RegistrationKind.APPLICATION):
        if root.get("format") == kind.value or (root.get("format") is None and root.find(kind.value) is not None):
            return kind
    message = "describes neither an architecture nor an application; it must hold an element of either name"
    raise ConfigError([Problem(str(file), 1, "rqt_mrta", message)])


def _from_registration(registration: Registration) -> Source:
    if registration.problems or registration.file is None:
        raise ConfigError(registration.problems)
    return Source(registration.package, registration.file, registration.tasks, registration.scenario)


def _is_path(name: str, path: Path) -> bool:
    return os.sep in name or name.endswith(".xml") or os.path.isdir(path)  # noqa: PTH112 - as above
