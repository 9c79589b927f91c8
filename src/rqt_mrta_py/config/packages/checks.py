"""What is wrong with an answer, in the words of rqt_mrta's wizards and in the order in which they look."""

from __future__ import annotations

import keyword
import re
from typing import Any, Callable, Dict, Iterator, Mapping, NamedTuple, Optional, Sequence, Tuple

from rqt_mrta_py.config.discovery.registration import RegistrationKind
from rqt_mrta_py.config.packages.answers import Answers
from rqt_mrta_py.config.packages.answers_form import ANSWERS
from rqt_mrta_py.config.packages.entries import RobotEntry, TaskEntry
from rqt_mrta_py.config.yaml.schema import Key
from rqt_mrta_py.errors import Problem
from rqt_mrta_py.model import AllocationType, RobotType, TaskType, is_legal_name
from rqt_mrta_py.wording import accepted, shown

__all__ = ["Surroundings", "find_problems", "must_be_asked", "question", "wrong_with"]

_NAME = re.compile(r"[a-z][a-z0-9_]+\Z")
_VERSION = re.compile(r"[0-9]+\.[0-9]+\.[0-9]+\Z")


class Surroundings(NamedTuple):
    """What a new package has to fit into.

    Attributes:
        packages: names that are taken.
        architectures: that are registered, or may be named by a path.
        kinds: of tasks that somebody registers, each with the package that does.
        worlds: that somebody registers.
    """

    packages: Sequence[str]
    architectures: Sequence[str]
    kinds: Mapping[str, str]
    worlds: Sequence[str]


def question(kind: RegistrationKind, key: str) -> Key:
    """Give a question by its name."""
    return next(each for each in ANSWERS[kind].keys if each.name == key)


def must_be_asked(kind: RegistrationKind) -> Tuple[str, ...]:
    """List the questions without a default, in order."""
    wanted = {"package", "description", "maintainer", "email"}
    wanted |= {"robots_type", "tasks_type", "allocations_type", "architecture", "robots", "tasks"}
    return tuple(key.name for key in ANSWERS[kind].keys if key.name in wanted)


def find_problems(answers: Answers, around: Surroundings) -> Iterator[Problem]:
    """Find everything that is wrong with answers, missing ones among them."""
    for problems in answers.refused.values():
        yield from problems
    mandatory = must_be_asked(answers.kind)
    for key in ANSWERS[answers.kind].keys:
        if key.name in answers or (key.name in mandatory and key.name not in answers.refused):
            message = wrong_with(key.name, answers.value(key.name, ""), around)
            if message:
                yield answers.problem(key.name, message)
    if answers.kind is RegistrationKind.APPLICATION:
        known = None if "tasks" in answers.refused else [entry.task.id for entry in answers.tasks]
        yield from _of_robots(answers.robots, known)
        yield from _of_tasks(answers.tasks, around)
    else:
        if answers.value("plugin", True) and keyword.iskeyword(answers.text("package")):
            yield answers.problem("package", f"{answers.text('package')!r} is a word of Python; give another name")
        yield from _of_templates(answers)


def wrong_with(key: str, value: Any, around: Surroundings) -> Optional[str]:
    """Say what is wrong with one answer by itself; None if nothing is.

    Args:
        key: name of the question.
        value: the answer; empty where there is none.
        around: what it has to fit into.
    """
    if isinstance(value, str) and not value.isprintable():
        return f"must be a text of one line (got {shown(value)})"
    check = _CHECKS.get(key)
    return check(value, around) if check is not None else None


def _package(value: Any, around: Surroundings) -> Optional[str]:
    if not value:
        return "The package name must not be empty."
    if any(character.isspace() for character in value):
        return "The package name must not contain space characters."
    if not _NAME.match(value):
        return (
            "The package name must begin with a lower-case letter and hold lower-case letters, digits and underscores "
            f"(got {shown(value)})."
        )
    return f"The given package [{value}] already exists." if value in around.packages else None


def _given(message: str) -> Callable[[Any, Surroundings], Optional[str]]:
    return lambda value, _around: message if isinstance(value, str) and not value.strip() else None


def _version(value: Any, _around: Surroundings) -> Optional[str]:
    if not value.strip():
        return "The package version must be defined."
    return None if _VERSION.match(value) else f"must be three numbers joined by dots (got {shown(value)})"


def _email(value: Any, _around: Surroundings) -> Optional[str]:
    if "@" not in value:
        return "The e-mail of the package maintainer must be given."
    parts = value.split("@")
    sound = len(parts) == 2 and all(parts) and not any(character.isspace() for character in value)
    return None if sound else f"must be an e-mail address (got {shown(value)})"


