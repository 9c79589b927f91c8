"""What one robot believes of one task, and what may change it: the transition table, as data.

Nine states are the paper's; events and rows are those of the table in ``docs/architectures/demir_cf.md``, by its
numbers. An event of ``OWN`` that the table does not list for a state cannot rightly happen there: whoever causes it
has made a mistake. Any other event is what was heard or seen, comes as it likes, and changes nothing if it is not
listed.
"""

from __future__ import annotations

from enum import Enum
from typing import Dict, FrozenSet, NamedTuple, Optional, Tuple

__all__ = ["HELD", "OWN", "TASK_ROWS", "TaskBelief", "TaskEvent", "TaskRow", "is_illegal", "task_row"]


class TaskBelief(Enum):
    """State of a task, as one robot believes it to be."""

    INITIAL = "initial"
    UNCERTAIN = "uncertain"
    REQUESTED = "requested"
    REQUESTED_OTHER = "requested_other"
    ASSIGNED = "assigned"
    EXECUTING = "executing"
    EXECUTING_OTHER = "executing_other"
    COMPLETED = "completed"
    UNACHIEVABLE = "unachievable"


class TaskEvent(Enum):
    """What can happen to a task in the eyes of one robot; "cheaper" compares (cost, robot id), smaller first."""

    SELECTED = "selected by this robot"
    REQUEST_HEARD = "requested by another"
    RIVAL_CHEAPER = "requested by another at less than this robot's request"
    RIVAL_DEARER = "requested by another at more than this robot's request"
    TAKEOVER_CHEAPER = "requested by another at less than this robot needs, by the margin"
    TAKEOVER_DEARER = "requested by another, but not at so much less"
    BID_HEARD = "a bid for this robot's request"
    AUCTION_WON = "deadline, and nobody bid less"
    AUCTION_LOST = "deadline, and another bid less"
    AWARD_TAKEN = "awarded to this robot, which is free"
    AWARD_REFUSED = "awarded to this robot, which is not"
    AWARD_TO_OTHER = "awarded to another"
    STARTED = "this robot sets out"
    EXECUTION_HEARD = "carried out by another"
    EXECUTION_CHEAPER = "carried out by another at less than by this robot"
    EXECUTION_DEARER = "carried out by another at more than by this robot"
    HEARTBEAT = "this robot has carried it out for another heartbeat"
    REACHED = "this robot has done it"
    BLOCKED = "this robot has found that it cannot get there"
    FAILURE = "this robot has failed"
    GIVEN_WAY = "another's request for another task goes first"
    RECALLED = "this robot prefers another, or an operator recalls it"
    EXCHANGED = "this robot hands it over to one that asked for it"
    OFFER_MADE = "this robot asks its executor for it"
    CANCELLED = "its holder withdraws"
    SILENCE = "its holder has been silent for too long, or has failed"
    COMPLETION_TOLD = "somebody has done it"
    UNACHIEVABLE_TOLD = "somebody has found that it cannot be got to"
    TOLD_EXECUTING = "a warning: another carries it out"
    TOLD_REQUESTED = "a warning: another requests it"
    TOLD_NEW = "it is there, or can be got to again"
    CLAIM_HEARD = "a request, execution, bid or award of what is over"


class TaskRow(NamedTuple):
    """One row of the table: what an event makes of some states."""

    number: int
    states: Tuple[TaskBelief, ...]
    event: TaskEvent
    to: TaskBelief


_B = TaskBelief
_E = TaskEvent
_FREE = (_B.INITIAL, _B.UNCERTAIN)
_AWARDABLE = (*_FREE, _B.REQUESTED, _B.REQUESTED_OTHER, _B.EXECUTING_OTHER)
_WARNED = (*_FREE, _B.REQUESTED, _B.REQUESTED_OTHER)
_NOT_COMPLETED = tuple(state for state in _B if state is not _B.COMPLETED)

HELD: Tuple[TaskBelief, ...] = (_B.REQUESTED, _B.ASSIGNED, _B.EXECUTING)
"""States of what a robot has committed itself to; at most one of its tasks is in any of them."""

