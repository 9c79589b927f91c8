"""From the text of an architecture's rqt_mrta.xml to its specification."""

from __future__ import annotations

from typing import Optional, Sequence, Tuple, Union

from rqt_mrta_py.config.xml.element import Element
from rqt_mrta_py.config.xml.flavour import read_flavour
from rqt_mrta_py.config.xml.launches import read_launches
from rqt_mrta_py.config.xml.templates import read_configs
from rqt_mrta_py.config.xml.topics import read_topics
from rqt_mrta_py.model import AllocationType, ArchitectureSpec, RobotType, TaskType, Taxonomy, normalise_id
from rqt_mrta_py.wording import accepted

__all__ = ["read_architecture"]


def read_architecture(text: Union[str, bytes], path: str, package: str) -> ArchitectureSpec:
    """Read an architecture, as the dissertation prints it, as the original writes it, or with our additions.

    Args:
        text: the whole file.
        path: by which problems name the file.
        package: that registers it.

    Raises:
        ConfigError: with everything that is wrong, sorted by line.
    """
    return read_flavour(text, path, "architecture", "application", lambda root: _read(root, package))


def _read(root: Element, package: str) -> ArchitectureSpec:
    configs = read_configs(root)
    launches = read_launches(root)
    widgets = _read_widgets(root)
    architecture = root.child("architecture")
    if architecture is None:
        root.problem("architecture", "is missing or empty; it names the architecture and its topics")
        return ArchitectureSpec(package, "", Taxonomy())
    name = architecture.required("name")
    robots, tasks, allocations = (architecture.child(part) for part in ("robots", "tasks", "allocations"))
    config_ids = [config.id for config in configs]
    config_id = _reference(robots, "config_id", config_ids)
    if config_id is None and len(configs) == 1:
        config_id = configs[0].id
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
        robot_config_id=config_id,
        robot_launch_id=_reference(robots, "launch_id", [launch.id for launch in launches]),
        configs=configs,
        launches=launches,
        widgets=widgets,
    )
    for part in (robots, tasks, allocations, architecture):
        if part is not None:
            part.finish()
    return spec


def _type(part: Optional[Element]) -> str:
    return part.string("type") if part is not None else ""


def _reference(robots: Optional[Element], name: str, known: Sequence[str]) -> Optional[str]:
    """Read an id that must be one of this file's; None if it is absent."""
    found = robots.text(name) if robots is not None else None
    if found is None or robots is None:
        return None
    value = normalise_id(found.value)
    if value not in known:
        robots.problem(name, f"{value!r} is no id of this file; {accepted(value, known)}", found.line)
    return value


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
