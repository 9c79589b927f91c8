"""One package that is examined, and its files, each read when a check asks for it."""

from __future__ import annotations

from functools import cached_property
from pathlib import Path
from typing import Dict, List, NamedTuple, Optional, Sequence, Tuple

from lxml import etree

from rqt_mrta_py.app.compose import Host
from rqt_mrta_py.config.discovery.manifest import drop_namespace
from rqt_mrta_py.config.discovery.registration import Registration, RegistrationKind
from rqt_mrta_py.config.discovery.source import Source, find_source
from rqt_mrta_py.config.files import read_file
from rqt_mrta_py.config.gaps import Gaps
from rqt_mrta_py.config.loading import attempt, listed_tasks, scenario_of, unlisted_tasks, yaml_text
from rqt_mrta_py.config.parameters.team import Team
from rqt_mrta_py.config.scenario.scenario_file import read_scenario
from rqt_mrta_py.config.xml.application import ApplicationFile, read_application_partly
from rqt_mrta_py.config.xml.architecture import read_architecture_partly
from rqt_mrta_py.config.xml.text import line_of, parse_xml
from rqt_mrta_py.errors import ConfigError, DiscoveryError, Problem
from rqt_mrta_py.model import ArchitectureSpec, ScenarioSpec, Task

__all__ = ["ApplicationFiles", "ArchitectureFile", "Subject"]


class ArchitectureFile(NamedTuple):
    """An architecture that is registered.

    Attributes:
        registration: by which it is.
        path: of its rqt_mrta.xml.
        spec: what the file says, without what is wrong; None if it cannot be read.
        problems: what its reader finds wrong.
    """

    registration: Registration
    path: Path
    spec: Optional[ArchitectureSpec]
    problems: Tuple[Problem, ...] = ()


class ApplicationFiles(NamedTuple):
    """An application that is registered, with everything that belongs to it; None is what cannot be read.

    Attributes:
        registration: by which it is.
        path: of its rqt_mrta.xml.
        file: what it says, and what of that is not certain.
        architecture: the architecture that it names.
        tasks: of its tasks.yaml, or those that its robots name where it has none.
        scenario: of its scenario.yaml; None too where it has none.
        team: whose parameters can be resolved.
    """

    registration: Registration
    path: Path
    file: Optional[ApplicationFile]
    architecture: Optional[ArchitectureSpec]
    tasks: Optional[Tuple[Task, ...]]
    scenario: Optional[ScenarioSpec]
    team: Optional[Team]

    @property
    def tasks_file(self) -> Optional[Path]:
        """Its tasks.yaml; None too where the one that the manifest names is missing."""
        path = self.registration.tasks
        return path if path is not None and path.is_file() else None


