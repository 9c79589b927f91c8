"""The questions that a new package answers, as data: flags, prompts, the answers file and their checks follow these.

An application is asked for little more than this::

    package: yard_watch
    description: Two robots look after a yard.
    maintainer: Ann Example
    email: ann@example.org
    architecture: nearest_robot
    robots: [{id: robot1}, {id: robot2}]
    tasks: [{id: gate}, {id: shed}, {id: round, kind: wander}]
"""

from __future__ import annotations

from dataclasses import replace
from typing import Dict, Mapping

from rqt_mrta_py.config.discovery.registration import RegistrationKind
from rqt_mrta_py.config.scenario.form import ARENA
from rqt_mrta_py.config.tasks.task_text import TASK
from rqt_mrta_py.config.yaml.schema import Key, Table, ValueType
from rqt_mrta_py.model import ParameterType

__all__ = ["ANSWERS", "DEFAULT_KIND", "MEANINGS", "OPTIONAL"]

DEFAULT_KIND = "go_to_place"
"""Of a task of which nothing else is said."""

MEANINGS = (
    "busy_robots",
    "idle_robots",
    "incoming_tasks",
    "allocated_tasks",
    "completed_tasks",
    "failed_tasks",
)
"""What a monitored topic can tell."""

_PACKAGE = (
    Key(
        "workspace",
        ValueType.TEXT,
        "Enter the catkin workspace to put it into, which is made where it is missing; nothing for the current folder.",
        default="",
    ),
    Key("package", ValueType.TEXT, "Enter the package's name: lower-case letters, digits and underscores."),
    Key("name", ValueType.TEXT, "Enter the name for people.", default="the package's name in words"),
    Key("version", ValueType.TEXT, "Enter the version, three numbers.", default="1.0.0"),
    Key("description", ValueType.TEXT, "Enter in a sentence or two what it is for."),
    Key("maintainer", ValueType.TEXT, "Enter who looks after it."),
    Key("email", ValueType.TEXT, "Enter the maintainer's e-mail address."),
    Key("license", ValueType.TEXT, "Enter its license.", default="BSD"),
    Key("run_depends", ValueType.TEXTS, "Enter further ROS packages that are needed when it runs, if any.", default=()),
)

_JOIN = Table(
    "join",
    "Another topic that says for which task stands what is named in the task's place, for instance an auction.",
    (
        Key("name", ValueType.TEXT, "Absolute topic, which may hold @robot_id@ and @task_id@."),
        Key("type", ValueType.TEXT, "Message type, such as my_msgs/Auction."),
        Key("field", ValueType.TEXT, "Path of the id of what stands for a task."),
        Key("task_field", ValueType.TEXT, "Path of the id of that task."),
    ),
)

_WHEN = Table(
    "when",
    "Only messages in which a field has a value count.",
    (
        Key("field", ValueType.TEXT, "Path of a whole number, a string or a bool."),
        Key("value", ValueType.TEXT, 'The value, as a text: "0", "true".'),
    ),
)

_TOPIC = Table(
    "topic",
    "A topic by which robots and tasks are watched.",
    (
        Key("meaning", ValueType.TEXT, "What one message tells.", choices=MEANINGS),
        Key("name", ValueType.TEXT, "Absolute topic, which may hold @robot_id@ and @task_id@."),
        Key("type", ValueType.TEXT, "Message type, such as std_msgs/String."),
        Key("field", ValueType.TEXT, "Path of the text field with the id that this is about.", default=""),
        Key("robot_field", ValueType.TEXT, "Path of the robot's id where field is the task's.", default=""),
        Key("task_field", ValueType.TEXT, "Path of the task's id where field is the robot's.", default=""),
        Key("queue_size", ValueType.WHOLE, "Messages that are kept; 0 for all.", default=10, minimum=0),
        Key("timeout", ValueType.NUMBER, "How long one message keeps the state fresh.", "s", 2.0, above=0),
        Key("horizon", ValueType.NUMBER, "History window.", "s", 5.0, above=0),
        Key("join", ValueType.TABLE, "Who says for which task the id stands.", default=None, table=_JOIN),
        Key("when", ValueType.TABLE, "Which messages count; all if not given.", default=None, table=_WHEN),
    ),
)

