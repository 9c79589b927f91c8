"""What the supervisor knows of a mission at one moment, or at its end: immutable, ready to be drawn or written.

All times are seconds on the stream's clock (receipt). An interval still open ends at the record's ``end``.
"""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import Any, Mapping, NamedTuple, Optional, Tuple

from rqt_mrta_py.model.states import Outcome, RobotState, Severity, TaskState
from rqt_mrta_py.model.taxonomy import Taxonomy

__all__ = [
    "Allocation",
    "Event",
    "Evidence",
    "Incident",
    "MissionRecord",
    "RobotInterval",
    "RobotRecord",
    "TaskInterval",
    "TaskRecord",
]


class RobotInterval(NamedTuple):
    """A robot in one state over [start, end) [s]."""

    state: RobotState
    start: float
    end: float


class RobotRecord(NamedTuple):
    """One robot's history, oldest interval first; ``last_heard`` is None while nothing of it was heard [s]."""

    id: str
    states: Tuple[RobotInterval, ...]
    last_heard: Optional[float] = None

    @property
    def state(self) -> RobotState:
        """Give the newest state; offline before the first interval."""
        return self.states[-1].state if self.states else RobotState.OFFLINE


class TaskInterval(NamedTuple):
    """A task in one state over [start, end) [s]."""

    state: TaskState
    start: float
    end: float


class TaskRecord(NamedTuple):
    """One task's history, oldest interval first."""

    id: str
    history: Tuple[TaskInterval, ...]

    @property
    def state(self) -> TaskState:
        """Give the newest state; waiting before the first interval."""
        return self.history[-1].state if self.history else TaskState.WAITING


class Allocation(NamedTuple):
    """One robot on one task over [start, end) [s]; an open one ends at the end of the record."""

    task: str
    robot: str
    start: float
    end: float
    outcome: Outcome


@dataclass(frozen=True)
class Evidence:
    """A message that can be looked up.

    Attributes:
        topic: its topic.
        stamp: when it was received [s].
        index: its place among the messages of its topic, from 0, in the order of the stream.
    """

    topic: str
    stamp: float
    index: int


@dataclass(frozen=True)
class Incident:
    """Something that went wrong over [start, end) [s].

    Attributes:
        rule: name of the rule that found it.
        severity: how much it matters.
        start, end: when [s]; one that still lasts ends at the end of the record.
        robots, tasks: ids involved, sorted.
        text: one sentence that a tired engineer understands.
        evidence: messages that show it, oldest first.
        causes: what usually causes what this rule finds; empty if it does not say.
    """

    rule: str
    severity: Severity
    start: float
    end: float
    robots: Tuple[str, ...]
    tasks: Tuple[str, ...]
    text: str
    evidence: Tuple[Evidence, ...] = ()
    causes: str = ""


@dataclass(frozen=True)
class Event:
    """A change that the supervisor noticed.

    Attributes:
        time: when it fell due or was received [s].
        kind: ``robot_state``, ``task_state``, ``allocation_started``, ``allocation_ended``, ``incident`` or
            ``unreadable``.
        severity: how much it matters.
        text: one sentence.
        robot, task: ids it speaks of, None if none.
        state: the new state, outcome or rule, as written in files.
        causes: of an incident, what usually causes it; None if nobody says.
    """

    time: float
    kind: str
    severity: Severity
    text: str
    robot: Optional[str] = None
    task: Optional[str] = None
    state: Optional[str] = None
    causes: Optional[str] = None


@dataclass(frozen=True)
class MissionRecord:
    """Everything known of a mission between two moments of its stream.

    Attributes:
        application: package of the application; None if unknown.
        architecture: package of the architecture; None if unknown.
        taxonomy: of the architecture.
        seed: of the run; None if unknown.
        start: receipt of the stream's first message [s]; None before it.
        end: receipt of the newest message, or the moment asked for [s]; None before the first message.
        robots: in the application's order, then by first sight.
        tasks: in the mission's order, then by first sight.
        allocations: by start, then by the order in which they began.
        incidents: by start, then rule.
        events: in the order in which they were noticed.
        statistics: by name.
    """

    application: Optional[str]
    architecture: Optional[str]
    taxonomy: Taxonomy
    seed: Optional[int]
    start: Optional[float]
    end: Optional[float]
    robots: Tuple[RobotRecord, ...]
    tasks: Tuple[TaskRecord, ...]
    allocations: Tuple[Allocation, ...]
    incidents: Tuple[Incident, ...]
    events: Tuple[Event, ...]
    statistics: Mapping[str, Any] = field(default_factory=dict)