def _type(axis: Any, name: str) -> Callable[[Any, Surroundings], Optional[str]]:
    def check(value: Any, _around: Surroundings) -> Optional[str]:
        known = [member.value for member in axis if member.value]
        if not value:
            return f"The {name} type must be selected: {' or '.join(known)}."
        return None if axis.parse(value).value else f"is not known (got {shown(value)}); accepted: {', '.join(known)}"

    return check


def _architecture(value: Any, around: Surroundings) -> Optional[str]:
    if not value:
        return "The architecture package must be given."
    if value in around.architectures or "/" in value:
        return None
    return f"no architecture of this name is registered (got {shown(value)}); {accepted(value, around.architectures)}"


def _world(value: Any, around: Surroundings) -> Optional[str]:
    return None if value in around.worlds else f"is not known (got {shown(value)}); {accepted(value, around.worlds)}"


def _duration(value: Any, _around: Surroundings) -> Optional[str]:
    return None if value > 0 else "must be above 0 s"


_CHECKS: Dict[str, Callable[[Any, Surroundings], Optional[str]]] = {
    "package": _package,
    "name": _given("The name must not be empty."),
    "version": _version,
    "description": _given("The package description must be given."),
    "maintainer": _given("The package maintainer must be given."),
    "email": _email,
    "license": _given("The package license must be defined."),
    "robots_type": _type(RobotType, "robots"),
    "tasks_type": _type(TaskType, "tasks"),
    "allocations_type": _type(AllocationType, "allocations"),
    "architecture": _architecture,
    "robots": lambda value, _around: None if value else "Enter the system robots.",
    "tasks": lambda value, _around: None if value else "Enter the robot tasks.",
    "world": _world,
    "duration": _duration,
}


def _of_robots(robots: Sequence[RobotEntry], tasks: Optional[Sequence[str]]) -> Iterator[Problem]:
    seen: Dict[str, None] = {}
    for robot in robots:
        message = _wrong_with_id(robot.id, "robot", seen)
        if message:
            yield robot.place.problem(message)
        if robot.tasks is not None and not robot.tasks:
            yield robot.place.problem(f"{robot.id}: Enter the robot tasks.")
        for name in robot.tasks or ():
            if tasks is not None and name not in tasks:
                yield robot.place.problem(f"{robot.id}: {name!r} is no task; {accepted(name, dict.fromkeys(tasks))}")


def _of_tasks(tasks: Sequence[TaskEntry], around: Surroundings) -> Iterator[Problem]:
    known = [entry.task.id for entry in tasks]
    seen: Dict[str, None] = {}
    for entry in tasks:
        task = entry.task
        message = _wrong_with_id(task.id, "task", seen)
        if message:
            yield entry.place.problem(message)
        if task.kind not in around.kinds:
            message = f"{task.id}: no behaviour of kind {task.kind!r} is registered"
            yield entry.place.problem(f"{message}; {accepted(task.kind, around.kinds)}")
        for index, layer in enumerate(task.layers):
            if layer not in around.kinds:
                message = f"{task.id}: no behaviour of kind {layer!r} is registered for its layer"
                yield entry.place.problem(f"{message}; {accepted(layer, around.kinds)}")
            elif layer in (task.kind, *task.layers[:index]):
                yield entry.place.problem(f"{task.id}: layer {layer!r} stands twice; its own kind is the lowest layer")
        for other in task.predecessors:
            if other not in known:
                yield entry.place.problem(f"{task.id}: {other!r} is no task; {accepted(other, known)}")


def _wrong_with_id(name: str, what: str, seen: Dict[str, None]) -> Optional[str]:
    if not name:
        return f"The {what} id must not be empty."
    if any(character.isspace() for character in name):
        return f"The {what} id must not contain <space>."
    if not is_legal_name(name) or name.startswith(("/", "~")) or (what == "task" and "/" in name):
        return f"The {what} id must begin with a letter and hold letters, digits and underscores (got {shown(name)})."
    if name in seen:
        return f"The {what} id {name!r} is given twice."
    seen[name] = None
    return None


def _of_templates(answers: Answers) -> Iterator[Problem]:
    seen: Dict[str, None] = {}
    for entry in answers.templates:
        name = entry.template.name
        if any(character.isspace() for character in name):
            yield entry.place.problem("The ParamInterface name must not contain <space>.")
        if not entry.template.tool_tip.strip():
            yield entry.place.problem("The param tool tip must be given. It helps the architecture users.")
        if name in seen:
            yield entry.place.problem(f"The parameter {name!r} is given twice.")
        seen[name] = None