TASK_ROWS: Tuple[TaskRow, ...] = (
    TaskRow(1, _FREE, _E.SELECTED, _B.REQUESTED),
    TaskRow(2, _FREE, _E.REQUEST_HEARD, _B.REQUESTED_OTHER),
    TaskRow(3, (*_FREE, _B.REQUESTED_OTHER), _E.EXECUTION_HEARD, _B.EXECUTING_OTHER),
    TaskRow(4, _FREE, _E.AWARD_TO_OTHER, _B.REQUESTED_OTHER),
    TaskRow(5, _AWARDABLE, _E.AWARD_TAKEN, _B.ASSIGNED),
    TaskRow(6, _AWARDABLE, _E.AWARD_REFUSED, _B.INITIAL),
    TaskRow(7, (_B.UNCERTAIN,), _E.CANCELLED, _B.INITIAL),
    TaskRow(8, (_B.REQUESTED,), _E.BID_HEARD, _B.REQUESTED),
    TaskRow(9, (_B.REQUESTED,), _E.AUCTION_WON, _B.ASSIGNED),
    TaskRow(10, (_B.REQUESTED,), _E.AUCTION_LOST, _B.REQUESTED_OTHER),
    TaskRow(11, (_B.REQUESTED,), _E.RIVAL_CHEAPER, _B.REQUESTED_OTHER),
    TaskRow(11, (_B.REQUESTED,), _E.AWARD_TO_OTHER, _B.REQUESTED_OTHER),
    TaskRow(12, (_B.REQUESTED,), _E.RIVAL_DEARER, _B.REQUESTED),
    TaskRow(13, HELD, _E.GIVEN_WAY, _B.INITIAL),
    TaskRow(14, (_B.REQUESTED,), _E.EXECUTION_HEARD, _B.EXECUTING_OTHER),
    TaskRow(14, (_B.ASSIGNED,), _E.EXECUTION_CHEAPER, _B.EXECUTING_OTHER),
    TaskRow(15, HELD, _E.RECALLED, _B.INITIAL),
    TaskRow(16, (_B.ASSIGNED,), _E.STARTED, _B.EXECUTING),
    TaskRow(17, (_B.EXECUTING,), _E.HEARTBEAT, _B.EXECUTING),
    TaskRow(18, (_B.EXECUTING,), _E.REACHED, _B.COMPLETED),
    TaskRow(19, (_B.EXECUTING,), _E.TAKEOVER_DEARER, _B.EXECUTING),
    TaskRow(19, (_B.EXECUTING,), _E.AWARD_TO_OTHER, _B.EXECUTING),
    TaskRow(20, (_B.EXECUTING,), _E.TAKEOVER_CHEAPER, _B.REQUESTED_OTHER),
    TaskRow(21, (_B.EXECUTING,), _E.EXECUTION_CHEAPER, _B.EXECUTING_OTHER),
    TaskRow(22, (_B.EXECUTING,), _E.EXECUTION_DEARER, _B.EXECUTING),
    TaskRow(23, (_B.EXECUTING,), _E.EXCHANGED, _B.REQUESTED_OTHER),
    TaskRow(24, (_B.ASSIGNED, _B.EXECUTING), _E.BLOCKED, _B.UNACHIEVABLE),
    TaskRow(25, HELD, _E.FAILURE, _B.INITIAL),
    TaskRow(26, (_B.REQUESTED_OTHER, _B.EXECUTING_OTHER), _E.CANCELLED, _B.INITIAL),
    TaskRow(27, (_B.REQUESTED_OTHER,), _E.SILENCE, _B.UNCERTAIN),
    TaskRow(28, (_B.EXECUTING_OTHER,), _E.EXECUTION_HEARD, _B.EXECUTING_OTHER),
    TaskRow(28, (_B.REQUESTED_OTHER,), _E.REQUEST_HEARD, _B.REQUESTED_OTHER),
    TaskRow(28, (_B.REQUESTED_OTHER,), _E.AWARD_TO_OTHER, _B.REQUESTED_OTHER),
    TaskRow(29, (_B.EXECUTING_OTHER,), _E.SILENCE, _B.UNCERTAIN),
    TaskRow(30, (_B.EXECUTING_OTHER,), _E.OFFER_MADE, _B.EXECUTING_OTHER),
    TaskRow(31, _NOT_COMPLETED, _E.COMPLETION_TOLD, _B.COMPLETED),
    TaskRow(32, _NOT_COMPLETED, _E.UNACHIEVABLE_TOLD, _B.UNACHIEVABLE),
    TaskRow(33, _WARNED, _E.TOLD_EXECUTING, _B.EXECUTING_OTHER),
    TaskRow(33, _WARNED, _E.TOLD_REQUESTED, _B.REQUESTED_OTHER),
    TaskRow(34, (_B.UNACHIEVABLE,), _E.TOLD_NEW, _B.INITIAL),
    TaskRow(35, (_B.UNACHIEVABLE,), _E.CLAIM_HEARD, _B.UNACHIEVABLE),
    TaskRow(36, (_B.COMPLETED,), _E.CLAIM_HEARD, _B.COMPLETED),
)
"""Every row but 37: a task that nobody had spoken of begins INITIAL."""

OWN: FrozenSet[TaskEvent] = frozenset(
    {
        _E.SELECTED,
        _E.RIVAL_CHEAPER,
        _E.RIVAL_DEARER,
        _E.TAKEOVER_CHEAPER,
        _E.TAKEOVER_DEARER,
        _E.AUCTION_WON,
        _E.AUCTION_LOST,
        _E.STARTED,
        _E.HEARTBEAT,
        _E.REACHED,
        _E.BLOCKED,
        _E.FAILURE,
        _E.GIVEN_WAY,
        _E.RECALLED,
        _E.EXCHANGED,
        _E.OFFER_MADE,
        _E.AWARD_TAKEN,
        _E.AWARD_REFUSED,
    }
)
"""Events that this robot itself decides on."""

_TABLE: Dict[Tuple[TaskBelief, TaskEvent], TaskRow] = {
    (state, row.event): row for row in TASK_ROWS for state in row.states
}


def task_row(state: TaskBelief, event: TaskEvent) -> Optional[TaskRow]:
    """Give the row for an event in a state; None if the table lists none, and nothing changes."""
    return _TABLE.get((state, event))


def is_illegal(state: TaskBelief, event: TaskEvent) -> bool:
    """Tell whether an event contradicts a state: the robot's own decision, and no row for it."""
    return event in OWN and (state, event) not in _TABLE
