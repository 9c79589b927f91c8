"""The form of an architecture's rqt_mrta.xml."""

from __future__ import annotations

from typing import Tuple

from rqt_mrta_py.config.schema.forms import Content, ElementForm, XmlForm
from rqt_mrta_py.config.schema.shared_elements import CONFIGS, GROUPS, LAUNCHES
from rqt_mrta_py.config.xml.flavour import ROOT
from rqt_mrta_py.model import AllocationType, RobotType, TaskType

__all__ = ["ARCHITECTURE_FILE"]

_SUPERVISOR = "supervisor"

_JOIN = ElementForm(
    "join",
    "Another topic that says for which task stands what is named in the task's place, for instance an auction: its "
    "newest message with that id does.",
    ours=True,
    children=(
        ElementForm(
            "name",
            "Name of that topic; `@robot_id@` and `@task_id@` in it stand for any.",
            Content.TOPIC,
            _SUPERVISOR,
            required=True,
        ),
        ElementForm("type", "Type of its messages.", Content.MESSAGE_TYPE, _SUPERVISOR, required=True),
        ElementForm("field", "Field with the id of what stands for a task.", Content.FIELD, _SUPERVISOR, required=True),
        ElementForm("task_field", "Field with that task's id.", Content.FIELD, _SUPERVISOR, required=True),
    ),
)

_WHEN = ElementForm(
    "when",
    "Only messages in which a field has a value count; the others are passed over.",
    ours=True,
    children=(
        ElementForm("field", "Field of a whole number, a string or a bool.", Content.FIELD, _SUPERVISOR, required=True),
        ElementForm("value", "The value, of a bool `true` or `false`.", Content.TEXT, _SUPERVISOR, required=True),
    ),
)

_TOPIC = ElementForm(
    "topic",
    "A topic; it is passed over where it holds nothing but numbers.",
    numbered=True,
    blank=True,
    children=(
        ElementForm(
            "name",
            "Its name; `@robot_id@` and `@task_id@` in it tell the robot or the task.",
            Content.TOPIC,
            _SUPERVISOR,
            required=True,
        ),
        ElementForm(
            "type", "Type of its messages, such as `std_msgs/String`.", Content.MESSAGE_TYPE, _SUPERVISOR, required=True
        ),
        ElementForm(
            "field",
            "Field of type string, such as `header/frame_id`, that holds the id of what this is about: robot or task; "
            "needed unless the name tells it.",
            Content.FIELD,
            _SUPERVISOR,
        ),
        ElementForm(
            "robot_field",
            "Field with the robot's id where this is about a task.",
            Content.FIELD,
            _SUPERVISOR,
            ours=True,
        ),
        ElementForm(
            "task_field", "Field with the task's id where this is about a robot.", Content.FIELD, _SUPERVISOR, ours=True
        ),
        ElementForm("queue_size", "Messages that a subscriber keeps; 0 keeps all.", Content.WHOLE, "show", default="0"),
        ElementForm("timeout", "How long one message keeps the state fresh.", Content.SECONDS, _SUPERVISOR, "s", "2.0"),
        ElementForm(
            "horizon",
            "How much of the past a window shows.",
            Content.SECONDS,
            "show",
            "s",
            "5.0",
        ),
        _JOIN,
        _WHEN,
    ),
)

_BIDS = ElementForm(
    "topic",
    "A topic, as elsewhere, with what is bid.",
    numbered=True,
    blank=True,
    children=(
        *_TOPIC.children,
        ElementForm(
            "bid_field", "Field with the number that is bid.", Content.FIELD, "review", required=True, ours=True
        ),
    ),
)


def _topics(name: str, summary: str, ours: bool = False, group: str = "topics") -> ElementForm:
    return ElementForm(name, summary, ours=ours, group=group)


def _type(summary: str, spellings: Tuple[str, ...]) -> ElementForm:
    return ElementForm(
        "type", summary, Content.TEXT, "list, doctor, supervisor", default="unknown", spellings=spellings
    )


_ROBOTS = ElementForm(
    "robots",
    "What is said of robots.",
    children=(
        _type("Whether a robot carries out one task at a time (ST) or several (MT).", RobotType.spellings()),
        ElementForm(
            "config_id",
            "Id of the config that every robot gets a copy of.",
            Content.ID,
            "run, configure",
            default="the only config, if there is but one",
        ),
        ElementForm("launch_id", "Id of the launch that every robot gets a copy of.", Content.ID, "configure"),
        _topics("busy_robots", "Topics that say that a robot is busy now."),
        _topics("idle_robots", "Topics that say that a robot is idle now."),
    ),
)

_TASKS = ElementForm(
    "tasks",
    "What is said of tasks.",
    children=(
        _type("Whether a task needs one robot (SR) or several (MR).", TaskType.spellings()),
        _topics("incoming_tasks", "Topics that say that a task has arrived."),
        _topics("completed_tasks", "Topics that say that a task is done.", ours=True),
        _topics("failed_tasks", "Topics that say that a task has failed.", ours=True),
    ),
)

_ALLOCATIONS = ElementForm(
    "allocations",
    "What is said of who does what.",
    children=(
        _type("Whether tasks are assigned for now only (IA) or planned ahead (TA).", AllocationType.spellings()),
        _topics("allocated_tasks", "Topics that say that a task is being carried out."),
        _topics("bids", "Topics that say what a robot bids for a task; `mrta review --why` tells it.", True, "bids"),
    ),
)

ARCHITECTURE_FILE = XmlForm(
    "architecture",
    "How a team shares out its tasks, and what tells of it.",
    ElementForm(
        ROOT,
        "The whole file.",
        children=(
            ElementForm(
                "architecture",
                "The architecture itself.",
                required=True,
                children=(
                    ElementForm("name", "Its name for people.", Content.TEXT, "list, show, pictures", required=True),
                    _ROBOTS,
                    _TASKS,
                    _ALLOCATIONS,
                ),
            ),
            CONFIGS,
            LAUNCHES,
            ElementForm(
                "widgets",
                "Panels of the monitor picture.",
                children=(
                    ElementForm(
                        "widget",
                        "One panel.",
                        numbered=True,
                        plain=False,
                        children=(
                            ElementForm(
                                "plugin_name",
                                "Name under which the panel is registered.",
                                Content.TEXT,
                                "pictures",
                                required=True,
                            ),
                        ),
                    ),
                ),
            ),
            ElementForm("application", "Stands in files of applications.", Content.NOTHING),
        ),
    ),
    "architecture",
    {"topics": (_TOPIC,), "bids": (_BIDS,), **GROUPS},
)
"""Every element of such a file."""
