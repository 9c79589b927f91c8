"""Reading the files of an application and of its architecture, and checking them against one another."""

from __future__ import annotations

from pathlib import Path
from typing import Callable, Dict, List, NamedTuple, Optional, Sequence, Tuple, TypeVar

from rqt_mrta_py.config.discovery.registration import RegistrationKind, Registry
from rqt_mrta_py.config.discovery.source import Source, find_source
from rqt_mrta_py.config.files import read_file
from rqt_mrta_py.config.parameters.team import Team
from rqt_mrta_py.config.scenario.scenario_file import read_scenario
from rqt_mrta_py.config.tasks.tasks_file import read_tasks
from rqt_mrta_py.config.xml.application import ApplicationFile, read_application_file
from rqt_mrta_py.config.xml.architecture import read_architecture
from rqt_mrta_py.config.xml.text import decode_xml
from rqt_mrta_py.errors import ConfigError, Problem
from rqt_mrta_py.model import ApplicationSpec, MissionTexts, ScenarioSpec, Task
from rqt_mrta_py.wording import accepted

__all__ = [
    "LoadedTeam",
    "MissionFiles",
    "Rewriting",
    "attempt",
    "listed_tasks",
    "load_team",
    "scenario_of",
    "tasks_of",
    "unlisted_tasks",
    "yaml_text",
]

_T = TypeVar("_T")


class MissionFiles(NamedTuple):
    """What an application's tasks and scenario are read from.

    Attributes:
        tasks: text; None where there is none.
        scenario: likewise.
        tasks_path: by which problems name it.
        scenario_path: likewise.
    """

    tasks: Optional[str]
    scenario: Optional[str]
    tasks_path: str
    scenario_path: str


Rewriting = Callable[[ApplicationSpec, MissionFiles], MissionFiles]
"""From an application and its files to what is read in their place."""


class LoadedTeam(NamedTuple):
    """What the files of an application and its architecture say.

    Attributes:
        team: both of them, and the tasks.
        scenario: what is simulated; None if there is none.
        texts: of the files.
        tasks_path: by which problems name the tasks' text; empty if there is none.
    """

    team: Team
    scenario: Optional[ScenarioSpec]
    texts: MissionTexts
    tasks_path: str = ""


def load_team(
    registry: Registry,
    application: str,
    architecture: Optional[str] = None,
    read: Callable[[Path], bytes] = read_file,
    rewrite: Optional[Rewriting] = None,
) -> LoadedTeam:
    """Read application, architecture, tasks and scenario.

    Args:
        registry: what is registered.
        application: a registered name, a package's folder, or an rqt_mrta.xml.
        architecture: likewise; None: the one that the application names.
        read: gives the content of a file.
        rewrite: gives tasks and scenario in place of the files; None: they are read as they are.

    Raises:
        DiscoveryError: application or architecture is not registered, and no file either.
        ConfigError: with everything that is wrong in the files.
    """
    source = find_source(registry, application, RegistrationKind.APPLICATION)
    raw = read(source.file)
    file = read_application_file(raw, str(source.file), source.package)
    _expect_robots(file.spec, source)
    named = architecture or file.spec.architecture or _no_architecture(source)
    other = find_source(registry, named, RegistrationKind.ARCHITECTURE)
    other_raw = read(other.file)
    texts = [yaml_text(path, read) for path in (source.tasks, source.scenario)]
    files = MissionFiles(texts[0], texts[1], str(source.tasks or ""), str(source.scenario or ""))
    if rewrite is not None:
        files = rewrite(file.spec, files)
    problems: List[Problem] = []
    spec = attempt(problems, lambda: read_architecture(other_raw, str(other.file), other.package))
    tasks = attempt(problems, lambda: tasks_of(file, str(source.file), files.tasks, files.tasks_path))
    scenario = attempt(problems, lambda: scenario_of(file, tasks, files.scenario, files.scenario_path))
    if spec is None or tasks is None or problems:
        raise ConfigError(problems)
    team = Team(file.spec, source.file, spec, other.file, tasks)
    told = MissionTexts(decode_xml(raw), decode_xml(other_raw), files.tasks or "", files.scenario or "")
    return LoadedTeam(team, scenario, told, files.tasks_path)


def tasks_of(file: ApplicationFile, path: str, text: Optional[str], tasks_path: str) -> Tuple[Task, ...]:
    """Read the tasks, each of which has to be known; without a file a task's kind is its id."""
    tasks = listed_tasks(file, text, tasks_path)
    problems = unlisted_tasks(file, path, tasks, tasks_path)
    if problems:
        raise ConfigError(problems)
    return tasks


def listed_tasks(file: ApplicationFile, text: Optional[str], tasks_path: str) -> Tuple[Task, ...]:
    """Read the tasks of a tasks.yaml; without one those that robots name, each of the kind of its id."""
    if text is None:
        return tuple(Task(name, kind=name) for name in _wanted(file))
    return read_tasks(text, tasks_path)


def unlisted_tasks(file: ApplicationFile, path: str, tasks: Sequence[Task], tasks_path: str) -> List[Problem]:
    """Find tasks that robots name and nobody lists."""
    known = [task.id for task in tasks]
    # Of a file its name is enough; what was made is named by what it was made of.
    name_of_tasks = Path(tasks_path).name if Path(tasks_path).is_absolute() else tasks_path
    return [
        Problem(
            path,
            file.task_lines.get((robot, name), 0),
            f"{robot}/tasks",
            f"{name!r} is not in {name_of_tasks}; {accepted(name, known)}",
        )
        for name, robots in _wanted(file).items()
        if name not in known
        for robot in robots
    ]


def scenario_of(
    file: ApplicationFile, tasks: Optional[Sequence[Task]], text: Optional[str], path: str
) -> Optional[ScenarioSpec]:
    """Read what is simulated, which has to fit robots and tasks; None where there is no file."""
    if text is None:
        return None
    robots = None if file.gaps.robots else [robot.id for robot in file.spec.robots]
    return read_scenario(text, path, robots, None if tasks is None else [task.id for task in tasks])


def attempt(problems: List[Problem], step: Callable[[], _T]) -> Optional[_T]:
    """Take a step; note the problems of one that fails, so that those of all steps are told together."""
    try:
        return step()
    except ConfigError as error:
        problems.extend(error.problems)
        return None


def _wanted(file: ApplicationFile) -> Dict[str, List[str]]:
    """Tell which robots name each task, in the order of the file."""
    wanted: Dict[str, List[str]] = {}
    for robot in file.spec.robots:
        for name in robot.tasks:
            wanted.setdefault(name, []).append(robot.id)
    return wanted


def _expect_robots(spec: ApplicationSpec, source: Source) -> None:
    if not spec.robots:
        raise ConfigError([Problem(str(source.file), 0, "application/robots", "names no robot; give at least one")])


def _no_architecture(source: Source) -> str:
    message = "is missing; name the architecture there, or on the command line (--architecture)"
    raise ConfigError([Problem(str(source.file), 0, "application/architecture", message)])


def yaml_text(path: Optional[Path], read: Callable[[Path], bytes] = read_file) -> Optional[str]:
    """Read the text of a YAML file; None where there is none."""
    if path is None:
        return None
    raw = read(path)
    try:
        return raw.decode("utf-8-sig")
    except UnicodeDecodeError as error:
        line = raw.count(b"\n", 0, error.start) + 1
        raise ConfigError([Problem(str(path), line, "", "is not UTF-8 text")]) from error
