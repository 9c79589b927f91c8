"""Joining an application with its architecture, tasks, scenario and parameters into a mission."""

from __future__ import annotations

from typing import Collection, List, Mapping, Optional, Sequence, Tuple

from rqt_mrta_py.config.discovery.registration import RegistrationKind, Registry
from rqt_mrta_py.config.discovery.source import find_source
from rqt_mrta_py.config.files import read_file
from rqt_mrta_py.config.fitting import misfit_problems
from rqt_mrta_py.config.loading import Rewriting, attempt, load_team, scenario_of, tasks_of
from rqt_mrta_py.config.parameters.layers import Layer
from rqt_mrta_py.config.parameters.parameter_file import parse_parameters
from rqt_mrta_py.config.parameters.task_layers import layered_tasks
from rqt_mrta_py.config.parameters.team import ParameterChecks, resolve_team
from rqt_mrta_py.config.scenario.event_order import appearing_tasks
from rqt_mrta_py.config.xml.application import read_application_file
from rqt_mrta_py.config.xml.architecture import read_architecture
from rqt_mrta_py.errors import ConfigError, Problem
from rqt_mrta_py.model import ApplicationSpec, Mission, MissionTexts, ScenarioSpec, Task
from rqt_mrta_py.wording import shown

__all__ = ["load_mission", "load_observed", "mission_from_texts"]


def load_mission(
    registry: Registry,
    application: str,
    architecture: Optional[str] = None,
    *,
    seed: Optional[int] = 0,
    overrides: Sequence[str] = (),
    served: Optional[Mapping[str, Layer]] = None,
    checks: Optional[ParameterChecks] = None,
    must_fit: bool = True,
    kinds: Optional[Collection[str]] = None,
    rewrite: Optional[Rewriting] = None,
) -> Mission:
    """Read everything that a mission needs.

    Args:
        registry: what is registered.
        application: a registered name, a package's folder, or an rqt_mrta.xml.
        architecture: likewise; None: the one that the application names.
        seed: of the run; None if there is none.
        overrides: parameters, each ``<robot>/<path>=<value>``.
        served: parameters by robot that cover those of files, and are covered by overrides.
        checks: asks plugins about the parameters; None: they are not asked.
        must_fit: refuse tasks that the architecture does not solve; what has been run already need not fit.
        kinds: of behaviours that there are, to know layers by that a config of the whole team lists for tasks; None:
            they are not looked for.
        rewrite: gives tasks and scenario in place of the application's files; None: they are read as they are.

    Raises:
        DiscoveryError: application or architecture is not registered, and no file either.
        ConfigError: with everything that is wrong in the files.
        HookError: a plugin failed when it was asked.
    """
    loaded = load_team(registry, application, architecture, rewrite=rewrite)
    team = loaded.team
    problems: List[Problem] = []
    if must_fit:
        problems.extend(misfit_problems(team.architecture, team.tasks, loaded.texts.tasks_yaml, loaded.tasks_path))
    resolved = attempt(problems, lambda: resolve_team(team, overrides, checks, served=served))
    tasks = team.tasks if kinds is None else attempt(problems, lambda: layered_tasks(team, kinds))
    if resolved is None or tasks is None or problems:
        raise ConfigError(problems)
    parameters = {robot: found.values for robot, found in resolved.items()}
    first, later = _by_appearance(tasks, loaded.scenario)
    return Mission(team.application, team.architecture, first, parameters, loaded.scenario, seed, loaded.texts, later)


def load_observed(registry: Registry, architecture: str) -> Mission:
    """Make a mission of which only the architecture is known, for a bag that says nothing of itself.

    Args:
        registry: what is registered.
        architecture: a registered name, a package's folder, or an rqt_mrta.xml.

    Returns:
        A mission without robots and tasks, its application's names empty.

    Raises:
        DiscoveryError: the architecture is not registered, and no file either.
        ConfigError: with everything that is wrong in its file.
    """
    source = find_source(registry, architecture, RegistrationKind.ARCHITECTURE)
    spec = read_architecture(read_file(source.file), str(source.file), source.package)
    return Mission(ApplicationSpec("", "", spec.package), spec, ())


def mission_from_texts(
    texts: MissionTexts,
    application_package: str,
    architecture_package: str,
    parameters_yaml: str,
    seed: Optional[int],
) -> Mission:
    """Rebuild a mission from the texts that its message carries; nothing of it needs to be installed.

    Args:
        texts: the files.
        application_package: that registered the application.
        architecture_package: that registered the architecture.
        parameters_yaml: resolved parameters by robot id.
        seed: of the run; None if unknown.

    Raises:
        ConfigError: with everything that is wrong in the texts; problems name the message's fields as files.
    """
    file = read_application_file(texts.application_xml, "application_xml", application_package)
    parameters = parse_parameters(parameters_yaml, "parameters_yaml")
    for robot, values in parameters.items():
        if not isinstance(values, dict):
            message = f"must be a mapping (got {shown(values)}); parameters stand by robot"
            raise ConfigError([Problem("parameters_yaml", 0, robot, message)])
    problems: List[Problem] = []
    spec = attempt(
        problems, lambda: read_architecture(texts.architecture_xml, "architecture_xml", architecture_package)
    )
    tasks = attempt(problems, lambda: tasks_of(file, "application_xml", texts.tasks_yaml or None, "tasks_yaml"))
    scenario = attempt(problems, lambda: scenario_of(file, tasks, texts.scenario_yaml or None, "scenario_yaml"))
    if spec is None or tasks is None or problems:
        raise ConfigError(problems)
    first, later = _by_appearance(tasks, scenario)
    return Mission(file.spec, spec, first, parameters, scenario, seed, texts, later)


def _by_appearance(
    tasks: Tuple[Task, ...], scenario: Optional[ScenarioSpec]
) -> Tuple[Tuple[Task, ...], Tuple[Task, ...]]:
    """Part tasks that are there from the start from those that appear later, each in file order."""
    appearing = appearing_tasks(scenario.events if scenario is not None else ())
    first = tuple(task for task in tasks if task.id not in appearing)
    return first, tuple(task for task in tasks if task.id in appearing)
