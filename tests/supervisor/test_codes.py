"""The numbers in the supervisor's messages are those that their definitions name."""

from __future__ import annotations

from pathlib import Path
from typing import Callable, Dict

import pytest

from rqt_mrta_py.hooks import AllocationEnded, AllocationStarted, RobotStateChanged, TaskStateChanged
from rqt_mrta_py.model import Event, Evidence, Incident, Outcome, Progress, RobotState, Severity, TaskState
from rqt_mrta_py.supervisor.news import event_news, fact_news, incident_news
from rqt_mrta_py.transport.codec.definitions import parse_message
from tests.supervisor.mini import Stream, allocations, history, of_kind

LAST = Evidence("/t", 1.0, 0)


def code_of_robot(state: RobotState) -> int:
    return fact_news(RobotStateChanged(2.0, "r", state, state), None, ())[0].fields["state"]


def code_of_task(state: TaskState) -> int:
    return fact_news(TaskStateChanged(2.0, "t", state, state), None, ())[0].fields["state"]


def code_of_outcome(outcome: Outcome) -> int:
    started = AllocationStarted(2.0, "r", "t", LAST)
    ended = AllocationEnded(2.0, "r", "t", 1.0, outcome, LAST)
    return fact_news(started if outcome is Outcome.OPEN else ended, None, ())[0].fields["outcome"]


def code_of_event(severity: Severity) -> int:
    return event_news(Event(1.0, "unreadable", severity, "x"), 1.0)[0].fields["severity"]


def code_of_incident(severity: Severity) -> int:
    return incident_news(Incident("x", severity, 1.0, 2.0, (), (), "x"), 1.0, True)[0].fields["severity"]


def constants(root: Path, name: str) -> Dict[str, int]:
    spec = parse_message(f"rqt_mrta_py/{name}", (root / "msg" / f"{name}.msg").read_text(encoding="utf-8"))
    return {constant.name.lower(): int(constant.text) for constant in spec.constants}


@pytest.mark.parametrize(
    ("message", "kind", "code"),
    [
        ("RobotState", RobotState, code_of_robot),
        ("TaskState", TaskState, code_of_task),
        ("Allocation", Outcome, code_of_outcome),
        ("Event", Severity, code_of_event),
        ("Incident", Severity, code_of_incident),
    ],
)
def test_codes_are_those_of_the_definition(root: Path, message: str, kind: type, code: Callable[..., int]) -> None:
    assert {member.value: code(member) for member in kind} == constants(root, message)


@pytest.mark.parametrize(
    ("word", "state", "outcome"),
    [
        ("running", "executing", "open"),
        ("done", "done", "done"),
        ("failed", "failed", "failed"),
        ("unreachable", "waiting", "failed"),
        ("withdrawn", "withdrawn", "preempted"),
    ],
)
def test_progress_is_read_by_the_numbers_of_its_definition(root: Path, word: str, state: str, outcome: str) -> None:
    codes = constants(root, "TaskProgress")
    assert set(codes) == {progress.value for progress in Progress}
    stream = Stream()
    stream.busy(1.0, "robot1", "patrol")
    fields = {"task_id": "patrol", "robot_id": "robot1", "detail": ""}
    stream.say(2.0, "/mrta/task_progress", "rqt_mrta_py/TaskProgress", progress=codes[word], **fields)
    stream.busy(2.5, "robot2", "inspect")
    record = stream.finish()
    assert history(record, "patrol")[-1][0] == state
    assert allocations(record)[0][-1] == outcome
    assert not of_kind(stream.events, "unreadable")
