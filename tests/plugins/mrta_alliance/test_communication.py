"""What is remembered of the others, and what would have harmed an original node (hazards H1 to H4 and H7)."""

from __future__ import annotations

import logging

import pytest
from mrta_alliance.communication import Communication, Hazard
from mrta_alliance.history import History
from mrta_alliance.messages import hazard_notice

from rqt_mrta_py.transport import RosCodec
from tests.plugins.mrta_alliance.team import agent, announced, behaviour_set, motivations, nested, step


def memory(horizon: float = 10.0) -> Communication:
    heard = Communication("one", lambda: History(horizon))
    for task in ("patrol", "inspect"):
        heard.follow(task, 20.0)
    return heard


def test_communication_knows_nobody_at_first() -> None:
    assert memory().about("patrol") == []


def test_communication_trims_its_history_but_keeps_the_first_announcement() -> None:
    """Horizon 10 s: at 30.0 those of 21.0 and 30.0 are left, and the first of 5.0."""
    heard = memory()
    for time in (5.0, 12.0, 21.0, 30.0):
        heard.take_in([announced("two", "patrol", time)], time)
    (other,) = heard.about("patrol")
    assert list(other.times) == [5.0, 21.0, 30.0]
    assert other.noticed == 5.0


def test_communication_keeps_the_newest_expected_duration() -> None:
    heard = memory()
    heard.take_in([announced("two", "patrol", 5.0, 60.0), announced("two", "patrol", 5.1, 90.0)], 5.2)
    assert [other.patience for other in heard.about("patrol")] == [90.0]


def test_communication_keeps_robots_and_tasks_apart() -> None:
    heard = memory()
    heard.take_in([announced("two", "patrol", 5.0), announced("three", "inspect", 5.1)], 5.2)
    assert [list(other.times) for other in heard.about("patrol")] == [[5.0]]
    assert [list(other.times) for other in heard.about("inspect")] == [[5.1]]


def test_communication_counts_a_message_delivered_late_and_out_of_order() -> None:
    heard = memory()
    heard.take_in([announced("two", "patrol", 5.0)], 5.2)
    heard.take_in([announced("two", "patrol", 4.0)], 5.4)
    assert [list(other.times) for other in heard.about("patrol")] == [[5.0, 5.0]]


def test_communication_keeps_the_newest_announcement_however_old_it_is() -> None:
    """Taken in at 30.0 only, beyond the horizon of 10 s: the robot itself had stopped meanwhile."""
    heard = memory()
    heard.take_in([announced("two", "patrol", time) for time in (5.0, 6.0, 7.0)], 30.0)
    assert [list(other.times) for other in heard.about("patrol")] == [[5.0, 7.0]]


def test_communication_never_hears_before_it_is_told() -> None:
    """A receipt ahead of the cycle's time would lie outside every window that ends now."""
    heard = memory()
    heard.take_in([announced("two", "patrol", 7.0)], 5.0)
    assert [list(other.times) for other in heard.about("patrol")] == [[5.0]]


@pytest.mark.parametrize(
    ("robot", "expected", "stamp", "hazard", "believed"),
    [
        ("two", 0.0, 5.0, Hazard.NO_DURATION, False),
        ("two", -3.0, 5.0, Hazard.NO_DURATION, False),
        ("two", float("nan"), 5.0, Hazard.NO_DURATION, False),
        ("two", float("inf"), 5.0, Hazard.NO_DURATION, False),
        ("two", 20.0, 5.0, Hazard.SHORT_DURATION, True),
        ("two", 60.0, 0.0, Hazard.ZERO_STAMP, False),
        ("two", 60.0, 8.0, Hazard.FUTURE_STAMP, True),
        ("", 60.0, 5.0, Hazard.NO_SENDER, False),
    ],
)
def test_communication_survives_and_counts_hazards(
    robot: str, expected: float, stamp: float, hazard: Hazard, believed: bool
) -> None:
    heard = memory()
    for now in (5.0, 5.2):
        heard.take_in([announced(robot, "patrol", 5.0, expected, stamp)], now)
    assert heard.hazards == {(hazard, robot): 2}
    assert bool(heard.about("patrol")) is believed


