"""From a specification to the text of its rqt_mrta.xml.

What is written is read back before it is given away: a text that does not give the same specification again is
never handed out.
"""

from __future__ import annotations

from dataclasses import fields, is_dataclass
from typing import Any, Callable, Optional, Tuple

from lxml import etree

from rqt_mrta_py.config.problems import Problems
from rqt_mrta_py.config.xml.application import read_application
from rqt_mrta_py.config.xml.architecture import read_architecture
from rqt_mrta_py.config.xml.flavour import ROOT
from rqt_mrta_py.config.xml.ids import written_id
from rqt_mrta_py.config.xml.topics import BIDS
from rqt_mrta_py.config.xml.tree import Branch, document_text
from rqt_mrta_py.config.xml.writing_parts import write_configs, write_launches, write_topics, write_widgets
from rqt_mrta_py.errors import ConfigError, Problem
from rqt_mrta_py.model import ApplicationRobot, ApplicationSpec, ArchitectureSpec
from rqt_mrta_py.wording import shown

__all__ = ["write_application", "write_architecture"]

_FILE = "rqt_mrta.xml"


def write_architecture(spec: ArchitectureSpec) -> str:
    """Write the rqt_mrta.xml of an architecture.

    Args:
        spec: what it declares; lines of templates are not looked at.

    Returns:
        The whole file. ``read_architecture`` gives an equal specification again.

    Raises:
        ConfigError: something in it cannot stand in such a file; names the elements.
    """

    def write(root: Branch) -> None:
        top = root.inner("architecture")
        top.leaf("name", spec.name)
        robots, tasks, allocations = (top.inner(name) for name in ("robots", "tasks", "allocations"))
        robots.leaf("type", spec.taxonomy.robots.value)
        if spec.robot_config_id is not None:
            robots.leaf("config_id", written_id(spec.robot_config_id))
        elif len(spec.configs) == 1:
            robots.refuse("must have a config_id: readers give a file's only config to every robot")
        if spec.robot_launch_id is not None:
            robots.leaf("launch_id", written_id(spec.robot_launch_id))
        write_topics(robots, "busy_robots", spec.busy_robots)
        write_topics(robots, "idle_robots", spec.idle_robots)
        tasks.leaf("type", spec.taxonomy.tasks.value)
        write_topics(tasks, "incoming_tasks", spec.incoming_tasks)
        write_topics(tasks, "completed_tasks", spec.completed_tasks)
        write_topics(tasks, "failed_tasks", spec.failed_tasks)
        allocations.leaf("type", spec.taxonomy.allocations.value)
        write_topics(allocations, "allocated_tasks", spec.allocated_tasks)
        write_topics(allocations, BIDS, spec.bids)
        write_configs(root, spec.configs)
        write_launches(root, spec.launches)
        write_widgets(root, spec.widgets)

    return _written("architecture", spec, write, lambda text: read_architecture(text, _FILE, spec.package))


def write_application(spec: ApplicationSpec) -> str:
    """Write the rqt_mrta.xml of an application.

    Args:
        spec: what it declares; lines of templates are not looked at.

    Returns:
        The whole file. ``read_application`` gives an equal specification again.

    Raises:
        ConfigError: something in it cannot stand in such a file; names the elements.
    """

    def write(root: Branch) -> None:
        top = root.inner("application")
        top.leaf("name", spec.name)
        top.leaf("architecture", spec.architecture)
        if spec.robots:
            top.inner("robots").numbered("robot", spec.robots, _write_robot)
        write_configs(root, spec.configs)
        write_launches(root, spec.launches)

    return _written("application", spec, write, lambda text: read_application(text, _FILE, spec.package))


def _write_robot(branch: Branch, robot: ApplicationRobot) -> None:
    branch.leaf("id", written_id(robot.id))
    if robot.tasks:
        branch.inner("tasks").numbered("task", robot.tasks, lambda inner, task: inner.leaf("id", written_id(task)))


def _written(flavour: str, spec: Any, write: Callable[[Branch], None], read: Callable[[str], Any]) -> str:
    """Write a document, and make sure that it says what was meant."""
    problems = Problems(_FILE)
    root = etree.Element(ROOT, format=flavour)
    write(Branch(root, "", problems))
    problems.raise_if_any()
    text = document_text(root)
    try:
        given = read(text)
    except ConfigError as error:
        # Lines of a text that nobody has seen would only puzzle.
        raise ConfigError(Problem(_FILE, 0, found.element, found.message) for found in error.problems) from error
    different = _difference(spec, given, "")
    if different is not None:
        raise ConfigError([Problem(_FILE, 0, *different)])
    return text


def _difference(meant: Any, given: Any, path: str) -> Optional[Tuple[str, str]]:
    """Find the first place in which two specifications differ: where, and in what."""
    if meant == given:
        return None
    if is_dataclass(meant) and type(meant) is type(given):
        parts = [(field.name, getattr(meant, field.name), getattr(given, field.name)) for field in fields(meant)]
    elif isinstance(meant, (tuple, list)) and isinstance(given, tuple) and len(meant) == len(given):
        parts = [(str(number), *pair) for number, pair in enumerate(zip(meant, given))]
    else:
        parts = []
    for name, one, other in parts:
        different = _difference(one, other, f"{path}/{name}" if path else name)
        if different is not None:
            return different
    return path, f"would be read as {shown(given)} (got {shown(meant)}); write it so"
