"""Robots that join an application, leave it, or get another id, with everything that names them."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any, Dict, List, Optional, Tuple

from lxml import etree

from rqt_mrta_py.config.editing.draft import Draft, refused
from rqt_mrta_py.config.editing.free_place import free_place
from rqt_mrta_py.config.editing.mentions import entry_index, event_mentions, id_mentions, problems_of
from rqt_mrta_py.config.editing.parameter_nodes import text_of
from rqt_mrta_py.config.parameters.context import Path
from rqt_mrta_py.config.parameters.team import config_name, file_name
from rqt_mrta_py.config.yaml.text import parse_yaml
from rqt_mrta_py.errors import ConfigError
from rqt_mrta_py.model import (
    ROBOT_TOKEN,
    ApplicationRobot,
    ConfigTemplate,
    ParameterTemplate,
    is_legal_name,
    normalise_id,
)
from rqt_mrta_py.wording import accepted, shown

__all__ = ["AddRobot", "RemoveRobot", "RenameRobot", "own_id_parameters", "robot_nodes", "spelled"]

_OWN_ID = ("name", "robot_id", "id")
_EQUIPMENT = ("model", "sensors", "capabilities", "map")


@dataclass(frozen=True)
class AddRobot:
    """A robot joins.

    Attributes:
        id: of the new robot.
        tasks: ids of its tasks; none: all, which are listed if other robots list theirs.
    """

    id: str
    tasks: Tuple[str, ...] = ()

    def apply(self, draft: Draft) -> None:
        """Enter it into rqt_mrta.xml and scenario, where it starts at a free place."""
        option = "--add-robot"
        robots = draft.application().robots
        _check_new(option, self.id, robots)
        known = [task.id for task in draft.task_specs()]
        for task in self.tasks:
            if task not in known:
                raise refused(option, self.id, f"{task!r} is no task; {accepted(task, known)}")
        tasks = tuple(dict.fromkeys(self.tasks)) or (tuple(known) if any(robot.tasks for robot in robots) else ())
        application = draft.xml.child(draft.xml.root, "application")
        holder = draft.xml.child(application, "robots")
        leaves = [("id", spelled(self.id, robot_nodes(draft).values()))]
        node = draft.xml.add_numbered(holder, "robot", ["robot"], leaves)
        if tasks:
            inner = draft.xml.add(node, "tasks")
            for task in tasks:
                draft.xml.add_numbered(inner, "task", ["task"], [("id", task)])
        self._start(draft, option)

    def _start(self, draft: Draft, option: str) -> None:
        scenario = draft.scenario_spec()
        if scenario is None or draft.scenario is None:
            return
        place = free_place(scenario)
        if place is None:
            raise refused(option, self.id, "finds no free place to start at; make the arena of the scenario larger")
        plain: Any = parse_yaml(draft.scenario.text, draft.scenario.path)
        last = plain.plain()["robots"][-1:]
        entry: Dict[str, Any] = {"id": self.id, "start": {"x": place[0], "y": place[1]}}
        entry.update((key, robot[key]) for robot in last for key in _EQUIPMENT if key in robot)
        draft.scenario.append_entry("robots", entry)


@dataclass(frozen=True)
class RemoveRobot:
    """A robot leaves."""

    id: str

    def apply(self, draft: Draft) -> None:
        """Take it out of rqt_mrta.xml, with its config and launch, and out of the scenario."""
        node = _existing("--remove-robot", draft, self.id)
        problems = problems_of(draft.scenario, event_mentions(draft.scenario, "robot", self.id), repr(self.id))
        if problems:
            raise ConfigError(problems)
        parent = node.getparent()
        draft.xml.remove(node)
        draft.xml.renumber(parent, ["robot"])
        draft.nodes.remove_config(config_name(self.id, draft.template().id))
        for launch in _launches(draft, self.id):
            holder = launch.getparent()
            draft.xml.remove(launch)
            draft.xml.renumber(holder, ["launch"])
        if draft.scenario is not None:
            index = entry_index(draft.scenario, "robots", self.id)
            if index is not None:
                draft.scenario.remove_entry("robots", index)


@dataclass(frozen=True)
class RenameRobot:
    """A robot gets another id."""

    old: str
    new: str

    def apply(self, draft: Draft) -> None:
        """Change the id wherever it stands."""
        option = "--rename-robot"
        node = _existing(option, draft, self.old)
        _check_new(option, self.new, draft.application().robots)
        draft.xml.child(node, "id").text = spelled(self.new, [node])
        self._rename_config(draft)
        for launch in _launches(draft, self.old):
            self._rename_launch(draft, launch)
        if draft.scenario is not None:
            mentions = [
                *id_mentions(draft.scenario, "robots", self.old),
                *event_mentions(draft.scenario, "robot", self.old),
            ]
            draft.scenario.replace([each.node for each in mentions], self.new)

    def _rename_config(self, draft: Draft) -> None:
        template = draft.template()
        config = draft.nodes.config(config_name(self.old, template.id))
        if config is None:
            return
        draft.xml.child(config, "id").text = f"{self.new}_{template.id}"
        paths = own_id_parameters(template)
        for placed in draft.nodes.walk(config):
            if placed.is_value and placed.path in paths:
                for leaf in ("value", "default"):
                    if normalise_id(text_of(placed.node, leaf)) == self.old:
                        draft.nodes.set_text(placed, leaf, self.new)

    def _rename_launch(self, draft: Draft, launch: etree._Element) -> None:
        draft.xml.child(launch, "id").text = f"{self.new}_{draft.architecture.robot_launch_id}"
        configs = [config.id for config in draft.architecture.configs]
        for node in launch.iter("value", "default", "file"):
            text = (node.text or "").strip()
            if normalise_id(text) == self.old:
                node.text = self.new
            for config in configs:
                before, after = (f"{config_name(name, config)}." for name in (self.old, self.new))
                if before in text:
                    node.text = text.replace(before, after)


def robot_nodes(draft: Draft) -> Dict[str, etree._Element]:
    """Give the elements of the robots by id, in the order of their numbers."""
    holder = draft.xml.root.find("application/robots")
    return {normalise_id(text_of(each.node, "id")): each.node for each in draft.xml.numbered(holder, ["robot"])}


def own_id_parameters(template: ConfigTemplate) -> Tuple[Path, ...]:
    """Give the paths of a robot's parameters that hold its own id."""
    parameters = [item for item in template.items if isinstance(item, ParameterTemplate)]
    return tuple(
        tuple(item.name.split("/"))
        for item in parameters
        if ROBOT_TOKEN in (item.value, item.default) or item.name in _OWN_ID
    )


def spelled(name: str, others: Any) -> str:
    """Spell an id as others in the file are, with or without a leading slash."""
    texts = [text_of(node, "id") for node in others]
    return f"/{name}" if texts and texts[-1].startswith("/") else name


def _existing(option: str, draft: Draft, name: str) -> etree._Element:
    nodes = robot_nodes(draft)
    if name not in nodes:
        raise refused(option, name, f"is no robot; {accepted(name, nodes)}")
    return nodes[name]


def _check_new(option: str, name: str, robots: Tuple[ApplicationRobot, ...]) -> None:
    if not name or not is_legal_name(f"/{name}"):
        raise refused(option, name, f"must be a name that ROS accepts: letters, digits and _ (got {shown(name)})")
    if any(robot.id == name for robot in robots):
        raise refused(option, name, "is the id of a robot already; give another")


def _launches(draft: Draft, robot: str) -> List[etree._Element]:
    """Give the application's own launches of a robot."""
    wanted: Optional[str] = draft.architecture.robot_launch_id
    if wanted is None:
        return []
    nodes = [each.node for each in draft.xml.numbered(draft.xml.root.find("launches"), ["launch"])]
    return [node for node in nodes if file_name(normalise_id(text_of(node, "id"))) == config_name(robot, wanted)]
