"""What one robot believes of another, and what may change it: the transition table, as data.

Four states are the paper's; a robot never heard of has none. From FAILED any message revives: to the state that it
implies, else IDLE.
"""

from __future__ import annotations

from enum import Enum
from typing import Dict, NamedTuple, Tuple

__all__ = ["ROBOT_ROWS", "RobotBelief", "RobotEvent", "RobotRow", "next_robot_state"]


class RobotBelief(Enum):
    """State of a robot, as another believes it to be."""

    IDLE = "idle"
    REQUESTING = "requesting"
    EXECUTING = "executing"
    FAILED = "failed"


class RobotEvent(Enum):
    """What can happen to a robot in the eyes of another."""

    REQUESTS = "it requests a task"
    EXECUTES = "it carries a task out, or takes an award"
    ENDS = "it has done, withdrawn or not been able to get to its task"
    AWARDS = "it awards what it requested to another"
    SPEAKS = "it says anything else"
    SILENCE = "it has been silent for too long, or says that it has failed"


class RobotRow(NamedTuple):
    """One row of the table: what an event makes of some states."""

    states: Tuple[RobotBelief, ...]
    event: RobotEvent
    to: RobotBelief


_B = RobotBelief
_E = RobotEvent

ROBOT_ROWS: Tuple[RobotRow, ...] = (
    RobotRow((_B.IDLE, _B.EXECUTING, _B.FAILED), _E.REQUESTS, _B.REQUESTING),
    RobotRow((_B.IDLE, _B.REQUESTING, _B.FAILED), _E.EXECUTES, _B.EXECUTING),
    RobotRow((_B.EXECUTING, _B.REQUESTING, _B.FAILED), _E.ENDS, _B.IDLE),
    RobotRow((_B.REQUESTING, _B.FAILED), _E.AWARDS, _B.IDLE),
    RobotRow((_B.FAILED,), _E.SPEAKS, _B.IDLE),
    RobotRow((_B.IDLE, _B.EXECUTING, _B.REQUESTING), _E.SILENCE, _B.FAILED),
)
"""Every row that changes something; what is not listed leaves a robot as it is."""

_TABLE: Dict[Tuple[RobotBelief, RobotEvent], RobotBelief] = {
    (state, row.event): row.to for row in ROBOT_ROWS for state in row.states
}


def next_robot_state(state: RobotBelief, event: RobotEvent) -> RobotBelief:
    """Give what an event makes of a state."""
    return _TABLE.get((state, event), state)
