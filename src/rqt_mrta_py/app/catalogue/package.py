"""Everything that a package registers, in full, as ``mrta show`` tells it."""

from __future__ import annotations

from typing import Any, Dict, List, NamedTuple, Sequence, Tuple

from rqt_mrta_py.app.catalogue.description import describe_application, describe_architecture
from rqt_mrta_py.app.catalogue.entries import application_of, architecture_of
from rqt_mrta_py.app.catalogue.mission_settings import mission_settings
from rqt_mrta_py.app.catalogue.parameter_rows import resolved_rows, written_rows
from rqt_mrta_py.config.discovery.registration import Registration, RegistrationKind, Registry
from rqt_mrta_py.config.discovery.source import find_registrations
from rqt_mrta_py.config.files import read_file
from rqt_mrta_py.config.loading import load_team
from rqt_mrta_py.config.scenario.scenario_file import read_scenario
from rqt_mrta_py.config.tasks.tasks_file import read_tasks
from rqt_mrta_py.errors import ConfigError, DiscoveryError, Problem
from rqt_mrta_py.model import ApplicationSpec, Task

__all__ = ["Described", "described"]


class Described(NamedTuple):
    """What was found under one name.

    Attributes:
        registered: a description of each registration whose files can be read, in the manifest's order; each begins
            with its ``kind``.
        problems: of the others.
    """

    registered: List[Dict[str, Any]]
    problems: Tuple[Problem, ...]


def described(registry: Registry, name: str) -> Described:
    """Describe everything that a package registers.

    Args:
        registry: what was found.
        name: of the package, its folder, or an rqt_mrta.xml.

    Raises:
        DiscoveryError: there is nothing of this name.
        ConfigError: it cannot be told what it registers.
    """
    found: List[Dict[str, Any]] = []
    problems: List[Problem] = []
    for registration in find_registrations(registry, name):
        try:
            found.append({"kind": registration.kind.value, **_description(registry, registration)})
        except ConfigError as error:
            problems.extend(error.problems)
    return Described(found, tuple(problems))


def _description(registry: Registry, registration: Registration) -> Dict[str, Any]:
    if registration.kind is RegistrationKind.ARCHITECTURE:
        return {**describe_architecture(architecture_of(registration)), "file": str(registration.file)}
    if registration.kind is RegistrationKind.APPLICATION:
        return _application(registry, registration)
    return {"name": registration.package, "module": registration.plugin, "folder": str(registration.folder)}


def _application(registry: Registry, registration: Registration) -> Dict[str, Any]:
    spec = application_of(registration)
    tasks = _tasks(registration, spec)
    scenario = None
    if registration.scenario is not None:
        scenario = read_scenario(read_file(registration.scenario), str(registration.scenario))
    problems: Sequence[str] = ()
    try:
        parameters = resolved_rows(load_team(registry, _loadable_name(registry, registration)).team)
    except (ConfigError, DiscoveryError) as error:
        # An application can be looked at before it can be run.
        parameters, problems = written_rows(spec.configs, str(registration.file)), str(error).splitlines()
    settings = mission_settings(registry, registration.package)
    description = describe_application(spec, tasks, scenario, parameters)
    description.update(settings=settings.rows, robots_by_default=settings.robots)
    return {**description, "file": str(registration.file), "problems": list(problems)}


def _loadable_name(registry: Registry, registration: Registration) -> str:
    """Give the name by which this very registration is found again."""
    of_its_name = (entry for entry in registry.of_kind(registration.kind) if entry.package == registration.package)
    return registration.package if next(of_its_name, None) == registration else str(registration.file)


def _tasks(registration: Registration, spec: ApplicationSpec) -> Tuple[Task, ...]:
    """Read the tasks; without a file they are those that robots name, each of a kind of its own."""
    if registration.tasks is not None:
        return read_tasks(read_file(registration.tasks), str(registration.tasks))
    return tuple(Task(name, kind=name) for name in dict.fromkeys(name for robot in spec.robots for name in robot.tasks))
