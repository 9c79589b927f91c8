"""Robots, tasks, topics and parameters among the answers: as a file's rows or as flags give them."""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import Any, List, Mapping, Optional, Tuple

from rqt_mrta_py.config.packages.answers_form import DEFAULT_KIND
from rqt_mrta_py.config.packages.origin import Origin
from rqt_mrta_py.config.parameters.lookup import leaves
from rqt_mrta_py.config.tasks.task_text import task_of
from rqt_mrta_py.config.yaml.rows import Row
from rqt_mrta_py.errors import ConfigError, Problem
from rqt_mrta_py.model import (
    MonitoredTopic,
    ParameterTemplate,
    ParameterType,
    Task,
    TopicCondition,
    TopicJoin,
    normalise_id,
)
from rqt_mrta_py.wording import shown

__all__ = [
    "ParameterEntry",
    "RobotEntry",
    "TaskEntry",
    "TopicEntry",
    "ValueEntry",
    "numbered_robots",
    "numbered_tasks",
    "parameter_entry",
    "robot_entry",
    "simple_task",
    "task_entry",
    "topic_entry",
    "value_entries",
]


@dataclass(frozen=True)
class RobotEntry:
    """A robot; ``tasks`` is None for all of them."""

    id: str
    tasks: Optional[Tuple[str, ...]]
    place: Origin


@dataclass(frozen=True)
class TaskEntry:
    """A task; ``says_perpetual`` tells whether it was said that it ends, or never does."""

    task: Task
    says_perpetual: bool
    place: Origin


@dataclass(frozen=True)
class TopicEntry:
    """A monitored topic and what it tells."""

    meaning: str
    topic: MonitoredTopic
    place: Origin


@dataclass(frozen=True)
class ParameterEntry:
    """A parameter that an architecture declares."""

    template: ParameterTemplate
    place: Origin


@dataclass(frozen=True)
class ValueEntry:
    """A parameter that an application sets: its path, robot or config first, and the text of its value."""

    path: str
    text: str
    place: Origin


def robot_entry(row: Row, path: str, number: int) -> RobotEntry:
    """Read a robot, the so-and-so-many-th of its file."""
    name = normalise_id(row.values["id"]) if "id" in row.given else f"robot{number}"
    tasks = tuple(normalise_id(task) for task in row.values["tasks"]) if "tasks" in row.given else None
    return RobotEntry(name, tasks, Origin(path, *row.at("id")))


def task_entry(row: Row, path: str, number: int) -> TaskEntry:
    """Read a task, the so-and-so-many-th of its file."""
    values = dict(row.values)
    if "id" not in row.given:
        values["id"] = f"task{number}"
    if "kind" not in row.given:
        values["kind"] = DEFAULT_KIND
    return TaskEntry(task_of(replace(row, values=values)), "perpetual" in row.given, Origin(path, *row.at("id")))


def topic_entry(row: Row, path: str, _number: int) -> TopicEntry:
    """Read a monitored topic."""
    values = dict(row.values)
    meaning, join, when = (values.pop(key) for key in ("meaning", "join", "when"))
    topic = MonitoredTopic(
        **values,
        join=None if join is None else TopicJoin(**join.values),
        condition=None if when is None else TopicCondition(**when.values),
    )
    return TopicEntry(meaning, topic, Origin(path, row.line, row.element))


def parameter_entry(row: Row, path: str, _number: int) -> ParameterEntry:
    """Read a parameter that is declared."""
    values = row.values
    template = ParameterTemplate(
        values["name"], ParameterType(values["type"]), default=values["default"], tool_tip=values["tool_tip"]
    )
    return ParameterEntry(template, Origin(path, *row.at("name")))


def value_entries(values: Mapping[str, Any], place: Origin) -> Tuple[ValueEntry, ...]:
    """Read values that stand nested, as in a robot's YAML file.

    Raises:
        ConfigError: one of them is a list, or nothing; parameters are single values.
    """
    entries: List[ValueEntry] = []
    problems: List[Problem] = []
    for names, value in leaves(values):
        path = "/".join(names)
        here = Origin(place.path, place.line, f"{place.element}/{path}")
        if isinstance(value, bool):
            entries.append(ValueEntry(path, "true" if value else "false", here))
        elif isinstance(value, (int, float, str)):
            entries.append(ValueEntry(path, str(value), here))
        else:
            problems.append(here.problem(f"must be a single value (got {shown(value)})"))
    if problems:
        raise ConfigError(problems)
    return tuple(entries)


def numbered_robots(count: int, place: Origin) -> Tuple[RobotEntry, ...]:
    """Make robots with automatic ids."""
    return tuple(RobotEntry(f"robot{number}", None, place) for number in range(1, count + 1))


def numbered_tasks(count: int, place: Origin) -> Tuple[TaskEntry, ...]:
    """Make tasks with automatic ids."""
    return tuple(simple_task(f"task{number}", DEFAULT_KIND, place) for number in range(1, count + 1))


def simple_task(name: str, kind: str, place: Origin) -> TaskEntry:
    """Make a task of which only id and kind are told."""
    return TaskEntry(Task(normalise_id(name), kind), False, place)
