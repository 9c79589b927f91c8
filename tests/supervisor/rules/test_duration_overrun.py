from __future__ import annotations

from dataclasses import replace

import pytest

from rqt_mrta_py.model import Progress, Severity
from tests.supervisor.rules.ruled import PACE, incidents, spans, watched, with_task

RULE = "duration_overrun"
PATROL_OF_5_S = with_task("patrol", expected_duration=5.0)


def test_robot_that_takes_twice_the_expected_duration_is_found_until_it_lets_go() -> None:
    stream = watched(RULE, PATROL_OF_5_S)
    stream.every(0.5, 1.0, 14.0, lambda time: stream.busy(time, "robot1", "patrol"))
    stream.progress(14.0, "patrol", "robot1", Progress.DONE)
    stream.tick(15.0)
    (incident,) = incidents(stream)
    assert (incident.severity, incident.start, incident.end) == (Severity.WARNING, 11.0, 14.0)
    assert (incident.robots, incident.tasks) == (("robot1",), ("patrol",))
    assert incident.text == "robot1 has held patrol since 0.0 s, for more than 10.0 s, though 5.0 s were expected"
    assert [each.stamp for each in incident.evidence] == [1.0, 13.5]


def test_task_that_is_done_just_in_time_is_none() -> None:
    stream = watched(RULE, PATROL_OF_5_S)
    stream.every(0.5, 1.0, 11.0, lambda time: stream.busy(time, "robot1", "patrol"))
    stream.progress(11.0, "patrol", "robot1", Progress.DONE)
    stream.tick(20.0)
    assert incidents(stream) == ()


def test_two_robots_one_after_the_other_are_none() -> None:
    stream = watched(RULE, PATROL_OF_5_S)
    stream.every(0.5, 1.0, 8.0, lambda time: stream.busy(time, "robot1", "patrol"))
    stream.sign(8.0, "robot1", "patrol", "gave_up")
    stream.every(0.5, 8.0, 16.0, lambda time: stream.busy(time, "robot2", "patrol"))
    assert incidents(stream) == ()


def test_what_a_robot_is_told_of_itself_goes_first() -> None:
    told = replace(PACE, overrun=1.0, durations={("robot1", "patrol"): 7.0})
    stream = watched(RULE, PATROL_OF_5_S, told)
    stream.every(0.5, 1.0, 12.0, lambda time: stream.busy(time, "robot1", "patrol"))
    assert spans(stream) == ((8.0, 11.5),)


@pytest.mark.parametrize("changes", [{"perpetual": True, "expected_duration": 5.0}, {}], ids=["perpetual", "unknown"])
def test_task_without_an_end_or_a_duration_is_none(changes: dict) -> None:  # type: ignore[type-arg]
    stream = watched(RULE, with_task("patrol", **changes))
    stream.every(0.5, 1.0, 60.0, lambda time: stream.busy(time, "robot1", "patrol"))
    assert incidents(stream) == ()


def test_robot_that_falls_silent_ends_it_when_its_word_expires() -> None:
    """It spoke last at 12.5 s, which counts for 2 s."""
    stream = watched(RULE, PATROL_OF_5_S)
    stream.every(0.5, 1.0, 13.0, lambda time: stream.busy(time, "robot1", "patrol"))
    stream.tick(30.0)
    assert spans(stream) == ((11.0, 14.5),)
