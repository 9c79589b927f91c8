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


def test_robots_that_begin_at_one_moment_and_leave_are_one_try() -> None:
    """As equal robots under ALLIANCE, which reset each other: three begin at 1 s, all leave, one has it from 5 s on."""
    stream = watched(RULE)
    for robot in ("robot1", "robot2", "robot3"):
        stream.busy(1.0, robot, "patrol")
    for robot in ("robot1", "robot2", "robot3"):
        stream.sign(2.0, robot, "patrol", "preempted")
    stream.busy(5.0, "robot3", "patrol")
    stream.sign(6.0, "robot3", "patrol", "preempted")
    stream.busy(7.0, "robot1", "patrol")
    stream.tick(20.0)
    assert incidents(stream) == ()


def hand_over(stream: Stream, starts: Sequence[float], robots: Sequence[str]) -> None:
    """Let robots take patrol one after another, each 0.2 s before the one before yields."""
    stream.busy(starts[0], robots[0], "patrol")
    for start, robot, before in zip(starts[1:], robots[1:], robots):
        stream.busy(start - 1.0, before, "patrol")
        stream.busy(start, robot, "patrol")
        stream.sign(start + 0.2, before, "patrol", "yielded")


def test_robot_that_takes_a_task_before_the_other_leaves_it_counts_once_it_is_left_alone() -> None:
    """The fourth is alone with it at 7.2 s."""
    stream = watched(RULE)
    hand_over(stream, [1.0, 3.0, 5.0, 7.0], ["robot1", "robot2", "robot1", "robot2"])
    stream.progress(8.0, "patrol", "robot2", Progress.DONE)
    (incident,) = incidents(stream)
    assert (incident.start, incident.end, incident.robots) == (1.0, 8.0, ("robot1", "robot2"))
    assert [each.stamp for each in incident.evidence] == [1.0, 3.0, 5.0, 7.0]


def test_a_long_allocation_does_not_hide_the_brief_one_that_began_before_its_end() -> None:
    """robot1 has had it for 19 s when robot2 takes it, 0.2 s before robot1 yields."""
    stream = watched(RULE)
    stream.every(1.0, 1.0, 19.0, lambda time: stream.busy(time, "robot1", "patrol"))
    hand_over(stream, [19.0, 20.0, 22.0, 24.0, 26.0], ["robot1", "robot2", "robot1", "robot2", "robot1"])
    stream.progress(27.0, "patrol", "robot1", Progress.DONE)
    assert spans(stream) == ((20.0, 27.0),)
