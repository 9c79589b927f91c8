"""The supervisor's own messages: what changed, and the whole team at one moment."""

from __future__ import annotations

from typing import Any, Dict, List, Mapping, Optional, Sequence, Tuple

from rqt_mrta_py.hooks import AllocationEnded, AllocationStarted, Fact, Outgoing, RobotStateChanged, TaskStateChanged
from rqt_mrta_py.model import (
    Allocation,
    Event,
    Incident,
    MissionRecord,
    Outcome,
    RobotState,
    Severity,
    TaskState,
)
from rqt_mrta_py.supervisor.own_topics import ALLOCATION, EVENT, INCIDENT, ROBOT_STATE, TASK_STATE, TEAM_STATE

__all__ = ["ROBOT_CODES", "TASK_CODES", "event_news", "fact_news", "incident_news", "team_news"]

ROBOT_CODES = {RobotState.OFFLINE: 0, RobotState.IDLE: 1, RobotState.BUSY: 2}
TASK_CODES = {state: code for code, state in enumerate(TaskState)}
_OUTCOME_CODES = {
    Outcome.OPEN: 0,
    Outcome.DONE: 1,
    Outcome.FAILED: 2,
    Outcome.YIELDED: 3,
    Outcome.GAVE_UP: 4,
    Outcome.LOST: 5,
    Outcome.PREEMPTED: 6,
}

# Lines for /rosout as the history of rqt_mrta has them: its numbers for type, severity and state.
_HISTORY_TYPES = {"robot_state": 0, "task_state": 1, "allocation_started": 2, "allocation_ended": 2}
_HISTORY_SEVERITIES = {Severity.INFO: 1, Severity.WARNING: 2, Severity.ERROR: 3}
_HISTORY_ROBOTS = {RobotState.IDLE.value: 0, RobotState.BUSY.value: 1, RobotState.OFFLINE.value: 2}
_HISTORY_TASKS = {state.value: code for state, code in TASK_CODES.items()}
_ON_HOLD, _ASSIGNED, _DONE = 0, 1, 2
_LOG_LEVELS = {Severity.INFO: 2, Severity.WARNING: 4, Severity.ERROR: 8}
_NODE = "/supervisor"


def fact_news(fact: Fact, last_heard: Optional[float], holders: Sequence[str]) -> Tuple[Outgoing, ...]:
    """Tell what a fact changed.

    Args:
        fact: what was derived.
        last_heard: of the robot that it speaks of [s]; None if it speaks of none, or one never heard.
        holders: ids of the robots that hold the task that it speaks of, sorted.

    Returns:
        The message to publish; none for facts that change neither state nor allocation.
    """
    if isinstance(fact, RobotStateChanged):
        fields = _robot_fields(fact.robot, fact.after, fact.time, last_heard)
        return (ROBOT_STATE.message(fields),)
    if isinstance(fact, TaskStateChanged):
        fields = _task_fields(fact.task, fact.after, fact.time, holders)
        return (TASK_STATE.message(fields),)
    if isinstance(fact, AllocationStarted):
        fields = _allocation_fields(Allocation(fact.task, fact.robot, fact.time, 0.0, Outcome.OPEN), fact.time)
    elif isinstance(fact, AllocationEnded):
        ended = Allocation(fact.task, fact.robot, fact.started, fact.time, fact.outcome)
        fields = _allocation_fields(ended, fact.time)
    else:
        return ()
    return (ALLOCATION.message(fields),)


def event_news(event: Event, started: float) -> Tuple[Outgoing, ...]:
    """Tell an event, on /mrta/event and as a line of the history on /rosout.

    Args:
        event: what was noticed.
        started: when the allocation that it speaks of had begun [s]; its own time if it speaks of none.
    """
    fields = {
        "header": {"stamp": event.time},
        "kind": event.kind,
        "severity": event.severity.rank,
        "robot_id": event.robot or "",
        "task_id": event.task or "",
        "state": event.state or "",
        "text": event.text,
    }
    log = {
        "header": {"stamp": event.time},
        "level": _LOG_LEVELS[event.severity],
        "name": _NODE,
        "msg": _history_line(event, started),
    }
    return (EVENT.message(fields), Outgoing("/rosout", "rosgraph_msgs/Log", log))


