"""Messages of ``demir_cf_msgs``, as values: written by a robot, and read from anybody, who may be wrong."""

from __future__ import annotations

import math
from typing import Any, Dict, List, Mapping, NamedTuple, Optional, Union

from mrta_demir_cf.message_kinds import KIND_OF_TOPIC, CancelReason, Kind, WarnedState
from mrta_demir_cf.task_model import Position
from rqt_mrta_py.hooks import Heard, Outgoing
from rqt_mrta_py.model import normalise_id, wire_id

__all__ = ["Message", "Speaker", "read_message"]


class Message(NamedTuple):
    """What one robot said; fields that its kind does not have keep their defaults.

    Attributes:
        kind: what it is.
        robot: id of who said it.
        task: id of what it is about; empty for HELLO.
        recipient: id of whom it is for; empty for all.
        number: the sender's count.
        stamp: when it was said, on the sender's clock [s].
        position: where the sender is; None if it does not know.
        completed: the task that the sender has done last; empty if none.
        cost: the sender's; of WARNING the holder's; finite [m].
        deadline: of REQUEST, until when bids are waited for [s].
        winner: of AWARD, id of who shall carry the task out.
        eta: of EXECUTION, how long it will still take; 0 if it never ends [s].
        perpetual: of EXECUTION, whether it never ends.
        ordered: of EXECUTION, whether an operator gave the task to the sender.
        reason: of CANCELLATION; None if it is one that nobody knows.
        state: of WARNING, what the sender believes.
        holder: of WARNING, who holds the task; empty if nobody.
        place: of NEW_TASK, where it is; None if anywhere.
        map_stamp: when it was known whether the task can be reached; of WARNING, since when that is believed [s].
    """

    kind: Kind
    robot: str
    task: str = ""
    recipient: str = ""
    number: int = 0
    stamp: float = 0.0
    position: Optional[Position] = None
    completed: str = ""
    cost: float = 0.0
    deadline: float = 0.0
    winner: str = ""
    eta: float = 0.0
    perpetual: bool = False
    ordered: bool = False
    reason: Optional[CancelReason] = None
    state: Optional[WarnedState] = None
    holder: str = ""
    place: Optional[Position] = None
    map_stamp: float = 0.0


def read_message(heard: Heard) -> Union[Message, str]:
    """Read a message of ``SUBSCRIPTIONS``.

    Args:
        heard: from whomever.

    Returns:
        The message; or why it makes no sense: no sender, no task, no winner, a cost that is not finite or below 0, a
        time that is not finite, a state that there is none of, or a warning of a claim that names no holder.
    """
    kind, fields = KIND_OF_TOPIC[heard.topic], heard.fields
    robot, task = normalise_id(fields["robot_id"]), normalise_id(fields.get("task_id", ""))
    if not robot:
        return "it names no sender"
    if not task and kind is not Kind.HELLO:
        return "it names no task"
    for name in ("cost", "eta", "deadline", "map_stamp"):
        value = fields.get(name, 0.0)
        if not 0.0 <= value < math.inf:
            return f"its {name} is {value:g}; finite numbers from 0 are accepted"
    winner = normalise_id(fields.get("winner", ""))
    if kind is Kind.AWARD and not winner:
        return "it names no winner"
    state: Optional[WarnedState] = None
    holder = normalise_id(fields.get("holder", ""))
    if kind is Kind.WARNING:
        state = _STATES.get(fields["state"])
        if state is None:
            return f"its state is {fields['state']!r}; accepted: {', '.join(_STATES)}"
        if state in (WarnedState.EXECUTING, WarnedState.REQUESTED) and not holder:
            return "it names no holder"
    return Message(
        kind,
        robot,
        task,
        normalise_id(fields["recipient"]),
        fields["number"],
        fields["header/stamp"],
        _position(fields, "position"),
        normalise_id(fields["completed"]),
        fields.get("cost", 0.0),
        fields.get("deadline", 0.0),
        winner,
        fields.get("eta", 0.0),
        fields.get("perpetual", False),
        fields.get("ordered", False),
        _REASONS.get(fields.get("reason", "")),
        state,
        holder,
        _position(fields, "place"),
        fields.get("map_stamp", 0.0),
    )


class Speaker:
    """Writes one robot's messages and counts them.

    Attributes:
        completed: the task that the robot has done last, told with everything that it says; empty if none.
        said_at: when it last said anything to all [s].

    Args:
        robot_id: the robot's.
    """

    def __init__(self, robot_id: str) -> None:
        self.completed = ""
        self.said_at = -math.inf
        self._robot_id = robot_id
        self._number = 0
        self._said: List[Outgoing] = []
        self._now = 0.0
        self._position: Optional[Position] = None

    def begin(self, now: float, position: Optional[Position]) -> None:
        """Say from now on when and where what is said is said.

        Args:
            now: the time [s].
            position: where the robot is; None if it does not know.
        """
        self._now, self._position = now, position

    def say(self, kind: Kind, task: str = "", *, recipient: str = "", **own: Any) -> None:
        """Say something.

        Args:
            kind: what it is.
            task: what it is about; empty for HELLO.
            recipient: id of whom it is for; empty for all.
            own: the fields that only this kind has, by name.
        """
        self._number += 1
        fields: Dict[str, Any] = {
            "header": {"stamp": self._now, "frame_id": wire_id(self._robot_id)},
            "robot_id": self._robot_id,
            "recipient": recipient,
            "number": self._number,
            "position": _point(self._position),
            "completed": self.completed,
        }
        if kind is not Kind.HELLO:
            fields["task_id"] = task
        if "place" in own:
            own["place"] = _point(own["place"])
        fields.update(own)
        self._said.append(Outgoing(kind.topic, kind.type, fields))
        if not recipient:
            self.said_at = self._now

    def take(self) -> List[Outgoing]:
        """Give what was said since this was last asked, in order."""
        said, self._said = self._said, []
        return said


_STATES = {state.value: state for state in WarnedState}
_REASONS = {reason.value: reason for reason in CancelReason}


def _position(fields: Mapping[str, Any], name: str) -> Optional[Position]:
    x, y = fields.get(f"{name}/x", math.nan), fields.get(f"{name}/y", math.nan)
    return (x, y) if math.isfinite(x) and math.isfinite(y) else None


def _point(position: Optional[Position]) -> Dict[str, float]:
    x, y = position or (math.nan, math.nan)
    return {"x": x, "y": y, "z": 0.0}
