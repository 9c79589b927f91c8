"""Finding an rqt_mrta.xml by what the user calls it: a registered name, a package's folder, or the file itself."""

from __future__ import annotations

import os
from pathlib import Path
from typing import NamedTuple, Optional

from rqt_mrta_py.config.discovery.manifest import read_manifest
from rqt_mrta_py.config.discovery.registration import Registration, RegistrationKind, Registry
from rqt_mrta_py.errors import ConfigError, DiscoveryError

__all__ = ["Source", "find_source"]

_MANIFEST = "package.xml"
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
    if not path.exists():
        raise DiscoveryError(f"{name}: there is no such file or folder; give a registered name or an {_FILE}")
    folder, file = (path, None) if path.is_dir() else (path.parent, path)
    if not (folder / _MANIFEST).is_file():
        if not (folder / _FILE).is_file() and file is None:
            raise DiscoveryError(f"{name}: holds neither {_MANIFEST} nor {_FILE}")
        return Source(folder.name, file or folder / _FILE)
    manifest = read_manifest(folder / _MANIFEST)
    for registration in manifest.registrations:
        if registration.kind is kind and file in (None, registration.file):
            return _from_registration(registration)
    if file is None:
        raise DiscoveryError(f"{name}: its {_MANIFEST} registers no {kind.value}; name the {_FILE} itself")
    return Source(manifest.name, file)


def _from_registration(registration: Registration) -> Source:
    if registration.problems or registration.file is None:
        raise ConfigError(registration.problems)
    return Source(registration.package, registration.file, registration.tasks, registration.scenario)


def _is_path(name: str, path: Path) -> bool:
    return os.sep in name or name.endswith(".xml") or path.is_dir()
