"""Incident rules: what counts as going wrong, judged from facts of supervision and, if need be, from messages."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import Callable, NamedTuple, Optional, Protocol, Sequence, Union

from rqt_mrta_py.hooks.oddity import (
    AllocationExpired,
    TaskApplicability,
    TaskClaimed,
    TaskEndTold,
    UnknownRobotNamed,
    UnknownTaskNamed,
)
from rqt_mrta_py.hooks.pace import AllocationPace
from rqt_mrta_py.hooks.stream import Heard, Subscription
from rqt_mrta_py.model import Evidence, Mission, Outcome, RobotState, Severity, TaskState

__all__ = [
    "AllocationEnded",
    "AllocationStarted",
    "ClockOff",
    "ClockRight",
    "Fact",
    "IncidentBoard",
    "IncidentRule",
    "IncidentRuleFactory",
    "RobotHeard",
    "RobotSilent",
    "RobotStateChanged",
    "RuleSetup",
    "TaskStateChanged",
    "TopicHeard",
    "TopicSilent",
]


class RobotStateChanged(NamedTuple):
    """A robot's state changed.

    Attributes:
        time: when [s].
        robot: its id.
        before, after: its states.
        message: that says so; None where what an older one said has expired.
    """

    time: float
    robot: str
    before: RobotState
    after: RobotState
    message: Optional[Evidence] = None


class RobotSilent(NamedTuple):
    """A robot has been silent on all its topics for so long that it counts as lost.

    Attributes:
        time: when the silence fell due [s].
        robot: its id.
        last: the newest message of any of its topics.
    """

    time: float
    robot: str
    last: Evidence


class RobotHeard(NamedTuple):
    """A robot was heard for the first time, or again after it had been silent."""

    time: float
    robot: str
    message: Evidence


class TaskStateChanged(NamedTuple):
    """A task's state changed at a time [s]; one that comes up on the way is WAITING before and after."""

    time: float
    task: str
    before: TaskState
    after: TaskState


class AllocationStarted(NamedTuple):
    """A robot began with a task at a time [s]; the message says so."""

    time: float
    robot: str
    task: str
    message: Evidence


class AllocationEnded(NamedTuple):
    """A robot's time with a task ended.

    Attributes:
        time: when [s].
        robot, task: ids.
        started: when it had begun [s].
        outcome: how it ended.
        last: the newest message that had named this robot with this task.
    """

    time: float
    robot: str
    task: str
    started: float
    outcome: Outcome
    last: Evidence


class ClockOff(NamedTuple):
    """Everything that a robot says on a monitored topic is stamped far from when it was received.

    Told when it has lasted, again as it grows, and with the latest figure at the end of the stream.

    Attributes:
        time: when it was noticed [s].
        robot: its id.
        topic: as the architecture declares it.
        lead: header stamp minus receipt of its messages just now, by the middle one of three [s]; above 0 its clock is
            ahead of the receiver's; below 0 it is behind, or its messages take so long.
        tolerance: what is accepted of this topic, either way [s].
        first: the first of these messages.
        message: the newest of them.
    """

    time: float
    robot: str
    topic: str
    lead: float
    tolerance: float
    first: Evidence
    message: Evidence


class ClockRight(NamedTuple):
    """What a robot says on a monitored topic is stamped again as it is received; the message was the first such one."""

    time: float
    robot: str
    topic: str
    message: Evidence


class TopicSilent(NamedTuple):
    """A robot that has spoken regularly on a monitored topic says nothing there for longer than a message counts.

    Attributes:
        time: when that fell due [s].
        robot: its id.
        topic: as the architecture declares it.
        last: the newest message there, or the newest that said that the robot is busy, whichever came later.
        period: how long it used to be from message to message [s].
    """

    time: float
    robot: str
    topic: str
    last: Evidence
    period: float


class TopicHeard(NamedTuple):
    """A robot speaks again on a topic where it was silent, or says that it is busy."""

    time: float
    robot: str
    topic: str
    message: Evidence


Fact = Union[
    RobotStateChanged,
    RobotSilent,
    RobotHeard,
    TaskStateChanged,
    AllocationStarted,
    AllocationEnded,
    AllocationExpired,
    TaskApplicability,
    TaskClaimed,
    TaskEndTold,
    UnknownRobotNamed,
    UnknownTaskNamed,
    ClockOff,
    ClockRight,
    TopicSilent,
    TopicHeard,
]


class IncidentBoard(Protocol):
    """Where a rule puts up incidents; each rule has its own, so keys never meet another rule's."""

    def open(
        self,
        key: str,
        severity: Severity,
        start: float,
        text: str,
        *,
        robots: Sequence[str] = (),
        tasks: Sequence[str] = (),
        evidence: Sequence[Evidence] = (),
    ) -> None:
        """Put up an incident that still lasts; nothing happens if one with this key is open already.

        Args:
            key: names it among the rule's open incidents.
            severity: how much it matters.
            start: when it began [s]; may lie before now.
            text: one sentence that a tired engineer understands.
            robots: ids involved.
            tasks: ids involved.
            evidence: messages that show it.
        """
        ...

    def amend(self, key: str, text: str, evidence: Sequence[Evidence] = ()) -> None:
        """Say more of an open incident, for instance who took over; nothing happens if none has this key.

        Args:
            key: as given to ``open``.
            text: replaces the sentence.
            evidence: added to what was given.
        """
        ...

    def close(self, key: str, end: float, text: Optional[str] = None, evidence: Sequence[Evidence] = ()) -> None:
        """End an open incident; nothing happens if none has this key.

        Args:
            key: as given to ``open``.
            end: when it ended [s].
            text: replaces the sentence if given.
            evidence: added to what was given.
        """
        ...

    def wake_at(self, time: float) -> None:
        """Ask for a call of ``wake`` once the stream has come to a time [s]."""
        ...


@dataclass(frozen=True)
class RuleSetup:
    """What a rule is made from.

    Attributes:
        mission: as far as it is known.
        pace: how fast its architecture shares out tasks when all is well.
    """

    mission: Mission
    pace: AllocationPace = field(default_factory=lambda: AllocationPace(handover=3.0))


class IncidentRule(Protocol):
    """One kind of thing that can go wrong.

    Attributes:
        causes: what usually is behind it, in a sentence or two; told with each of its incidents. A rule that has no
            such attribute says nothing.
    """

    causes: str

    def subscriptions(self) -> Sequence[Subscription]:
        """Say which messages to hear besides the facts; usually none. Names must be absolute or patterns."""
        ...

    def hear(self, heard: Heard, board: IncidentBoard) -> None:
        """Take in a message subscribed to."""
        ...

    def notice(self, fact: Fact, board: IncidentBoard) -> None:
        """Take in a fact; facts come in the order in which the supervisor derives them."""
        ...

    def wake(self, time: float, board: IncidentBoard) -> None:
        """Look again at a time asked for by ``wake_at``, and once when the stream begins, before any fact [s]."""
        ...

    def finish(self, time: float, board: IncidentBoard) -> None:
        """Look a last time, when the stream has ended [s]; what is still open then ends there."""
        ...


IncidentRuleFactory = Callable[[RuleSetup], IncidentRule]
