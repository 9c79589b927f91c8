from __future__ import annotations

import pytest

from rqt_mrta_py.model import Severity
from tests.supervisor.mini import Stream
from tests.supervisor.rules.ruled import incidents, spans, under, watched

RULE = "robot_with_two_tasks"


def interleaved(stream: Stream, start: float, end: float) -> None:
    """robot1 speaks of patrol from 1 s on, from ``start`` to ``end`` also of inspect [s]."""
    stream.every(0.5, 1.0, start, lambda time: stream.busy(time, "robot1", "patrol"))
    stream.every(
        0.5,
        start,
        end,
        lambda time: stream.busy(time, "robot1", "patrol"),
        lambda time: stream.busy(time, "robot1", "inspect"),
    )
    stream.sign(end, "robot1", "inspect", "gave_up")


def test_robot_that_holds_two_tasks_for_longer_than_a_handover_is_found() -> None:
    stream = watched(RULE)
    interleaved(stream, 5.0, 9.0)
    stream.busy(9.5, "robot1", "patrol")
    (incident,) = incidents(stream)
    assert (incident.severity, incident.start, incident.end) == (Severity.WARNING, 5.0, 9.0)
    assert (incident.robots, incident.tasks) == (("robot1",), ("inspect", "patrol"))
    assert incident.text == "robot1 has held inspect and patrol together since 4.0 s, but carries out one at a time"
    assert [each.stamp for each in incident.evidence] == [1.0, 5.0, 8.5]
    assert "Two nodes speak under one robot's id" in incident.causes


@pytest.mark.parametrize("end", [5.5, 8.0])
def test_short_overlap_is_none(end: float) -> None:
    stream = watched(RULE)
    interleaved(stream, 5.0, end)
    stream.tick(20.0)
    assert incidents(stream) == ()


def test_robot_that_changes_its_task_without_a_sign_is_none() -> None:
    stream = watched(RULE)
    stream.every(0.5, 1.0, 5.0, lambda time: stream.busy(time, "robot1", "patrol"))
    stream.every(0.5, 5.0, 20.0, lambda time: stream.busy(time, "robot1", "inspect"))
    assert incidents(stream) == ()


@pytest.mark.parametrize("taxonomy", ["MT-SR-IA", "-SR-IA"])
def test_architecture_of_robots_with_several_tasks_has_no_such_incident(taxonomy: str) -> None:
    stream = watched(RULE, under(taxonomy))
    interleaved(stream, 5.0, 20.0)
    assert incidents(stream) == ()


def test_robot_that_does_so_again_is_found_again() -> None:
    stream = watched(RULE)
    interleaved(stream, 5.0, 9.0)
    stream.every(0.5, 9.5, 12.0, lambda time: stream.busy(time, "robot1", "patrol"))
    stream.every(
        0.5,
        12.0,
        16.0,
        lambda time: stream.busy(time, "robot1", "patrol"),
        lambda time: stream.busy(time, "robot1", "report"),
    )
    assert spans(stream) == ((5.0, 9.0), (12.0, 15.5))
