"""Joining an application with its architecture, tasks, scenario and parameters into a mission."""

from __future__ import annotations

from pathlib import Path
from typing import Callable, Dict, List, Optional, Sequence, Tuple, TypeVar

from rqt_mrta_py.config.discovery.registration import RegistrationKind, Registry
from rqt_mrta_py.config.discovery.source import Source, find_source
from rqt_mrta_py.config.files import read_file
from rqt_mrta_py.config.parameters.parameter_file import parse_parameters
from rqt_mrta_py.config.parameters.team import ParameterChecks, Team, resolve_team
from rqt_mrta_py.config.scenario.event_order import appearing_tasks
from rqt_mrta_py.config.scenario.scenario_file import read_scenario
from rqt_mrta_py.config.tasks.tasks_file import read_tasks
from rqt_mrta_py.config.xml.application import ApplicationFile, read_application_file
from rqt_mrta_py.config.xml.architecture import read_architecture
from rqt_mrta_py.config.xml.text import decode_xml
from rqt_mrta_py.errors import ConfigError, Problem
from rqt_mrta_py.model import ApplicationSpec, Mission, MissionTexts, ScenarioSpec, Task
from rqt_mrta_py.wording import accepted, shown

__all__ = ["load_mission", "load_observed", "mission_from_texts"]

_T = TypeVar("_T")


def load_mission(
    registry: Registry,
    application: str,
    architecture: Optional[str] = None,
    *,
    seed: Optional[int] = 0,
    overrides: Sequence[str] = (),
    checks: Optional[ParameterChecks] = None,
) -> Mission:
    """Read everything that a mission needs.

    Args:
        registry: what is registered.
        application: a registered name, a package's folder, or an rqt_mrta.xml.
        architecture: likewise; None: the one that the application names.
        seed: of the run; None if there is none.
        overrides: parameters, each ``<robot>/<path>=<value>``.
        checks: asks plugins about the parameters; None: they are not asked.

    Raises:
        DiscoveryError: application or architecture is not registered, and no file either.
        ConfigError: with everything that is wrong in the files.
        HookError: a plugin failed when it was asked.
    """
    source = find_source(registry, application, RegistrationKind.APPLICATION)
    raw = read_file(source.file)
    file = read_application_file(raw, str(source.file), source.package)
    _expect_robots(file.spec, source)
    named = architecture or file.spec.architecture or _no_architecture(source)
    other = find_source(registry, named, RegistrationKind.ARCHITECTURE)
    other_raw = read_file(other.file)
    tasks_yaml, scenario_yaml = (_text(path) for path in (source.tasks, source.scenario))
    problems: List[Problem] = []
    spec = _attempt(problems, lambda: read_architecture(other_raw, str(other.file), other.package))
    tasks = _attempt(problems, lambda: _tasks(file, str(source.file), tasks_yaml, str(source.tasks or "")))
    scenario = _attempt(problems, lambda: _scenario(file, tasks, scenario_yaml, str(source.scenario or "")))
    if spec is None or tasks is None or problems:
        raise ConfigError(problems)
    team = Team(file.spec, source.file, spec, other.file, tasks)
    parameters = {robot: found.values for robot, found in resolve_team(team, overrides, checks).items()}
    texts = MissionTexts(decode_xml(raw), decode_xml(other_raw), tasks_yaml or "", scenario_yaml or "")
    first, later = _by_appearance(tasks, scenario)
    return Mission(file.spec, spec, first, parameters, scenario, seed, texts, later)


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
    spec = _attempt(
        problems, lambda: read_architecture(texts.architecture_xml, "architecture_xml", architecture_package)
    )
    tasks = _attempt(problems, lambda: _tasks(file, "application_xml", texts.tasks_yaml or None, "tasks_yaml"))
    scenario = _attempt(problems, lambda: _scenario(file, tasks, texts.scenario_yaml or None, "scenario_yaml"))
    if spec is None or tasks is None or problems:
        raise ConfigError(problems)
    first, later = _by_appearance(tasks, scenario)
    return Mission(file.spec, spec, first, parameters, scenario, seed, texts, later)


def _expect_robots(spec: ApplicationSpec, source: Source) -> None:
    if not spec.robots:
        raise ConfigError([Problem(str(source.file), 0, "application/robots", "names no robot; give at least one")])


def _no_architecture(source: Source) -> str:
    message = "is missing; name the architecture there, or on the command line (--architecture)"
    raise ConfigError([Problem(str(source.file), 0, "application/architecture", message)])


def _text(path: Optional[Path]) -> Optional[str]:
    if path is None:
        return None
    raw = read_file(path)
    try:
        return raw.decode("utf-8-sig")
    except UnicodeDecodeError as error:
        line = raw.count(b"\n", 0, error.start) + 1
        raise ConfigError([Problem(str(path), line, "", "is not UTF-8 text")]) from error


def _tasks(file: ApplicationFile, path: str, text: Optional[str], tasks_path: str) -> Tuple[Task, ...]:
    """Read the tasks, each of which has to be known; without a file a task's kind is its id."""
    wanted: Dict[str, List[str]] = {}
    for robot in file.spec.robots:
        for name in robot.tasks:
            wanted.setdefault(name, []).append(robot.id)
    if text is None:
        return tuple(Task(name, kind=name) for name in wanted)
    tasks = read_tasks(text, tasks_path)
    known = [task.id for task in tasks]
    problems = [
        Problem(
            path,
            file.task_lines.get((robot, name), 0),
            f"{robot}/tasks",
            f"{name!r} is not in {Path(tasks_path).name}; {accepted(name, known)}",
        )
        for name, robots in wanted.items()
        if name not in known
        for robot in robots
    ]
    if problems:
        raise ConfigError(problems)
    return tasks


def _scenario(
    file: ApplicationFile, tasks: Optional[Sequence[Task]], text: Optional[str], path: str
) -> Optional[ScenarioSpec]:
    if text is None:
        return None
    robots = [robot.id for robot in file.spec.robots]
    return read_scenario(text, path, robots, None if tasks is None else [task.id for task in tasks])


def _by_appearance(
    tasks: Tuple[Task, ...], scenario: Optional[ScenarioSpec]
) -> Tuple[Tuple[Task, ...], Tuple[Task, ...]]:
    """Part tasks that are there from the start from those that appear later, each in file order."""
    appearing = appearing_tasks(scenario.events if scenario is not None else ())
    first = tuple(task for task in tasks if task.id not in appearing)
    return first, tuple(task for task in tasks if task.id in appearing)


def _attempt(problems: List[Problem], step: Callable[[], _T]) -> Optional[_T]:
    """Take a step; note the problems of one that fails, so that those of all steps are told together."""
    try:
        return step()
    except ConfigError as error:
        problems.extend(error.problems)
        return None
