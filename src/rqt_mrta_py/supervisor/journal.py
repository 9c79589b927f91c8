"""The journal: what happened, in sentences."""

from __future__ import annotations

from typing import Optional

from rqt_mrta_py.hooks import AllocationEnded, AllocationStarted, Fact, Heard, RobotStateChanged, TaskStateChanged
from rqt_mrta_py.model import Event, Incident, Outcome, RobotState, Severity, TaskState

__all__ = ["event_of_fact", "event_of_incident", "event_of_unreadable", "reason_of_end"]

_ENDED = {
    Outcome.DONE: "{robot} has done {task}",
    Outcome.FAILED: "{robot} has failed at {task}",
    Outcome.YIELDED: "{robot} has yielded {task}",
    Outcome.GAVE_UP: "{robot} has given up {task}",
    Outcome.LOST: "{robot} fell silent and lost {task}",
    Outcome.PREEMPTED: "{task} was taken from {robot}",
}


def event_of_fact(fact: Fact, why: str = "") -> Optional[Event]:
    """Write down a fact.

    Args:
        fact: what was derived.
        why: in a few words; empty if nobody said.

    Returns:
        Its event; None for what the journal leaves to others, that is whether a robot is heard.
    """
    because = f": {why}" if why else ""
    if isinstance(fact, RobotStateChanged):
        severity = Severity.WARNING if fact.after is RobotState.OFFLINE else Severity.INFO
        text = f"{fact.robot} is {fact.after.value}{because}"
        return Event(fact.time, "robot_state", severity, text, robot=fact.robot, state=fact.after.value)
    if isinstance(fact, TaskStateChanged):
        severity = Severity.WARNING if fact.after is TaskState.FAILED else Severity.INFO
        verb = "has come up and is" if fact.before is fact.after else "is"
        text = f"{fact.task} {verb} {fact.after.value}{because}"
        return Event(fact.time, "task_state", severity, text, task=fact.task, state=fact.after.value)
    if isinstance(fact, AllocationStarted):
        text = f"{fact.robot} has taken {fact.task}{because}"
        state = Outcome.OPEN.value
        return Event(fact.time, "allocation_started", Severity.INFO, text, fact.robot, fact.task, state)
    if isinstance(fact, AllocationEnded):
        severity = Severity.WARNING if fact.outcome in (Outcome.FAILED, Outcome.LOST) else Severity.INFO
        text = _ended(fact.robot, fact.task, fact.outcome) + because
        return Event(fact.time, "allocation_ended", severity, text, fact.robot, fact.task, fact.outcome.value)
    return None


def event_of_incident(incident: Incident, time: float) -> Event:
    """Write down that a rule has found something at a time [s]; names robot and task where there is just one."""
    return Event(
        time,
        "incident",
        incident.severity,
        incident.text,
        robot=incident.robots[0] if len(incident.robots) == 1 else None,
        task=incident.tasks[0] if len(incident.tasks) == 1 else None,
        state=incident.rule,
        causes=incident.causes or None,
    )


def event_of_unreadable(heard: Heard, reason: str, time: float) -> Event:
    """Write down at a time [s] that messages cannot be read, and why."""
    return Event(time, "unreadable", Severity.WARNING, f"{heard.topic} ({heard.type}) cannot be read: {reason}")


def reason_of_end(event: Event) -> str:
    """Read from the event of an allocation that ended why it did; empty if nobody said."""
    _, _, why = event.text.partition(f"{_ended(event.robot, event.task, Outcome(event.state))}: ")
    return why


def _ended(robot: Optional[str], task: Optional[str], outcome: Outcome) -> str:
    return _ENDED[outcome].format(robot=robot, task=task)
