"""From the text of an application's rqt_mrta.xml to its specification."""

from __future__ import annotations

from typing import Dict, List, Mapping, NamedTuple, Optional, Sequence, Tuple, Union

from rqt_mrta_py.config.gaps import Gaps, part_of, touches
from rqt_mrta_py.config.xml.element import Element
from rqt_mrta_py.config.xml.flavour import read_flavour
from rqt_mrta_py.config.xml.ids import read_id
from rqt_mrta_py.config.xml.launches import read_launches
from rqt_mrta_py.config.xml.templates import read_configs
from rqt_mrta_py.errors import ConfigError, Problem
from rqt_mrta_py.model import ApplicationRobot, ApplicationSpec

__all__ = ["ApplicationFile", "read_application", "read_application_file", "read_application_partly"]


class ApplicationFile(NamedTuple):
    """An application and where its file gives tasks to robots.

    Attributes:
        spec: the application, without what is wrong.
        task_lines: 1-based line of each task of a robot, by the ids of robot and task.
        gaps: what is not certain because of what is wrong.
        problems: everything that is wrong, sorted by line.
    """

    spec: ApplicationSpec
    task_lines: Mapping[Tuple[str, str], int]
    gaps: Gaps = Gaps()
    problems: Tuple[Problem, ...] = ()


class _Places(NamedTuple):
    """Ids of what was read, by element."""

    robots: Dict[str, str]
    configs: Dict[str, str]


def read_application(text: Union[str, bytes], path: str, package: str) -> ApplicationSpec:
    """Read an application, as the dissertation prints it or as the original writes it.

    Args:
        text: the whole file.
        path: by which problems name the file.
        package: that registers it.

    Raises:
        ConfigError: with everything that is wrong, sorted by line.
    """
    return read_application_file(text, path, package).spec


def read_application_file(text: Union[str, bytes], path: str, package: str) -> ApplicationFile:
    """Read an application as ``read_application`` does, and keep its lines for checks against other files."""
    file = read_application_partly(text, path, package)
    if file.problems:
        raise ConfigError(file.problems)
    return file


def read_application_partly(text: Union[str, bytes], path: str, package: str) -> ApplicationFile:
    """Read an application as far as its file can be read, for whoever looks for more that is wrong.

    Args:
        text: the whole file.
        path: by which problems name the file.
        package: that registers it.

    Raises:
        ConfigError: there is no application in it; with everything that is wrong, sorted by line.
    """
    file, problems = read_flavour(text, path, "application", "architecture", lambda root: _read(root, package))
    return file._replace(problems=problems)


def _read(root: Element, package: str) -> Optional[ApplicationFile]:
    places = _Places({}, {})
    configs = read_configs(root, places.configs)
    launches = read_launches(root, {})
    task_lines: Dict[Tuple[str, str], int] = {}
    application = root.child("application")
    if application is None:
        root.problem("application", "is missing or empty; it names the application and its robots")
        root.finish()
        return None
    name = application.required("name")
    # The dissertation's files carry an empty url in the place of the architecture.
    application.ignore("url")
    architecture = application.string("architecture") or None
    robots = _read_robots(application.child("robots"), task_lines, places.robots)
    application.finish()
    root.finish()
    spec = ApplicationSpec(
        package=package,
        name=name,
        architecture=architecture,
        robots=robots,
        configs=configs,
        launches=launches,
    )
    return ApplicationFile(spec, task_lines, _gaps(root.flaws, spec, places))


def _gaps(flaws: Sequence[str], spec: ApplicationSpec, places: _Places) -> Gaps:
    robots = part_of(flaws, "application/robots", places.robots)
    configs = part_of(flaws, "configs", places.configs)
    is_named = spec.architecture is not None and not touches(flaws, "application/architecture")
    return Gaps(
        architecture=not is_named and not part_of(flaws, "application/architecture", {}).complete,
        robots=not robots.complete,
        tasks_of=robots.doubtful,
        configs=not configs.complete,
        values_of=configs.doubtful,
        launches=touches(flaws, "launches") or (not spec.launches and not part_of(flaws, "launches", {}).complete),
    )


def _read_robots(
    holder: Optional[Element], task_lines: Dict[Tuple[str, str], int], places: Dict[str, str]
) -> Tuple[ApplicationRobot, ...]:
    robots: List[ApplicationRobot] = []
    lines: Dict[str, int] = {}
    for _, _, element in holder.numbered(["robot"]) if holder is not None else ():
        name = read_id(element)
        if name in lines:
            element.problem("id", f"{name!r} names two robots; the first one is in line {lines[name]}")
            name = ""
        if name:
            lines[name] = element.line
        tasks = _read_tasks(element.child("tasks"), name, task_lines)
        element.finish()
        if name:
            robots.append(ApplicationRobot(name, tasks))
            places[element.path] = name
    if holder is not None:
        holder.finish()
    return tuple(robots)


def _read_tasks(holder: Optional[Element], robot: str, task_lines: Dict[Tuple[str, str], int]) -> Tuple[str, ...]:
    tasks: List[str] = []
    for _, _, element in holder.numbered(["task"]) if holder is not None else ():
        name = read_id(element)
        element.finish()
        if name in tasks:
            element.problem("id", f"{name!r} stands twice; name each task once")
        elif name:
            task_lines[robot, name] = element.line
            tasks.append(name)
    if holder is not None:
        holder.finish()
    return tuple(tasks)
