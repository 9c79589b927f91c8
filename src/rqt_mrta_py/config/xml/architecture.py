"""From the text of an architecture's rqt_mrta.xml to its specification."""

from __future__ import annotations

from typing import Dict, Optional, Sequence, Tuple, Union

from rqt_mrta_py.config.gaps import part_of
from rqt_mrta_py.config.xml.element import Element, Text
from rqt_mrta_py.config.xml.flavour import read_flavour
from rqt_mrta_py.config.xml.launches import read_launches
from rqt_mrta_py.config.xml.templates import read_configs
from rqt_mrta_py.config.xml.topics import BIDS, read_topics
from rqt_mrta_py.errors import ConfigError, Problem
from rqt_mrta_py.model import AllocationType, ArchitectureSpec, RobotType, TaskType, Taxonomy, normalise_id
from rqt_mrta_py.wording import accepted

__all__ = ["read_architecture", "read_architecture_partly"]


def read_architecture(text: Union[str, bytes], path: str, package: str) -> ArchitectureSpec:
    """Read an architecture, as the dissertation prints it, as the original writes it, or with our additions.

    Args:
        text: the whole file.
        path: by which problems name the file.
        package: that registers it.

    Raises:
        ConfigError: with everything that is wrong, sorted by line.
    """
    spec, problems = read_architecture_partly(text, path, package)
    if problems:
        raise ConfigError(problems)
    return spec


def read_architecture_partly(
    text: Union[str, bytes], path: str, package: str
) -> Tuple[ArchitectureSpec, Tuple[Problem, ...]]:
    """Read an architecture as far as its file can be read, for whoever looks for more that is wrong.

    Args:
        text: the whole file.
        path: by which problems name the file.
        package: that registers it.

    Returns:
        The architecture, without what is wrong, and everything that is wrong, sorted by line.

    Raises:
        ConfigError: there is no architecture in it; with everything that is wrong, sorted by line.
    """
    return read_flavour(text, path, "architecture", "application", lambda root: _read(root, package))


def _read(root: Element, package: str) -> Optional[ArchitectureSpec]:
    config_places: Dict[str, str] = {}
    launch_places: Dict[str, str] = {}
    configs = read_configs(root, config_places)
    launches = read_launches(root, launch_places)
    widgets = _read_widgets(root)
    architecture = root.child("architecture")
    if architecture is None:
        root.problem("architecture", "is missing or empty; it names the architecture and its topics")
        root.finish()
        return None
    name = architecture.required("name")
    robots, tasks, allocations = (architecture.child(part) for part in ("robots", "tasks", "allocations"))
    config_id, launch_id = (robots.text(each) if robots is not None else None for each in ("config_id", "launch_id"))
    spec = ArchitectureSpec(
        package=package,
        name=name,
        taxonomy=Taxonomy(
            RobotType.parse(_type(robots)), TaskType.parse(_type(tasks)), AllocationType.parse(_type(allocations))
        ),
        busy_robots=read_topics(robots, "busy_robots"),
        idle_robots=read_topics(robots, "idle_robots"),
        incoming_tasks=read_topics(tasks, "incoming_tasks"),
        completed_tasks=read_topics(tasks, "completed_tasks"),
        failed_tasks=read_topics(tasks, "failed_tasks"),
        allocated_tasks=read_topics(allocations, "allocated_tasks"),
        bids=read_topics(allocations, BIDS),
        robot_config_id=configs[0].id if config_id is None and len(configs) == 1 else _id(config_id),
        robot_launch_id=_id(launch_id),
        configs=configs,
        launches=launches,
        widgets=widgets,
    )
    for part in (robots, tasks, allocations, architecture):
        if part is not None:
            part.finish()
    root.finish()
    flaws = root.flaws
    if robots is not None and part_of(flaws, "configs", config_places).complete:
        _check_reference(robots, "config_id", config_id, [config.id for config in configs])
    if robots is not None and part_of(flaws, "launches", launch_places).complete:
        _check_reference(robots, "launch_id", launch_id, [launch.id for launch in launches])
    return spec


def _type(part: Optional[Element]) -> str:
    return part.string("type") if part is not None else ""


def _id(found: Optional[Text]) -> Optional[str]:
    return normalise_id(found.value) if found is not None else None


def _check_reference(robots: Element, name: str, found: Optional[Text], known: Sequence[str]) -> None:
    """Note an id that must be one of this file's and is none."""
    if found is not None and normalise_id(found.value) not in known:
        value = normalise_id(found.value)
        robots.problem(name, f"{value!r} is no id of this file; {accepted(value, known)}", found.line)


def _read_widgets(root: Element) -> Tuple[str, ...]:
    holder = root.child("widgets")
    if holder is None:
        return ()
    names = []
    for _, _, element in holder.numbered(["widget"]):
        names.append(element.required("plugin_name"))
        element.finish()
    holder.finish()
    return tuple(names)
