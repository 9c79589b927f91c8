"""The flags of ``mrta new``, and the answers that they and prompts give."""

from __future__ import annotations

import argparse
import re
from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING, Any, Dict, List, Tuple

from rqt_mrta_py.app.cli.common import positive
from rqt_mrta_py.wording import shown

if TYPE_CHECKING:
    from rqt_mrta_py.config.discovery.registration import RegistrationKind
    from rqt_mrta_py.config.packages.answers import Answers
    from rqt_mrta_py.config.packages.entries import RobotEntry, TaskEntry
    from rqt_mrta_py.config.packages.origin import Origin

__all__ = ["add_flags", "answers_by_flags", "robots_of_text", "tasks_of_text"]

_NUMBER = re.compile(r"\s*[-+]?([0-9]+\.?[0-9]*|\.[0-9]+)\s*\Z")
_MOST = 10_000
"""More robots or tasks than anybody simulates; a mistyped number must not fill the memory."""

_TEXTS = {
    "name": "name for people (default: the package's, in words)",
    "version": "three numbers (default: 1.0.0)",
    "description": "what it is for",
    "maintainer": "who looks after it",
    "email": "the maintainer's e-mail address",
    "license": "default: BSD",
}
_TYPES = {
    "robots_type": "ST or MT: a robot carries out one task at a time, or several",
    "tasks_type": "SR or MR: a task needs one robot, or several",
    "allocations_type": "IA or TA: tasks are assigned for now, or planned ahead",
}


def add_flags(parser: argparse.ArgumentParser, kind: str) -> None:
    """Say what a new package of a kind takes."""
    parser.add_argument("package", metavar="NAME", nargs="?", help="the package's name; its folder is made here")
    parser.add_argument("--answers", metavar="FILE", type=Path, help="YAML with answers; flags win over it")
    parser.add_argument("--workspace", metavar="DIR", help="a catkin workspace, made where it is missing")
    about = parser.add_argument_group("about the package")
    for key, text in _TEXTS.items():
        about.add_argument(f"--{key}", metavar="TEXT", help=text)
    about.add_argument(
        "--run-depend", metavar="PKG", dest="run_depends", action="append", help="a ROS package needed when it runs"
    )
    (_add_architecture if kind == "architecture" else _add_application)(parser)
    parser.add_argument("--yes", action="store_true", help="ask nothing: take defaults, name what is missing")
    parser.add_argument("--dry-run", action="store_true", help="write nothing; list what would be written")
    parser.add_argument("--json", action="store_true", help="print what is done as JSON")


def _add_architecture(parser: argparse.ArgumentParser) -> None:
    group = parser.add_argument_group("the architecture")
    group.add_argument("--type", metavar="ST-SR-IA", help="the three types in one")
    for key, text in _TYPES.items():
        group.add_argument(f"--{key.replace('_', '-')}", metavar=text[:8].replace(" or ", "|"), help=text)
    group.add_argument(
        "--topic",
        metavar="KEYS",
        dest="topics",
        action="append",
        help="a topic to watch, such as 'meaning: busy_robots, name: /busy, type: my_msgs/Busy, field: robot'; further "
        "keys, among them join and when, stand in docs/config.md, 'answers of a new architecture'",
    )
    group.add_argument(
        "--parameter",
        metavar="KEYS",
        dest="parameters",
        action="append",
        help="a parameter of every robot, such as 'name: speed, type: double, tool_tip: \"Enter it [m/s].\"'",
    )
    group.add_argument(
        "--no-plugin",
        dest="plugin",
        action="store_const",
        const=False,
        help="a description only, for nodes that exist elsewhere; no Python to start from",
    )


def _add_application(parser: argparse.ArgumentParser) -> None:
    group = parser.add_argument_group("the application")
    group.add_argument("--architecture", metavar="A", help="by which tasks are shared out: a registered name")
    robots = group.add_mutually_exclusive_group()
    robots.add_argument(
        "--robots", metavar="N", help="so many robots, robot1 and so on; or their ids, joined by commas"
    )
    robots.add_argument(
        "--robot", metavar="ID[:TASKS]", action="append", help="a robot; its tasks are joined by commas (default: all)"
    )
    tasks = group.add_mutually_exclusive_group()
    tasks.add_argument("--tasks", metavar="N", help="so many tasks, task1 and so on; or ID[:KIND], joined by commas")
    tasks.add_argument(
        "--task", metavar="ID[:KIND[:X,Y]]", action="append", help="a task, for instance gate:report:3,2.5 [m]"
    )
    group.add_argument("--set", metavar="PATH=VALUE", action="append", help="a parameter, for instance robot2/rate=10")
    group.add_argument("--world", metavar="W", help="in which it is simulated (default: planar)")
    group.add_argument("--duration", metavar="S", type=positive, help="of a simulated mission (default: 60)")


def answers_by_flags(kind: RegistrationKind, options: argparse.Namespace, otherwise: Answers) -> Answers:
    """Give the answers of the command line, covering others.

    Args:
        kind: ARCHITECTURE or APPLICATION.
        options: of the command line.
        otherwise: of a file.

    Raises:
        ConfigError: with everything in flags that cannot be read.
    """
    from rqt_mrta_py.config.packages.answers import Answer, flag_of
    from rqt_mrta_py.config.packages.origin import Origin
    from rqt_mrta_py.errors import ConfigError, Problem

    given: Dict[str, Any] = {}
    problems: List[Problem] = []
    for key in ("package", "workspace", *_TEXTS, "run_depends", *_TYPES, "plugin", "architecture", "world", "duration"):
        value = getattr(options, key, None)
        if value is not None:
            given[key] = Answer(tuple(value) if isinstance(value, list) else value, Origin(flag_of(key)))
    readers = (_type_answers, _table_answers) if kind.value == "architecture" else (_team_answers, _value_answers)
    for reader in readers:
        try:
            given.update((key, Answer(*answer)) for key, answer in reader(options, otherwise).items())
        except ConfigError as error:
            problems.extend(error.problems)
    if problems:
        raise ConfigError(problems)
    return otherwise.covered(given)


