"""What discovery finds: packages, what they register, and how to look both up."""

from __future__ import annotations

import re
from dataclasses import dataclass, field
from enum import Enum
from pathlib import Path
from typing import Mapping, Optional, Tuple

from rqt_mrta_py.errors import DiscoveryError, Problem
from rqt_mrta_py.wording import accepted, nearest

__all__ = ["Registration", "RegistrationKind", "Registry"]

_PARTING_LINE = re.compile(r"^---[ \t\r]*$\n?", re.MULTILINE)


class RegistrationKind(Enum):
    """What a package can register; the value is the attribute of its export tag."""

    ARCHITECTURE = "architecture"
    APPLICATION = "application"
    PLUGIN = "plugin"


@dataclass(frozen=True)
class Registration:
    """One thing that one package registers.

    Attributes:
        package: its name; of an entry point the distribution's.
        folder: of the package.
        kind: what is registered.
        file: the exported rqt_mrta.xml; None for a plugin.
        plugin: dotted module, ``module:object`` also for entry points; empty unless the kind is PLUGIN.
        scenario: the application's scenario.yaml; None if it has none.
        tasks: the application's tasks.yaml; None if it has none.
        manifest: the file that registers it.
        line: of the export tag there; 0 for an entry point.
        problems: what is wrong with the registration itself.
    """

    package: str
    folder: Path
    kind: RegistrationKind
    file: Optional[Path] = None
    plugin: str = ""
    scenario: Optional[Path] = None
    tasks: Optional[Path] = None
    manifest: Path = Path()
    line: int = 0
    problems: Tuple[Problem, ...] = ()


@dataclass(frozen=True)
class Registry:
    """Everything that one search found.

    Attributes:
        packages: folder by package name, in search order; the first of a name.
        registrations: in search order; within a package in the order of its manifest.
        problems: manifests that could not be read, and tags that do not count.
        shadowed: name and folder of each package that an earlier one of its name hides, in search order.
    """

    packages: Mapping[str, Path] = field(default_factory=dict)
    registrations: Tuple[Registration, ...] = ()
    problems: Tuple[Problem, ...] = ()
    shadowed: Tuple[Tuple[str, Path], ...] = ()

    def of_kind(self, kind: RegistrationKind) -> Tuple[Registration, ...]:
        """List the registrations of one kind, in search order."""
        return tuple(registration for registration in self.registrations if registration.kind is kind)

    def find(self, name: str, kind: Optional[RegistrationKind] = None) -> Registration:
        """Look up what a package registers.

        Args:
            name: of the package.
            kind: of the registration; None: the first of any kind.

        Raises:
            DiscoveryError: nothing is registered under this name; says which name is nearest.
        """
        candidates = self.registrations if kind is None else self.of_kind(kind)
        for registration in candidates:
            if registration.package == name:
                return registration
        what = "package" if kind is None else kind.value
        if name in self.packages:
            raise DiscoveryError(
                f"{name}: the package in {self.packages[name]} registers no {what}; its package.xml must depend on "
                f"rqt_mrta_py and export <rqt_mrta_py {what if kind else 'application'}=.../>"
            )
        known = dict.fromkeys(registration.package for registration in candidates)
        # A name that is near none may be right, and its package elsewhere.
        hint = "" if nearest(name, known) else "; packages are found on ROS_PACKAGE_PATH, or by their folder"
        raise DiscoveryError(f"{name}: no {what} of this name is registered; {accepted(name, known)}{hint}")

    def message_file(self, type_name: str) -> Optional[Path]:
        """Find the definition of a message type, in any package, whether it registers anything or not.

        Args:
            type_name: ``pkg/Msg``.

        Returns:
            ``<pkg>/msg/<Msg>.msg``; None if the package is unknown or has no such file.
        """
        package, _, message = type_name.partition("/")
        folder = self.packages.get(package)
        if folder is None or not message.isidentifier():
            return None
        path = folder / "msg" / f"{message}.msg"
        return path if path.is_file() else None

    def message_text(self, type_name: str) -> Optional[str]:
        """Read the definition of a message type, or of what a service is asked or answers.

        Args:
            type_name: ``pkg/Msg``; also ``pkg/SrvRequest`` and ``pkg/SrvResponse`` of ``<pkg>/srv/<Srv>.srv``.

        Returns:
            The text; None if there is no such file.

        Raises:
            OSError: the file cannot be read.
            ValueError: it is no text, or a service's without the line that parts request and response.
        """
        path = self.message_file(type_name)
        if path is not None:
            return path.read_text(encoding="utf-8")
        for part, ending in enumerate(("Request", "Response")):
            package, _, service = type_name[: -len(ending)].partition("/")
            folder = self.packages.get(package)
            if not type_name.endswith(ending) or folder is None or not service.isidentifier():
                continue
            path = folder / "srv" / f"{service}.srv"
            if path.is_file():
                parts = _PARTING_LINE.split(path.read_text(encoding="utf-8"))
                if len(parts) != 2:
                    raise ValueError(f"{path}: has {len(parts) - 1} lines '---'; one parts request and response")
                return parts[part]
        return None
