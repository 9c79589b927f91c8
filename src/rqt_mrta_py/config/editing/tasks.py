"""Tasks that come to an application, leave it, or get another id, with everything that names them."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any, Dict, Iterator, List, Optional, Tuple

from lxml import etree

from rqt_mrta_py.config.editing.draft import Draft, refused
from rqt_mrta_py.config.editing.free_place import free_place
from rqt_mrta_py.config.editing.mentions import (
    entry_index,
    event_mentions,
    id_mentions,
    predecessor_mentions,
    problems_of,
)
from rqt_mrta_py.config.editing.parameter_nodes import text_of
from rqt_mrta_py.config.editing.robots import robot_nodes, spelled
from rqt_mrta_py.config.editing.task_arrays import ArrayInConfig, add_task, remove_task, rename_task, task_arrays
from rqt_mrta_py.config.parameters.team import config_name, file_name
from rqt_mrta_py.errors import ConfigError
from rqt_mrta_py.model import Task, normalise_id
from rqt_mrta_py.wording import accepted, shown

__all__ = ["AddTask", "RemoveTask", "RenameTask"]

_Place = Tuple[float, ...]


@dataclass(frozen=True)
class AddTask:
    """A task comes.

    Attributes:
        id: of the new task.
        robots: that may carry it out; none: all.
        kind: names its behaviour; None: that of all other tasks, if they have one in common.
        place: x and y, and yaw if wanted, in the frame ``map`` [m, m, rad]; None: a free one if others of its kind
            have places, else none.
    """

    id: str
    robots: Tuple[str, ...] = ()
    kind: Optional[str] = None
    place: Optional[_Place] = None

    def apply(self, draft: Draft) -> None:
        """Enter it into tasks.yaml, to its robots in rqt_mrta.xml, and into arrays that say how long they are."""
        option = "--add-task"
        specs = draft.task_specs()
        _check_new(option, self.id, specs)
        nodes = robot_nodes(draft)
        for robot in self.robots:
            if robot not in nodes:
                raise refused(option, self.id, f"{robot!r} is no robot; {accepted(robot, nodes)}")
        listing = [robot.id for robot in draft.application().robots if robot.tasks]
        stray = [robot for robot in nodes if robot not in listing and robot not in self.robots]
        if self.robots and stray:
            message = f"{stray[0]} lists no tasks, so it takes every task; list its tasks in rqt_mrta.xml first"
            raise refused(option, self.id, message)
        if draft.tasks is not None:
            draft.tasks.append_entry("tasks", self._entry(draft, specs, option))
        elif self.place is not None or self.kind not in (None, self.id):
            raise refused(option, self.id, "has no kind and no place but its id, for there is no tasks.yaml; write one")
        elif not listing:
            raise refused(option, self.id, "has nowhere to stand, for there is no tasks.yaml; write one")
        for robot in dict.fromkeys(self.robots or listing):
            if robot in listing:
                holder = draft.xml.child(nodes[robot], "tasks")
                names = (each.node for each in draft.xml.numbered(holder, ["task"]))
                draft.xml.add_numbered(holder, "task", ["task"], [("id", spelled(self.id, names))])
        for here in _arrays(draft):
            if self.id in here.tasks:
                add_task(here, self.id)

    def _entry(self, draft: Draft, specs: Tuple[Task, ...], option: str) -> Dict[str, Any]:
        kinds = tuple(dict.fromkeys(task.kind for task in specs))
        if self.kind is None and len(kinds) != 1:
            raise refused(option, self.id, f"is of no kind; give --kind, such as {' or '.join(kinds) or 'go_to_place'}")
        kind = self.kind or kinds[0]
        entry: Dict[str, Any] = {"id": self.id, "kind": kind}
        place = self.place
        if place is None and any(task.kind == kind and task.place is not None for task in specs):
            place = self._free_place(draft, specs, option)
        if place is not None:
            entry["place"] = dict(zip(("x", "y", "yaw"), place))
        return entry

    def _free_place(self, draft: Draft, specs: Tuple[Task, ...], option: str) -> _Place:
        scenario = draft.scenario_spec()
        taken = [(task.place.x, task.place.y) for task in specs if task.place is not None]
        place = free_place(scenario, taken) if scenario is not None else None
        if place is None:
            raise refused(option, self.id, "has no place, as others of its kind have; give --place X,Y")
        return place


@dataclass(frozen=True)
class RemoveTask:
    """A task goes."""

    id: str

    def apply(self, draft: Draft) -> None:
        """Take it out of tasks.yaml, from its robots, and out of arrays of parameters."""
        option = "--remove-task"
        _check_known(option, self.id, draft)
        problems = [
            *problems_of(draft.scenario, event_mentions(draft.scenario, "task", self.id), repr(self.id)),
            *problems_of(draft.tasks, predecessor_mentions(draft.tasks, self.id), repr(self.id)),
        ]
        if problems:
            raise ConfigError(problems)
        for robot in draft.application().robots:
            if robot.tasks == (self.id,):
                message = f"is the only task of {robot.id}, which without a list would take every task; "
                raise refused(option, self.id, f"{message}give it another first, or remove the robot")
        for here in _arrays(draft):
            if self.id in here.tasks:
                remove_task(here, self.id)
        for node in _listed(draft, self.id):
            parent = node.getparent()
            draft.xml.remove(node)
            draft.xml.renumber(parent, ["task"])
        if draft.tasks is not None:
            index = entry_index(draft.tasks, "tasks", self.id)
            if index is not None:
                draft.tasks.remove_entry("tasks", index)


@dataclass(frozen=True)
class RenameTask:
    """A task gets another id."""

    old: str
    new: str

    def apply(self, draft: Draft) -> None:
        """Change the id wherever it stands; without a tasks.yaml the task's kind changes with it."""
        option = "--rename-task"
        _check_known(option, self.old, draft)
        _check_new(option, self.new, draft.task_specs())
        for here in _arrays(draft):
            rename_task(here, self.old, self.new)
        for node in _listed(draft, self.old):
            draft.xml.child(node, "id").text = spelled(self.new, [node])
        if draft.tasks is not None:
            mentions = [*id_mentions(draft.tasks, "tasks", self.old), *predecessor_mentions(draft.tasks, self.old)]
            draft.tasks.replace([each.node for each in mentions], self.new)
        if draft.scenario is not None:
            mentions = event_mentions(draft.scenario, "task", self.old)
            draft.scenario.replace([each.node for each in mentions], self.new)


