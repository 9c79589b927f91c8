from __future__ import annotations

from typing import Sequence

import pytest

from rqt_mrta_py.model import Progress, Severity
from tests.supervisor.mini import Stream
from tests.supervisor.rules.ruled import incidents, spans, watched

RULE = "flipping_allocation"


def turns(stream: Stream, starts: Sequence[float], robots: Sequence[str], outcome: str = "yielded") -> None:
    """Let robots take patrol one after another, each for as long as until the next one begins."""
    for start, end, robot in zip(starts, starts[1:], robots):
        stream.busy(start, robot, "patrol")
        stream.sign(end, robot, "patrol", outcome)


def test_task_that_is_taken_four_times_in_a_row_is_found_from_the_first_to_the_last_time() -> None:
    stream = watched(RULE)
    turns(stream, [1.0, 3.0, 5.0, 7.0, 9.0], ["robot1", "robot2", "robot1", "robot2"])
    stream.tick(20.0)
    (incident,) = incidents(stream)
    assert (incident.severity, incident.start, incident.end) == (Severity.WARNING, 1.0, 9.0)
    assert (incident.robots, incident.tasks) == (("robot1", "robot2"), ("patrol",))
    assert incident.text == "robot1 and robot2 took and let go patrol 3 times within 6.0 s"
    assert [each.stamp for each in incident.evidence] == [1.0, 3.0, 5.0, 7.0]


def test_three_times_are_none() -> None:
    stream = watched(RULE)
    turns(stream, [1.0, 3.0, 5.0, 7.0], ["robot1", "robot2", "robot1"])
    stream.tick(20.0)
    assert incidents(stream) == ()


def test_robot_that_takes_and_drops_a_task_is_found_too() -> None:
    stream = watched(RULE)
    for start in (1.0, 4.0, 7.0, 10.0):
        stream.busy(start, "robot1", "patrol")
        stream.sign(start + 1.0, "robot1", "patrol", "gave_up")
    (incident,) = incidents(stream)
    assert (incident.robots, incident.start, incident.end) == (("robot1",), 1.0, 11.0)
    assert incident.text == "robot1 took and let go patrol 3 times within 7.0 s"


def test_turns_of_five_seconds_are_none() -> None:
    stream = watched(RULE)
    for start, robot in ((1.0, "robot1"), (6.0, "robot2"), (11.0, "robot1"), (16.0, "robot2")):
        stream.every(1.0, start, start + 5.0, lambda time, robot=robot: stream.busy(time, robot, "patrol"))  # type: ignore[misc]
        stream.sign(start + 5.0, robot, "patrol", "yielded")
    assert incidents(stream) == ()


def test_turns_with_long_pauses_are_none() -> None:
    stream = watched(RULE)
    for start in (1.0, 8.0, 15.0, 22.0):
        stream.busy(start, "robot1", "patrol")
        stream.sign(start + 1.0, "robot1", "patrol", "gave_up")
    stream.tick(40.0)
    assert incidents(stream) == ()


@pytest.mark.parametrize("outcome", ["failed", "lost"])
def test_robots_that_fail_are_none(outcome: str) -> None:
    stream = watched(RULE)
    turns(stream, [1.0, 3.0, 5.0, 7.0, 9.0], ["robot1", "robot2", "robot1", "robot2"], outcome)
    assert incidents(stream) == ()


def test_it_ends_where_a_robot_began_that_keeps_the_task() -> None:
    stream = watched(RULE)
    turns(stream, [1.0, 3.0, 5.0, 7.0], ["robot1", "robot2", "robot1"])
    stream.every(1.0, 7.0, 20.0, lambda time: stream.busy(time, "robot2", "patrol"))
    assert spans(stream) == ((1.0, 7.0),)


def test_it_ends_with_the_task() -> None:
    stream = watched(RULE)
    turns(stream, [1.0, 3.0, 5.0, 7.0], ["robot1", "robot2", "robot1"])
    stream.busy(7.0, "robot2", "patrol")
    stream.progress(8.0, "patrol", "robot2", Progress.DONE)
    stream.tick(20.0)
    assert spans(stream) == ((1.0, 8.0),)


def test_two_tasks_are_counted_apart() -> None:
    stream = watched(RULE)
    for start, task in ((1.0, "patrol"), (2.0, "inspect"), (3.0, "patrol"), (4.0, "inspect"), (5.0, "report")):
        stream.busy(start, "robot1", task)
        stream.sign(start + 0.5, "robot1", task, "gave_up")
    assert incidents(stream) == ()
