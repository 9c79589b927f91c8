"""Gaps in topics; times by hand. A motivation counts for 2 s, and a robot is silent after 2 s."""

from __future__ import annotations

from typing import Tuple

from rqt_mrta_py.model import Evidence, Incident, Severity
from rqt_mrta_py.supervisor.rules import RobotSilentWithTask, TopicGap
from tests.supervisor.mini import IDLE, Stream

MOTIVATION = "/robot1/alliance/motivation/patrol"


def watched() -> Stream:
    return Stream(rules={"topic_gap": TopicGap, "robot_silent_with_task": RobotSilentWithTask})


def found(stream: Stream) -> Tuple[Incident, ...]:
    return stream.finish().incidents


def speaks(stream: Stream, start: float, end: float) -> None:
    stream.every(0.5, start, end, lambda time: stream.idle(time, "robot1"))


def test_a_topic_that_falls_silent_is_a_warning_until_it_is_heard_again() -> None:
    stream = watched()
    speaks(stream, 1.0, 10.0)
    stream.every(0.5, 10.0, 30.0, lambda time: stream.odom(time, "robot1"))
    speaks(stream, 30.0, 40.0)
    (incident,) = found(stream)
    assert (incident.rule, incident.severity, incident.robots) == ("topic_gap", Severity.WARNING, ("robot1",))
    assert (incident.start, incident.end) == (9.5, 30.0)
    assert incident.text == (
        f"robot1 fell silent on {IDLE.name} at 8.5 s, though it is heard on others; it used to be heard every 0.5 s; "
        "heard again at 29.0 s"
    )
    assert incident.evidence == (Evidence(MOTIVATION, 9.5, 17), Evidence(MOTIVATION, 30.0, 18))


def test_a_robot_that_is_silent_on_all_its_topics_without_a_task_is_told_of_here() -> None:
    stream = watched()
    speaks(stream, 1.0, 10.0)
    stream.tick(30.0)
    (incident,) = found(stream)
    assert (incident.start, incident.end) == (9.5, 30.0)
    assert incident.text == "robot1 fell silent on all its topics at 8.5 s; it used to be heard every 0.5 s"


def test_a_robot_that_is_lost_with_its_task_is_told_of_once() -> None:
    stream = watched()
    speaks(stream, 1.0, 10.0)
    stream.every(0.5, 9.5, 12.0, lambda time: stream.busy(time, "robot1", "patrol"))
    stream.tick(30.0)
    assert [each.rule for each in found(stream)] == ["robot_silent_with_task"]


def test_a_robot_that_is_lost_with_its_task_and_soon_back_is_told_of_once() -> None:
    stream = watched()

    def speak(time: float) -> None:
        stream.idle(time, "robot1")
        stream.busy(time, "robot1", "patrol")

    stream.every(0.5, 1.0, 10.0, speak)
    stream.every(0.5, 12.5, 20.0, speak)
    assert [each.rule for each in found(stream)] == ["robot_silent_with_task"]


def test_a_gap_too_short_to_know_more_is_told_of_when_it_ends() -> None:
    stream = watched()
    speaks(stream, 1.0, 10.0)
    stream.odom(11.0, "robot1")
    speaks(stream, 12.5, 20.0)
    (incident,) = found(stream)
    assert (incident.start, incident.end) == (9.5, 12.5)


def test_nodes_that_are_shut_down_one_after_the_other_are_no_gaps() -> None:
    stream = watched()
    speaks(stream, 1.0, 10.0)
    stream.tick(13.0)
    assert found(stream) == ()


def test_a_robot_that_never_spoke_regularly_is_not_missed() -> None:
    stream = watched()
    speaks(stream, 1.0, 3.0)
    stream.tick(30.0)
    assert found(stream) == ()


def test_two_gaps_are_two_incidents() -> None:
    stream = watched()
    for start in (1.0, 31.0, 61.0):
        speaks(stream, start, start + 10.0)
    assert [(each.start, each.end) for each in found(stream)] == [(10.5, 31.0), (40.5, 61.0)]


def test_causes_are_told() -> None:
    assert TopicGap.causes.startswith("The node hangs")