def test_communication_finds_nothing_wrong_with_sound_announcements() -> None:
    heard = memory()
    heard.take_in([announced("two", "patrol", 5.0, 60.0, 5.9), announced("two", "patrol", 5.1, 20.5, 1.0)], 5.2)
    assert heard.hazards == {}


def test_communication_warns_once_of_each_hazard_and_sender(caplog: pytest.LogCaptureFixture) -> None:
    heard = memory()
    with caplog.at_level(logging.WARNING, "mrta_alliance.communication"):
        for _ in range(3):
            heard.take_in([announced("two", "patrol", 5.0, 0.0)], 5.2)
    assert [record.getMessage() for record in caplog.records] == [
        "robot=one sender=two task=patrol announcement=ignored hazard='expected duration not above zero'"
    ]


def test_agent_is_not_disturbed_by_an_announcement_that_means_nothing() -> None:
    one = agent("one", nested(behaviour_set("patrol")), ["patrol"])
    said = motivations(step(one, 1.0, [announced("two", "patrol", 1.0, expected=0.0)]))["patrol"]
    assert (said["resetted"], said["impatience"], said["motivation"]) == (False, 1.0, 1.0)
    assert one.hazards == {(Hazard.NO_DURATION, "two"): 1}


def test_agent_hears_a_robot_whose_clock_is_ahead() -> None:
    """It is on the task all the same; leaving it out would put two robots on one task."""
    one = agent("one", nested(behaviour_set("patrol")), ["patrol"])
    said = motivations(step(one, 1.0, [announced("two", "patrol", 1.0, stamp=6.0)]))["patrol"]
    assert (said["resetted"], said["impatience"]) == (True, 0.5)
    assert one.hazards == {(Hazard.FUTURE_STAMP, "two"): 1}


def test_agent_is_never_quickened_by_a_short_expected_duration() -> None:
    """30 / 5 = 6 would be six times the fast rate of 1."""
    one = agent("one", nested(behaviour_set("patrol")), ["patrol"])
    said = motivations(step(one, 1.0, [announced("two", "patrol", 1.0, expected=5.0)]))["patrol"]
    assert said["impatience"] == 1.0


def test_agent_puts_each_hazard_and_sender_into_the_ros_log_once() -> None:
    """So that a bag holds it: level 4 is a warning."""
    one = agent("one", nested(behaviour_set("patrol")), ["patrol"])
    said = []
    for now, sender, expected in ((1.0, "two", 0.0), (1.2, "two", 0.0), (1.4, "two", 5.0), (1.6, "three", 0.0)):
        decision = step(one, now, [announced(sender, "patrol", now, expected)])
        said.append([message.fields for message in decision.messages if message.topic == "/rosout"])
    assert [[fields["msg"] for fields in each] for each in said] == [
        ["sender=two task=patrol announcement=ignored hazard='expected duration not above zero'"],
        [],
        ["sender=two task=patrol announcement=heard hazard='expected duration too short to slow this robot down'"],
        ["sender=three task=patrol announcement=ignored hazard='expected duration not above zero'"],
    ]
    (first,) = said[0]
    assert (first["header"], first["level"], first["name"]) == ({"stamp": 1.0}, 4, "/one/agent")


def test_notice_of_a_hazard_is_a_line_of_the_ros_log() -> None:
    codec = RosCodec(lambda type_name: None)
    message = hazard_notice("one", 1.5, "sender=two")
    connection = codec.connection(message.topic, message.type)
    decoded = codec.decode(connection, codec.encode(message.type, message.fields))
    assert (decoded["level"], decoded["name"], decoded["msg"]) == (4, "/one/agent", "sender=two")
