"""From the text of an application's rqt_mrta.xml to its specification."""

from __future__ import annotations

from typing import Dict, List, Mapping, NamedTuple, Optional, Tuple, Union

from rqt_mrta_py.config.xml.element import Element
from rqt_mrta_py.config.xml.flavour import read_flavour
from rqt_mrta_py.config.xml.ids import read_id
from rqt_mrta_py.config.xml.launches import read_launches
from rqt_mrta_py.config.xml.templates import read_configs
from rqt_mrta_py.model import ApplicationRobot, ApplicationSpec

__all__ = ["ApplicationFile", "read_application", "read_application_file"]


class ApplicationFile(NamedTuple):
    """An application and where its file gives tasks to robots.

    Attributes:
        spec: the application.
        task_lines: 1-based line of each task of a robot, by the ids of robot and task.
    """

    spec: ApplicationSpec
    task_lines: Mapping[Tuple[str, str], int]


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
    return read_flavour(text, path, "application", "architecture", lambda root: _read(root, package))


def _read(root: Element, package: str) -> ApplicationFile:
    configs = read_configs(root)
    launches = read_launches(root)
    task_lines: Dict[Tuple[str, str], int] = {}
    application = root.child("application")
    if application is None:
        root.problem("application", "is missing or empty; it names the application and its robots")
        return ApplicationFile(ApplicationSpec(package, ""), task_lines)
    name = application.required("name")
    # The dissertation's files carry an empty url in the place of the architecture.
    application.ignore("url")
    architecture = application.string("architecture") or None
    robots = _read_robots(application.child("robots"), task_lines)
    application.finish()
    spec = ApplicationSpec(
        package=package,
        name=name,
        architecture=architecture,
        robots=robots,
        configs=configs,
        launches=launches,
    )
    return ApplicationFile(spec, task_lines)


def _read_robots(holder: Optional[Element], task_lines: Dict[Tuple[str, str], int]) -> Tuple[ApplicationRobot, ...]:
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
