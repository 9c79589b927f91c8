"""What is registered, as ``mrta list`` tells it; imports no plugin."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Dict, List, Optional, Tuple

from rqt_mrta_py.config.discovery.registration import Registration, RegistrationKind, Registry
from rqt_mrta_py.config.files import read_file
from rqt_mrta_py.config.xml.application import read_application
from rqt_mrta_py.config.xml.architecture import read_architecture
from rqt_mrta_py.errors import ConfigError, Problem
from rqt_mrta_py.model import ApplicationSpec, ArchitectureSpec, Taxonomy

__all__ = ["Entry", "application_of", "architecture_of", "entries"]


@dataclass(frozen=True)
class Entry:
    """One line of the list.

    Attributes:
        registration: what a package registers.
        title: its name for people; empty if its file cannot be read.
        taxonomy: of an architecture, or of the architecture that an application names; None if unknown.
        architecture: that an application names; None if none.
        problems: what is wrong with it.
    """

    registration: Registration
    title: str = ""
    taxonomy: Optional[Taxonomy] = None
    architecture: Optional[str] = None
    problems: Tuple[Problem, ...] = ()


def architecture_of(registration: Registration) -> ArchitectureSpec:
    """Read the file of a registered architecture.

    Raises:
        ConfigError: it cannot be read, with everything that is wrong.
    """
    return read_architecture(_content(registration), str(registration.file), registration.package)


def application_of(registration: Registration) -> ApplicationSpec:
    """Read the file of a registered application.

    Raises:
        ConfigError: it cannot be read, with everything that is wrong.
    """
    return read_application(_content(registration), str(registration.file), registration.package)


def entries(registry: Registry, kind: RegistrationKind, wanted: Taxonomy) -> List[Entry]:
    """List what is registered of one kind.

    Args:
        registry: what was found.
        kind: which kind.
        wanted: lets through what fits; blanks match anything. Plugins have no taxonomy and fit only the blank.

    Returns:
        Entries by package name, each with what is wrong with it.
    """
    taxonomies = _Taxonomies(registry)
    listed = [_entry(taxonomies, registration) for registration in registry.of_kind(kind)]
    fitting = [entry for entry in listed if wanted.accepts(entry.taxonomy or Taxonomy())]
    return sorted(fitting, key=lambda entry: entry.registration.package)


def _entry(taxonomies: _Taxonomies, registration: Registration) -> Entry:
    problems = registration.problems
    try:
        if registration.kind is RegistrationKind.ARCHITECTURE:
            architecture = architecture_of(registration)
            return Entry(registration, architecture.name, architecture.taxonomy, problems=problems)
        if registration.kind is RegistrationKind.APPLICATION:
            application = application_of(registration)
            taxonomy = taxonomies.of(application.architecture)
            return Entry(registration, application.name, taxonomy, application.architecture, problems)
    except ConfigError as error:
        problems = (*problems, *error.problems)
    return Entry(registration, problems=tuple(sorted(set(problems))))


class _Taxonomies:
    """Taxonomies of architectures by name, each file read once, however many applications name it."""

    def __init__(self, registry: Registry) -> None:
        self._registered: Dict[str, Registration] = {}
        for registration in registry.of_kind(RegistrationKind.ARCHITECTURE):
            self._registered.setdefault(registration.package, registration)
        self._known: Dict[str, Optional[Taxonomy]] = {}

    def of(self, architecture: Optional[str]) -> Optional[Taxonomy]:
        """Give the taxonomy of an architecture; None if it is not registered or cannot be read."""
        if architecture is None or architecture not in self._registered:
            return None
        if architecture not in self._known:
            self._known[architecture] = self._read(architecture)
        return self._known[architecture]

    def _read(self, architecture: str) -> Optional[Taxonomy]:
        try:
            return architecture_of(self._registered[architecture]).taxonomy
        except ConfigError:
            return None


def _content(registration: Registration) -> bytes:
    if registration.problems or registration.file is None:
        raise ConfigError(registration.problems)
    return read_file(registration.file)
