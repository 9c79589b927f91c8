from __future__ import annotations

from rqt_mrta_py.model import Evidence, MonitoredTopic, Progress, Severity
from tests.supervisor.mini import COMMUNICATION, Stream, mission
from tests.supervisor.rules.ruled import incidents, spans, watched

RULE = "busy_without_task"


def says_busy(stream: Stream, start: float, end: float) -> None:
    """robot1 says every half second that it is busy, with no task."""
    stream.every(0.5, start, end, lambda time: stream.busy(time, "robot1", ""))


def test_robot_that_is_busy_with_nothing_is_found_until_it_is_busy_no_more() -> None:
    """It says so until 6.5 s, which counts until 8.5 s."""
    stream = watched(RULE)
    stream.tick(1.0)
    says_busy(stream, 2.0, 7.0)
    stream.tick(20.0)
    (incident,) = incidents(stream)
    assert (incident.severity, incident.start, incident.end) == (Severity.WARNING, 2.0, 8.5)
    assert (incident.robots, incident.tasks) == (("robot1",), ())
    assert incident.text == "robot1 has been busy since 1.0 s, but holds no task"
    assert incident.evidence == (Evidence(COMMUNICATION, 2.0, 0),)


def test_robot_that_goes_on_without_its_task_is_found_from_its_loss_on() -> None:
    stream = watched(RULE)
    stream.every(0.5, 1.0, 4.0, lambda time: stream.busy(time, "robot1", "patrol"))
    stream.sign(4.0, "robot1", "patrol", "gave_up")
    says_busy(stream, 4.0, 8.0)
    stream.busy(8.0, "robot1", "inspect")
    (incident,) = incidents(stream)
    assert (incident.start, incident.end) == (4.0, 8.0)
    # The last word on patrol was the seventh message.
    assert incident.evidence == (Evidence(COMMUNICATION, 3.5, 5),)


def test_robot_whose_task_has_ended_and_whose_last_word_still_counts_is_none() -> None:
    stream = watched(RULE)
    stream.every(0.5, 1.0, 4.0, lambda time: stream.busy(time, "robot1", "patrol"))
    stream.progress(4.0, "patrol", "robot1", Progress.DONE)
    stream.every(0.5, 4.0, 20.0, lambda time: stream.idle(time, "robot1"))
    assert incidents(stream) == ()


def test_robot_that_names_its_task_in_time_is_none() -> None:
    stream = watched(RULE)
    says_busy(stream, 1.0, 4.0)
    stream.every(0.5, 4.0, 9.0, lambda time: stream.busy(time, "robot1", "patrol"))
    assert incidents(stream) == ()


def test_robot_that_names_a_task_that_nobody_knows_is_told_by_another_rule() -> None:
    stream = watched(RULE)
    stream.every(0.5, 1.0, 9.0, lambda time: stream.busy(time, "robot1", "ghost"))
    assert incidents(stream) == ()


def test_robot_that_names_none_after_one_that_is_over_is_found_a_handover_later() -> None:
    stream = watched(RULE)
    stream.busy(1.0, "robot1", "patrol")
    stream.progress(1.5, "patrol", "robot1", Progress.DONE)
    stream.every(0.5, 2.0, 6.0, lambda time: stream.busy(time, "robot1", "patrol"))
    says_busy(stream, 6.0, 12.0)
    assert spans(stream) == ((5.5, 11.5),)


def test_architecture_that_does_not_say_who_holds_what_has_no_such_incident() -> None:
    busy = MonitoredTopic("/@robot_id@/busy", "std_msgs/Empty", timeout=2.0)
    stream = watched(RULE, mission(busy=(busy,), allocated=()))
    stream.every(0.5, 1.0, 20.0, lambda time: stream.say(time, "/robot1/busy"))
    assert incidents(stream) == ()
