from __future__ import annotations

from dataclasses import replace

import pytest

from rqt_mrta_py.model import Evidence, Severity
from tests.supervisor.mini import COMMUNICATION, Stream, mission
from tests.supervisor.rules.ruled import PACE, incidents, spans, under, watched, with_task

RULE = "task_held_by_two_robots"


def both_hold(stream: Stream, start: float, end: float, first: float = 1.0) -> None:
    """robot1 is on patrol from ``first``, robot2 as well from ``start``; both let go at ``end`` [s]."""
    stream.every(0.5, first, start, lambda time: stream.busy(time, "robot1", "patrol"))
    stream.every(
        0.5,
        start,
        end,
        lambda time: stream.busy(time, "robot1", "patrol"),
        lambda time: stream.busy(time, "robot2", "patrol"),
    )
    stream.sign(end, "robot1", "patrol", "yielded")


def test_two_robots_on_one_task_for_longer_than_a_handover_are_found_from_the_second_on() -> None:
    stream = watched(RULE)
    both_hold(stream, 5.0, 9.0)
    stream.tick(9.5)
    (incident,) = incidents(stream)
    assert (incident.rule, incident.severity, incident.start, incident.end) == (RULE, Severity.WARNING, 5.0, 9.0)
    assert (incident.robots, incident.tasks) == (("robot1", "robot2"), ("patrol",))
    assert incident.text == "robot1 and robot2 have both held patrol since 4.0 s"
    # robot1 spoke alone from 1.0 to 4.5 s (0 to 7); from 5.0 s on in turn with robot2: its last at 8.5 s is 8 + 2 * 7.
    assert incident.evidence == (
        Evidence(COMMUNICATION, 1.0, 0),
        Evidence(COMMUNICATION, 5.0, 9),
        Evidence(COMMUNICATION, 8.5, 22),
    )
    assert "do not hear each other" in incident.causes


@pytest.mark.parametrize(("end", "found"), [(8.0, False), (8.5, True)], ids=["just in time", "too late"])
def test_overlap_counts_when_it_lasts_longer_than_the_handover(end: float, found: bool) -> None:
    stream = watched(RULE)
    both_hold(stream, 5.0, end)
    stream.tick(20.0)
    assert bool(incidents(stream)) is found


def test_overlap_that_the_stream_ends_in_exactly_when_it_is_due_is_found() -> None:
    stream = watched(RULE)
    stream.every(0.5, 1.0, 5.0, lambda time: stream.busy(time, "robot1", "patrol"))
    for time in (5.0, 6.0, 7.0, 8.0):
        stream.busy(time, "robot1", "patrol")
        stream.busy(time, "robot2", "patrol")
    assert spans(stream) == ((5.0, 8.0),)


def test_task_that_is_taken_over_while_the_last_announcement_still_counts_is_none() -> None:
    stream = watched(RULE)
    stream.every(0.5, 1.0, 5.0, lambda time: stream.busy(time, "robot1", "patrol"))
    stream.every(0.5, 5.0, 20.0, lambda time: stream.busy(time, "robot2", "patrol"))
    assert incidents(stream) == ()


def test_robot_may_first_hold_its_task_for_the_yielding_delay() -> None:
    """robot1 began at 1 s and yields after 10 s: until 1 + 10 + 3 s both may hold the task."""
    patient = replace(PACE, yielding=10.0)
    stream = watched(RULE, pace=patient)
    both_hold(stream, 5.0, 13.5)
    stream.tick(14.5)
    assert incidents(stream) == ()
    stream = watched(RULE, pace=patient)
    both_hold(stream, 5.0, 15.0)
    assert spans(stream) == ((5.0, 15.0),)


@pytest.mark.parametrize("taxonomy", ["ST-MR-IA", "ST--IA"])
def test_architecture_for_tasks_of_several_robots_has_no_such_incident(taxonomy: str) -> None:
    stream = watched(RULE, under(taxonomy))
    both_hold(stream, 5.0, 20.0)
    assert incidents(stream) == ()


def test_task_that_needs_two_robots_is_none() -> None:
    stream = watched(RULE, with_task("patrol", mission(), robots=2))
    both_hold(stream, 5.0, 20.0)
    assert incidents(stream) == ()


def test_third_robot_makes_no_second_incident() -> None:
    stream = watched(RULE, mission(robots=("robot1", "robot2", "robot3")))
    robots = ("robot1", "robot2", "robot3")
    calls = [lambda time, robot=robot: stream.busy(time, robot, "patrol") for robot in robots]
    stream.every(0.5, 1.0, 9.0, *calls)
    (incident,) = incidents(stream)
    assert (incident.start, incident.robots) == (1.0, robots)