class Subject:
    """One package, or one rqt_mrta.xml that no package registers.

    Args:
        name: of the package.
        folder: of the package.
        manifest: its package.xml or manifest.xml; None: only the files of the registrations are examined.
        registrations: what it registers, in the manifest's order.
        host: what there is besides: other packages, plugins, message types.
    """

    def __init__(
        self, name: str, folder: Path, manifest: Optional[Path], registrations: Tuple[Registration, ...], host: Host
    ) -> None:
        self.name = name
        self.folder = folder
        self.manifest = manifest
        self.registrations = registrations
        self.host = host
        self._roots: Dict[Path, etree._Element] = {}
        self._problems: List[Problem] = []

    @property
    def place(self) -> Path:
        """Where to point when nothing closer is known."""
        return self.manifest or next((entry.file for entry in self.registrations if entry.file), self.folder)

    @property
    def problems(self) -> Tuple[Problem, ...]:
        """What the readers found wrong with architectures and applications; reads them all."""
        _ = self.architectures, self.applications
        return tuple(sorted(set(self._problems)))

    def root(self, path: Path) -> etree._Element:
        """Give the root element of an XML file.

        Raises:
            ConfigError: it cannot be read, or is not XML that is accepted here.
        """
        if path not in self._roots:
            root = parse_xml(read_file(path), str(path))
            if path == self.manifest:
                drop_namespace(root)
            self._roots[path] = root
        return self._roots[path]

    def line(self, path: Path, element: str) -> int:
        """Find the line of an element of an XML file.

        Args:
            path: the file.
            element: names from below the root, joined by ``/``; where it is missing its nearest parent counts.

        Returns:
            The 1-based line; 0 if the file cannot be read.
        """
        try:
            node = self.root(path)
        except ConfigError:
            return 0
        for name in element.split("/"):
            inner = node.find(name)
            if inner is None:
                break
            node = inner
        return line_of(node)

    @cached_property
    def architectures(self) -> Tuple[ArchitectureFile, ...]:
        """The architectures that the package registers and whose files are there."""
        return tuple(
            ArchitectureFile(entry, entry.file, *self._architecture(Source(entry.package, entry.file)))
            for entry in self.registrations
            if entry.kind is RegistrationKind.ARCHITECTURE and entry.file is not None and not entry.problems
        )

    @cached_property
    def applications(self) -> Tuple[ApplicationFiles, ...]:
        """The applications that the package registers and whose files are there."""
        return tuple(
            self._application(entry, entry.file)
            for entry in self.registrations
            if entry.kind is RegistrationKind.APPLICATION and entry.file is not None and entry.file.is_file()
        )

    def _architecture(self, source: Source) -> Tuple[Optional[ArchitectureSpec], Tuple[Problem, ...]]:
        path = source.file
        try:
            spec, problems = read_architecture_partly(read_file(path), str(path), source.package)
        except ConfigError as error:
            self._problems.extend(error.problems)
            return None, tuple(error.problems)
        self._problems.extend(problems)
        return spec, problems

    def _application(self, entry: Registration, path: Path) -> ApplicationFiles:
        note = self._problems
        file = attempt(note, lambda: read_application_partly(read_file(path), str(path), entry.package))
        if file is None:
            return ApplicationFiles(entry, path, None, None, None, None, None)
        note.extend(file.problems)
        source = None if file.gaps.architecture else attempt(note, lambda: self._source(file, path))
        architecture, wrong = self._architecture(source) if source is not None else (None, ())
        text = attempt(note, lambda: (_text(entry.tasks),))
        tasks = attempt(note, lambda: listed_tasks(file, text[0], str(entry.tasks or ""))) if text is not None else None
        team = None
        if tasks is not None:
            note.extend(unlisted_tasks(file, str(path), tasks, str(entry.tasks or "")))
        if architecture is not None and source is not None and tasks is not None and not wrong:
            team = Team(file.spec, path, architecture, source.file, tasks, _gaps(file, tasks))
        if text == (None,) and file.gaps.tasks:
            tasks = None  # There may be others, which only robots name.
        scenario = self._scenario(entry, file, tasks)
        return ApplicationFiles(entry, path, file, architecture, tasks, scenario, team)

    def _scenario(
        self, entry: Registration, file: ApplicationFile, tasks: Optional[Tuple[Task, ...]]
    ) -> Optional[ScenarioSpec]:
        """Read what is simulated; one that only does not fit the team is examined further."""
        place = str(entry.scenario or "")
        found: List[Problem] = []
        text = attempt(found, lambda: _text(entry.scenario))
        scenario = attempt(found, lambda: scenario_of(file, tasks, text, place))
        self._problems.extend(found)
        return attempt([], lambda: read_scenario(text, place)) if scenario is None and text is not None else scenario

    def _source(self, file: ApplicationFile, path: Path) -> Source:
        """Find the file of the architecture that an application names."""
        element = "application/architecture"
        if file.spec.architecture is None:
            message = "is missing; name the package of the architecture, mrta list architectures tells which there are"
            raise ConfigError([Problem(str(path), self.line(path, element), element, message)])
        try:
            return find_source(self.host.registry, file.spec.architecture, RegistrationKind.ARCHITECTURE)
        except DiscoveryError as error:
            raise ConfigError([Problem(str(path), self.line(path, element), element, str(error))]) from error


def _gaps(file: ApplicationFile, tasks: Sequence[Task]) -> Gaps:
    """Tell what is not certain of an application; a task that nobody lists may be meant to be another."""
    listed = {task.id for task in tasks}
    astray = [robot.id for robot in file.spec.robots if not listed.issuperset(robot.tasks)]
    return file.gaps._replace(tasks_of=tuple(dict.fromkeys([*file.gaps.tasks_of, *astray])))


def _text(path: Optional[Path]) -> Optional[str]:
    """Read a file; None where there is none, which is told of the manifest that names it."""
    return yaml_text(path) if path is not None and path.is_file() else None