_PARAMETER = Table(
    "parameter",
    "A parameter of every robot.",
    (
        Key("name", ValueType.TEXT, "Its name; a slash makes it a nested one."),
        Key("type", ValueType.TEXT, "What it holds.", choices=tuple(kind.value for kind in ParameterType)),
        Key("default", ValueType.TEXT, "Its default, as a text; without one it is mandatory.", default=None),
        Key("tool_tip", ValueType.TEXT, "What to enter, by custom with the unit in square brackets."),
    ),
)

_ROBOT = Table(
    "robot",
    "A robot of the team.",
    (
        Key("id", ValueType.TEXT, "Its name.", default="robot1, robot2 ..."),
        Key("tasks", ValueType.TEXTS, "Ids of the tasks that it may carry out.", default="all"),
    ),
)

_TASK_DEFAULTS = {"id": "task1, task2 ...", "kind": DEFAULT_KIND}
_TASK = replace(
    TASK,
    keys=tuple(
        replace(key, default=_TASK_DEFAULTS[key.name]) if key.name in _TASK_DEFAULTS else key for key in TASK.keys
    ),
)

_ARCHITECTURE = (
    Key("robots_type", ValueType.TEXT, "Enter ST where a robot carries out one task at a time, MT where several."),
    Key("tasks_type", ValueType.TEXT, "Enter SR where a task needs one robot, MR where several."),
    Key("allocations_type", ValueType.TEXT, "Enter IA where tasks are assigned for now, TA where planned ahead."),
    Key("plugin", ValueType.SWITCH, "Whether it gets a Python plugin to start from.", default=True),
    Key("topics", ValueType.TABLES, "The topics to watch, besides those of the plugin.", default=(), table=_TOPIC),
    Key("parameters", ValueType.TABLES, "Parameters, besides those of the plugin.", default=(), table=_PARAMETER),
)

_APPLICATION = (
    Key("architecture", ValueType.TEXT, "Enter by which architecture tasks are shared out: a name of mrta list."),
    Key("robots", ValueType.TABLES, "Enter the robots: how many, or their ids.", table=_ROBOT),
    Key("tasks", ValueType.TABLES, "Enter the tasks: how many, or their ids, as ID or ID:KIND.", table=_TASK),
    Key("parameters", ValueType.FREE, "Values by robot or config, nested as in its YAML file.", default={}),
    Key("world", ValueType.TEXT, "The world in which it is simulated.", default="planar"),
    Key("duration", ValueType.NUMBER, "Length of a simulated mission.", "s", 60.0, above=0),
    Key("arena", ValueType.TABLE, "Floor and walls; as large as needed if not given.", default=None, table=ARENA),
)

ANSWERS: Mapping[RegistrationKind, Table] = {
    RegistrationKind.ARCHITECTURE: Table(
        "answers of a new architecture",
        "What `mrta new architecture --answers FILE` reads; flags win over it.",
        (*_PACKAGE, *_ARCHITECTURE),
    ),
    RegistrationKind.APPLICATION: Table(
        "answers of a new application",
        "What `mrta new application --answers FILE` reads; flags win over it.",
        (*_PACKAGE, *_APPLICATION),
    ),
}
"""The questions of either kind of package, in the order in which they are asked and checked."""


def _optional(table: Table) -> Table:
    """Let every question be left out of a file, for a flag may answer it."""
    keys: Dict[str, Key] = {key.name: replace(key, default=None) for key in table.keys}
    return replace(table, keys=tuple(keys.values()))


OPTIONAL: Mapping[RegistrationKind, Table] = {kind: _optional(table) for kind, table in ANSWERS.items()}
"""The same as a file may answer them: none must be given there."""
