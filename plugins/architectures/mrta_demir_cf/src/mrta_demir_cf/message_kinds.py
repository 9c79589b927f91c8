"""The kinds of message that DEMiR-CF robots exchange, with what each says besides its head, and its closed sets."""

from __future__ import annotations

from enum import Enum
from typing import Dict, Tuple

from rqt_mrta_py.hooks import Subscription

__all__ = ["KIND_OF_TOPIC", "SUBSCRIPTIONS", "CancelReason", "Kind", "WarnedState"]


class Kind(Enum):
    """What a message is; the value is the name of its type in ``demir_cf_msgs``."""

    NEW_TASK = "NewTask"
    REQUEST = "Request"
    BID = "Bid"
    AWARD = "Award"
    EXECUTION = "Execution"
    COMPLETION = "Completion"
    CANCELLATION = "Cancellation"
    UNACHIEVABILITY = "Unachievability"
    WARNING = "Warning"
    EXCHANGE = "Exchange"
    HELLO = "Hello"

    @property
    def topic(self) -> str:
        """Its topic, which all robots share."""
        return _TOPICS[self]

    @property
    def type(self) -> str:
        """Its type, as ``pkg/Msg``."""
        return f"demir_cf_msgs/{self.value}"


class CancelReason(Enum):
    """Why a robot withdraws a claim."""

    DEARER_REQUEST = "dearer_request"
    DEARER_NEIGHBOUR = "dearer_neighbour"
    CHANGED_SCHEDULE = "changed_schedule"
    IMPROVED = "improved"
    PARALLEL = "parallel"
    HANDED_OVER = "handed_over"
    AWARD_REFUSED = "award_refused"
    FAILURE = "failure"
    OPERATOR = "operator"


class WarnedState(Enum):
    """What a warning says of a task."""

    COMPLETED = "completed"
    EXECUTING = "executing"
    REQUESTED = "requested"
    UNACHIEVABLE = "unachievable"


_TOPICS: Dict[Kind, str] = {
    Kind.NEW_TASK: "/demir_cf/new_tasks",
    Kind.REQUEST: "/demir_cf/requests",
    Kind.BID: "/demir_cf/bids",
    Kind.AWARD: "/demir_cf/awards",
    Kind.EXECUTION: "/demir_cf/executions",
    Kind.COMPLETION: "/demir_cf/completions",
    Kind.CANCELLATION: "/demir_cf/cancellations",
    Kind.UNACHIEVABILITY: "/demir_cf/unachievabilities",
    Kind.WARNING: "/demir_cf/warnings",
    Kind.EXCHANGE: "/demir_cf/exchanges",
    Kind.HELLO: "/demir_cf/hellos",
}

KIND_OF_TOPIC: Dict[str, Kind] = {topic: kind for kind, topic in _TOPICS.items()}

_HEAD = ("header/stamp", "robot_id", "recipient", "number", "position/x", "position/y", "completed")
_OWN: Dict[Kind, Tuple[str, ...]] = {
    Kind.NEW_TASK: ("place/x", "place/y", "map_stamp"),
    Kind.REQUEST: ("cost", "deadline"),
    Kind.BID: ("cost",),
    Kind.AWARD: ("winner",),
    Kind.EXECUTION: ("cost", "eta", "perpetual", "ordered"),
    Kind.COMPLETION: (),
    Kind.CANCELLATION: ("reason",),
    Kind.UNACHIEVABILITY: ("map_stamp",),
    Kind.WARNING: ("state", "holder", "cost", "map_stamp"),
    Kind.EXCHANGE: ("cost",),
    Kind.HELLO: (),
}

SUBSCRIPTIONS: Tuple[Subscription, ...] = tuple(
    Subscription(kind.topic, kind.type, (*_HEAD, *(() if kind is Kind.HELLO else ("task_id",)), *_OWN[kind]))
    for kind in Kind
)
"""What to subscribe to for ``messages.read_message``."""