def _listed(draft: Draft, task: str) -> List[etree._Element]:
    """Give the elements by which robots list a task."""
    nodes = [
        each.node for robot in robot_nodes(draft).values() for each in draft.xml.numbered(robot.find("tasks"), ["task"])
    ]
    return [node for node in nodes if normalise_id(text_of(node, "id")) == task]


def _arrays(draft: Draft) -> Iterator[ArrayInConfig]:
    """Give every array of the application's configs whose elements stand for tasks."""
    application, tasks = draft.application(), draft.task_specs()
    template = draft.template()
    names: List[Tuple[str, Any, Tuple[str, ...]]] = [
        (
            config_name(robot.id, template.id),
            template,
            tuple(task.id for task in application.tasks_of(robot.id, tasks)),
        )
        for robot in application.robots
    ]
    everything = tuple(task.id for task in tasks)
    names += [(file_name(each.id), each, everything) for each in draft.architecture.configs if each.id != template.id]
    for name, each, its_tasks in names:
        config = draft.nodes.config(name)
        if config is not None:
            for array in task_arrays(each):
                yield ArrayInConfig(draft.nodes, config, name, array, its_tasks)


def _check_known(option: str, name: str, draft: Draft) -> None:
    known = [task.id for task in draft.task_specs()]
    if name not in known:
        raise refused(option, name, f"is no task; {accepted(name, known)}")


def _check_new(option: str, name: str, specs: Tuple[Task, ...]) -> None:
    if not name or any(character.isspace() for character in name) or not name.isprintable():
        raise refused(option, name, f"must be a name without spaces (got {shown(name)})")
    if any(task.id == name for task in specs):
        raise refused(option, name, "is the id of a task already; give another")