Given = Dict[str, Tuple[Any, "Origin"]]


def _type_answers(options: argparse.Namespace, _otherwise: Answers) -> Given:
    from rqt_mrta_py.config.packages.origin import Origin
    from rqt_mrta_py.errors import ConfigError

    if options.type is None:
        return {}
    place = Origin("--type")
    parts = [part.strip() for part in options.type.split("-")]
    if len(parts) != len(_TYPES):
        raise ConfigError([place.problem(f"{options.type!r}: three types joined by hyphens are expected")])
    return {key: (part, place) for key, part in zip(_TYPES, parts) if getattr(options, key) is None}


def _table_answers(options: argparse.Namespace, _otherwise: Answers) -> Given:
    """Read topics and parameters, each written as a mapping of YAML."""
    from rqt_mrta_py.config.packages.answers import entries_of_text
    from rqt_mrta_py.config.packages.origin import Origin

    found: Given = {}
    for key, flag in (("topics", "--topic"), ("parameters", "--parameter")):
        texts = getattr(options, key)
        if texts is not None:
            found[key] = (tuple(entry for text in texts for entry in entries_of_text(key, text, flag)), Origin(flag))
    return found


def _team_answers(options: argparse.Namespace, _otherwise: Answers) -> Given:
    from rqt_mrta_py.config.packages.origin import Origin

    found: Given = {}
    if options.robots is not None:
        found["robots"] = (robots_of_text(options.robots, Origin("--robots")), Origin("--robots"))
    if options.robot is not None:
        place = Origin("--robot")
        found["robots"] = (tuple(_robot(text, place) for text in options.robot), place)
    if options.tasks is not None:
        found["tasks"] = (tasks_of_text(options.tasks, Origin("--tasks")), Origin("--tasks"))
    if options.task is not None:
        place = Origin("--task")
        found["tasks"] = (tuple(_task(text, place) for text in options.task), place)
    return found


def _value_answers(options: argparse.Namespace, otherwise: Answers) -> Given:
    """Read values; those of a file stay unless one of the same path covers them."""
    from rqt_mrta_py.config.packages.entries import ValueEntry
    from rqt_mrta_py.config.packages.origin import Origin
    from rqt_mrta_py.errors import ConfigError, Problem

    if options.set is None:
        return {}
    entries: Dict[str, Any] = {entry.path: entry for entry in otherwise.values}
    problems: List[Problem] = []
    for text in options.set:
        path, equals, value = (part.strip() for part in text.partition("="))
        if not equals or not path:
            problems.append(Problem("--set", 0, "", f"{text!r}: PATH=VALUE is expected"))
        entries[path] = ValueEntry(path, value, Origin("--set"))
    if problems:
        raise ConfigError(problems)
    return {"parameters": (tuple(entries.values()), Origin("--set"))}


def robots_of_text(text: str, place: Origin) -> Tuple[RobotEntry, ...]:
    """Read how many robots there are, or their ids joined by commas."""
    from rqt_mrta_py.config.packages.entries import numbered_robots

    if text.strip().isdecimal():
        return numbered_robots(_count(text, place), place)
    return tuple(_robot(part, place) for part in text.split(",")) if text.strip() else ()


def tasks_of_text(text: str, place: Origin) -> Tuple[TaskEntry, ...]:
    """Read how many tasks there are, or their ids, with kinds behind colons, joined by commas."""
    from rqt_mrta_py.config.packages.entries import numbered_tasks

    if text.strip().isdecimal():
        return numbered_tasks(_count(text, place), place)
    return tuple(_task(part, place) for part in text.split(",")) if text.strip() else ()


def _count(text: str, place: Origin) -> int:
    from rqt_mrta_py.errors import ConfigError

    number = text.strip()
    if len(number) > len(str(_MOST)) or int(number) > _MOST:
        raise ConfigError([place.problem(f"must be up to {_MOST} (got {shown(number)})")])
    return int(number)


def _robot(text: str, place: Origin) -> RobotEntry:
    from rqt_mrta_py.config.packages.entries import RobotEntry
    from rqt_mrta_py.model import normalise_id

    name, colon, rest = text.partition(":")
    tasks = tuple(normalise_id(part.strip()) for part in rest.split(",") if part.strip())
    return RobotEntry(normalise_id(name.strip()), tasks if colon else None, place)


def _task(text: str, place: Origin) -> TaskEntry:
    from rqt_mrta_py.config.packages.answers_form import DEFAULT_KIND
    from rqt_mrta_py.config.packages.entries import simple_task
    from rqt_mrta_py.errors import ConfigError
    from rqt_mrta_py.model import Pose

    name, kind, where = (part.strip() for part in [*text.split(":", 2), "", ""][:3])
    entry = simple_task(name, kind or DEFAULT_KIND, place)
    if not where:
        return entry
    numbers = where.split(",")
    if len(numbers) not in (2, 3) or not all(_NUMBER.match(number) for number in numbers):
        raise ConfigError([place.problem(f"{text!r}: X,Y or X,Y,YAW is expected behind the kind, such as 1.5,-2")])
    return replace(entry, task=replace(entry.task, place=Pose(*map(float, [*numbers, "0"][:3]))))
