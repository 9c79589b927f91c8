"""Messages from the future and from the past; times by hand."""

from __future__ import annotations

from typing import Dict, Tuple

from rqt_mrta_py.hooks import IncidentRuleFactory
from rqt_mrta_py.model import Evidence, Incident, MonitoredTopic, Severity
from rqt_mrta_py.supervisor.clocks.words import span_text
from rqt_mrta_py.supervisor.rules import MessageFromTheFuture, MessageFromThePast
from tests.supervisor.mini import BUSY, COMMUNICATION, Stream, mission

RULES: Dict[str, IncidentRuleFactory] = {
    "message_from_the_future": MessageFromTheFuture,
    "message_from_the_past": MessageFromThePast,
}
REPORT = MonitoredTopic("/reports", "x/Report", "task", robot_field="robot", timeout=1.0)


def watched() -> Stream:
    return Stream(mission(completed=[REPORT]), rules=RULES)


def found(stream: Stream) -> Tuple[Incident, ...]:
    return stream.finish().incidents


def busy_off(stream: Stream, lead: float, start: float, end: float, robot: str = "robot1") -> None:
    """A robot says every half second what it does, by a clock that is off [s]."""
    stream.every(0.5, start, end, lambda time: stream.busy(time, robot, "patrol", stamp=time + lead))


def test_a_robot_five_seconds_ahead_is_named_once_until_its_clock_is_right() -> None:
    stream = watched()
    busy_off(stream, 0.0, 1.0, 10.0)
    busy_off(stream, 5.0, 10.0, 20.0)
    busy_off(stream, 0.0, 20.0, 30.0)
    (incident,) = found(stream)
    assert (incident.rule, incident.severity) == ("message_from_the_future", Severity.WARNING)
    assert (incident.start, incident.end, incident.robots, incident.tasks) == (10.0, 20.0, ("robot1",), ())
    assert incident.text == (
        f"robot1's clock is ahead: what it says on {COMMUNICATION} is stamped up to 5.0 s after it was received"
    )
    # The first message, the third one, with which it was certain, and the first one that was right again.
    assert incident.evidence == (
        Evidence(COMMUNICATION, 10.0, 18),
        Evidence(COMMUNICATION, 11.0, 20),
        Evidence(COMMUNICATION, 20.0, 38),
    )


def test_a_robot_behind_is_told_to_be_behind_or_slow() -> None:
    stream = watched()
    busy_off(stream, -5.0, 10.0, 20.0)
    (incident,) = found(stream)
    assert incident.rule == "message_from_the_past"
    assert (incident.start, incident.end) == (10.0, 19.5)
    assert incident.text == (
        f"what robot1 says on {COMMUNICATION} is up to 5.0 s old when it is received: its clock is behind, or its "
        "messages are under way for so long"
    )


def test_a_clock_that_is_slewed_tells_how_far_it_came() -> None:
    stream = watched()
    stream.every(0.5, 10.0, 20.0, lambda time: stream.busy(time, "robot1", "patrol", stamp=time - (time - 10.0) / 2))
    (incident,) = found(stream)
    # The last three lie 4.25, 4.5 and 4.75 s back.
    assert "up to 4.5 s old" in incident.text
    assert incident.start == 12.5


def test_two_topics_of_a_robot_are_one_incident() -> None:
    stream = watched()

    def speak(time: float) -> None:
        stream.busy(time, "robot1", "patrol", stamp=time + 2.0)
        stream.say(time, "/reports", robot="robot1", task="inspect", header__stamp=time + 3.0)

    stream.every(0.5, 10.0, 20.0, speak)
    busy_off(stream, 0.0, 20.0, 25.0)
    (incident,) = found(stream)
    # What was not said again is not known to be right again.
    assert (incident.start, incident.end) == (10.0, 24.5)
    assert f"on {COMMUNICATION} and /reports is stamped up to 3.0 s" in incident.text


def test_two_robots_are_two_incidents() -> None:
    stream = watched()

    def speak(time: float) -> None:
        stream.busy(time, "robot1", "patrol", stamp=time + 2.0)
        stream.busy(time, "robot2", "inspect", stamp=time - 2.0)

    stream.every(0.5, 10.0, 20.0, speak)
    assert [(each.rule, each.robots) for each in found(stream)] == [
        ("message_from_the_future", ("robot1",)),
        ("message_from_the_past", ("robot2",)),
    ]


def test_from_the_future_to_the_past_is_one_after_the_other() -> None:
    stream = watched()
    busy_off(stream, 5.0, 10.0, 20.0)
    busy_off(stream, -5.0, 20.0, 30.0)
    incidents = found(stream)
    assert [(each.rule, each.start) for each in incidents] == [
        ("message_from_the_future", 10.0),
        ("message_from_the_past", 21.5),
    ]
    assert incidents[0].end == 20.0


def test_off_again_is_another_incident() -> None:
    stream = watched()
    for start in (10.0, 30.0):
        busy_off(stream, 5.0, start, start + 10.0)
        busy_off(stream, 0.0, start + 10.0, start + 20.0)
    assert [(each.start, each.end) for each in found(stream)] == [(10.0, 20.0), (30.0, 40.0)]


def test_a_computer_that_stood_still_for_a_moment_is_no_incident() -> None:
    stream = watched()
    busy_off(stream, 0.0, 1.0, 10.0)
    for number in range(6):
        stream.busy(12.5 + 0.01 * number, "robot1", "patrol", stamp=10.0 + 0.5 * number)
    busy_off(stream, 0.0, 13.0, 20.0)
    assert found(stream) == ()


def test_causes_are_told_of_each_rule() -> None:
    for causes in (MessageFromTheFuture.causes, MessageFromThePast.causes):
        assert "clock" in causes
        assert causes.endswith(".")


def test_spans_are_told_in_a_unit_that_fits() -> None:
    told = [span_text(seconds) for seconds in (0.04, 119.96, 120.0, 7199.0, 7200.0, 172800.0, 1.7e9)]
    assert told == ["0.0 s", "120.0 s", "2.0 min", "120.0 min", "2.0 h", "2.0 days", "53.9 years"]


def test_topics_that_tell_no_robot_are_not_judged() -> None:
    stream = Stream(mission(busy=[BUSY], incoming=[MonitoredTopic("/new", "x/New", "task")]), rules=RULES)
    stream.every(0.5, 10.0, 20.0, lambda time: stream.say(time, "/new", task="patrol", header__stamp=1.0))
    assert found(stream) == ()