def incident_news(incident: Incident, noticed: float, ended: bool) -> Tuple[Outgoing, ...]:
    """Tell that an incident began or ended.

    Args:
        incident: as it stands.
        noticed: when [s].
        ended: whether it is over.
    """
    fields = {
        "header": {"stamp": noticed},
        "rule": incident.rule,
        "severity": incident.severity.rank,
        "start": incident.start,
        "end": incident.end if ended else 0.0,
        "robots": list(incident.robots),
        "tasks": list(incident.tasks),
        "text": incident.text,
        "evidence_topics": [each.topic for each in incident.evidence],
        "evidence_stamps": [each.stamp for each in incident.evidence],
        "evidence_indices": [each.index for each in incident.evidence],
        "causes": incident.causes,
    }
    return (INCIDENT.message(fields),)


def team_news(record: MissionRecord, now: float) -> Outgoing:
    """Tell the whole team at one moment.

    Args:
        record: the mission up to then.
        now: the moment [s].
    """
    open_ones = [each for each in record.allocations if each.outcome is Outcome.OPEN]
    holders: Dict[str, List[str]] = {}
    for allocation in open_ones:
        holders.setdefault(allocation.task, []).append(allocation.robot)
    robots = [
        _robot_fields(robot.id, robot.state, robot.states[-1].start, robot.last_heard)
        for robot in record.robots
        if robot.states
    ]
    tasks = [
        _task_fields(task.id, task.state, task.history[-1].start, sorted(holders.get(task.id, ())))
        for task in record.tasks
        if task.history
    ]
    fields = {
        "header": {"stamp": now},
        "robots": robots,
        "tasks": tasks,
        "allocations": [_allocation_fields(each, each.start) for each in open_ones],
    }
    return TEAM_STATE.message(fields)


def _robot_fields(robot: str, state: RobotState, since: float, last_heard: Optional[float]) -> Mapping[str, Any]:
    heard = 0.0 if last_heard is None else last_heard
    return {"header": {"stamp": since}, "robot_id": robot, "state": ROBOT_CODES[state], "last_heard": heard}


def _task_fields(task: str, state: TaskState, since: float, holders: Sequence[str]) -> Mapping[str, Any]:
    return {"header": {"stamp": since}, "task_id": task, "state": TASK_CODES[state], "robots": list(holders)}


def _allocation_fields(allocation: Allocation, stamp: float) -> Mapping[str, Any]:
    return {
        "header": {"stamp": stamp},
        "task_id": allocation.task,
        "robot_id": allocation.robot,
        "start": allocation.start,
        "end": 0.0 if allocation.outcome is Outcome.OPEN else allocation.end,
        "outcome": _OUTCOME_CODES[allocation.outcome],
    }


def _history_line(event: Event, started: float) -> str:
    if event.kind not in _HISTORY_TYPES:
        return event.text
    kind, state = _HISTORY_TYPES[event.kind], event.state or ""
    if event.kind == "robot_state":
        name, code = event.robot or "", _HISTORY_ROBOTS[state]
    elif event.kind == "task_state":
        name, code = event.task or "", _HISTORY_TASKS[state]
    else:
        name = f"{event.task}-{_seconds(started)}"
        code = {Outcome.OPEN.value: _ASSIGNED, Outcome.DONE.value: _DONE}.get(state, _ON_HOLD)
    severity = _HISTORY_SEVERITIES[event.severity]
    return f"[{_seconds(event.time)}] [{kind}] [{severity}] id: {name}, state: {code}"


def _seconds(time: float) -> str:
    return repr(round(float(time), 9))
