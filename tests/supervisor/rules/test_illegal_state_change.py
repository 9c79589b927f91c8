from __future__ import annotations

from typing import Optional

from rqt_mrta_py.model import Evidence, Mission, MonitoredTopic, Progress, Severity
from tests.supervisor.mini import COMMUNICATION, Stream, mission
from tests.supervisor.rules.ruled import incidents, spans, watched

RULE = "illegal_state_change"


def done_at_2(of: Optional[Mission] = None) -> Stream:
    """robot1 holds patrol from 1 s on and has done it at 2 s."""
    stream = watched(RULE, of)
    stream.busy(1.0, "robot1", "patrol")
    stream.progress(2.0, "patrol", "robot1", Progress.DONE)
    return stream


def test_robot_that_goes_on_with_a_task_that_is_done_is_found_while_it_says_so() -> None:
    """Its words count as late until 5 s; the first after that is at 5.5 s."""
    stream = done_at_2()
    stream.every(0.5, 2.0, 9.0, lambda time: stream.busy(time, "robot2", "patrol"))
    stream.tick(30.0)
    (incident,) = incidents(stream)
    assert (incident.severity, incident.start, incident.end) == (Severity.ERROR, 5.5, 8.5)
    assert (incident.robots, incident.tasks) == (("robot2",), ("patrol",))
    assert incident.text == "patrol was done at 1.0 s, but at 4.5 s robot2 held it still"
    assert incident.evidence == (Evidence(COMMUNICATION, 5.5, 8), Evidence(COMMUNICATION, 8.5, 14))


def test_words_that_were_under_way_are_none() -> None:
    stream = done_at_2()
    stream.every(0.5, 2.0, 5.5, lambda time: stream.busy(time, "robot1", "patrol"))
    stream.progress(5.0, "patrol", "robot1", Progress.FAILED)
    stream.tick(30.0)
    assert incidents(stream) == ()


def test_end_that_is_told_otherwise_later_is_found() -> None:
    stream = done_at_2()
    stream.progress(9.0, "patrol", "robot2", Progress.FAILED)
    stream.tick(30.0)
    (incident,) = incidents(stream)
    assert (incident.start, incident.end, incident.robots) == (9.0, 9.0, ("robot2",))
    assert incident.text == "patrol was done at 1.0 s, but at 8.0 s it was said to be failed by robot2"
    assert incident.evidence == (Evidence("/mrta/task_progress", 9.0, 1),)


def test_end_that_is_told_again_is_none() -> None:
    stream = done_at_2()
    stream.progress(9.0, "patrol", "robot1", Progress.DONE)
    stream.progress(10.0, "patrol", "", Progress.DONE)
    assert incidents(stream) == ()


def test_task_that_appears_anew_ends_it_and_is_free_again() -> None:
    stream = done_at_2(mission(incoming=(MonitoredTopic("/tasks", "std_msgs/String", "data"),)))
    stream.busy(6.0, "robot2", "patrol")
    stream.say(7.0, "/tasks", data="patrol")
    stream.every(0.5, 8.0, 12.0, lambda time: stream.busy(time, "robot2", "patrol"))
    assert spans(stream) == ((6.0, 6.0),)


def test_robots_are_told_apart() -> None:
    stream = done_at_2()
    for time in (6.0, 7.0, 8.0):
        stream.busy(time, "robot1", "patrol")
        stream.busy(time, "robot2", "patrol")
    assert [each.robots for each in incidents(stream)] == [("robot1",), ("robot2",)]


def test_task_that_is_done_without_having_been_held_is_none() -> None:
    stream = watched(RULE)
    stream.progress(2.0, "patrol", "robot1", Progress.DONE)
    assert incidents(stream) == ()
