"""The forms of what a scenario can make happen: for each kind, which keys and parameters it has.

From these tables files are checked, and their documentation is written.
"""

from __future__ import annotations

from typing import Tuple

from rqt_mrta_py.config.yaml.schema import Key, Table, ValueType
from rqt_mrta_py.model import ScenarioEventKind

__all__ = ["EVENT", "RADIO"]

_LARGEST_SHIFT = 1e6
"""A clock is off by no more; far beyond it stamps leave what ROS can tell [s]."""

RADIO = Table(
    "radio",
    "The radio between robots; further keys are the parameters of its model.",
    (Key("kind", ValueType.TEXT, "Name under which the link is registered."),),
    further=True,
)

_ROBOT = Key("robot", ValueType.TEXT, "Id of the robot that it happens to.")
_TASK = Key("task", ValueType.TEXT, "Id of the task that it happens to.")


def _parameters(*keys: Key) -> Key:
    return Key(
        "parameters",
        ValueType.TABLE,
        "How strongly, how far, to whom.",
        table=Table("parameters", "What this kind of event wants to know besides.", keys),
    )


_FORMS: Tuple[Tuple[ScenarioEventKind, str, Tuple[Key, ...]], ...] = (
    (ScenarioEventKind.ROBOT_STOPS, "A robot stands still and falls silent on all its topics.", (_ROBOT,)),
    (ScenarioEventKind.ROBOT_RETURNS, "A stopped robot is back; it undoes one stop.", (_ROBOT,)),
    (
        ScenarioEventKind.ROBOT_REMOVED,
        "A robot is taken off the floor for good, with what it holds; an operator tells so on /mrta/robot_removed.",
        (_ROBOT,),
    ),
    (ScenarioEventKind.ROBOT_STICKS, "A robot stands still, whatever it is commanded, but is heard.", (_ROBOT,)),
    (ScenarioEventKind.ROBOT_COMES_FREE, "A stuck robot can move again; it undoes one sticking.", (_ROBOT,)),
    (
        ScenarioEventKind.ROBOT_SLOWS,
        "A robot drives at a share of what it is commanded.",
        (
            _ROBOT,
            _parameters(
                Key("factor", ValueType.NUMBER, "Share of the commanded velocity; 1: all of it.", minimum=0, maximum=1)
            ),
        ),
    ),
    (
        ScenarioEventKind.ROBOT_CLOCK_SHIFTS,
        "A robot's clock becomes wrong, or right: set forward it jumps, set back it runs at half speed till it agrees.",
        (
            _ROBOT,
            _parameters(
                Key(
                    "offset",
                    ValueType.NUMBER,
                    "The robot's clock minus the true one; 0 sets it right.",
                    "s",
                    minimum=-_LARGEST_SHIFT,
                    maximum=_LARGEST_SHIFT,
                )
            ),
        ),
    ),
    (ScenarioEventKind.RADIO_FAILS, "A robot neither sends to nor hears from anybody else.", (_ROBOT,)),
    (ScenarioEventKind.RADIO_RETURNS, "A failed radio works again; it undoes one failure.", (_ROBOT,)),
    (
        ScenarioEventKind.RADIO_PARTITIONS,
        "Only robots that share a group reach one another, in place of any partition before.",
        (
            _parameters(
                Key("groups", ValueType.GROUPS, "Ids of the robots of each group; who is in none reaches nobody.")
            ),
        ),
    ),
    (ScenarioEventKind.RADIO_HEALS, "The partition ends.", ()),
    (
        ScenarioEventKind.RADIO_CHANGES,
        "The radio is of another kind, or has other parameters, from then on.",
        (Key("parameters", ValueType.TABLE, "The radio from then on.", table=RADIO),),
    ),
    (
        ScenarioEventKind.TASK_APPEARS,
        "A listed task is there; it was not before, if nothing happens to it earlier, or it is there again.",
        (_TASK,),
    ),
    (ScenarioEventKind.TASK_WITHDRAWN, "An operator takes a task back.", (_TASK,)),
    (
        ScenarioEventKind.TASK_REASSIGNED,
        "An operator wants a task to be carried out by another robot.",
        (_TASK, Key("robot", ValueType.TEXT, "Id of the robot that shall carry it out.")),
    ),
)

EVENT = Table(
    "event",
    "Something that happens at a given time, on purpose.",
    (
        Key("time", ValueType.NUMBER, "Mission time at which it happens.", "s", minimum=0),
        Key("kind", ValueType.TEXT, "What happens.", choices=tuple(kind.value for kind, _, _ in _FORMS)),
    ),
    by="kind",
    variants={kind.value: Table(kind.value, summary, keys) for kind, summary, keys in _FORMS},
)
