from __future__ import annotations

import pytest

from rqt_mrta_py.model import MonitoredTopic
from tests.supervisor.mini import BUSY, IDLE, Stream, mission, of_kind, states


def test_robot_is_offline_until_it_is_heard() -> None:
    stream = Stream()
    stream.tick(1.0)
    stream.tick(4.0)
    record = stream.finish()
    assert states(record, "robot1") == [("offline", 1.0, 4.0)]
    assert record.robots[0].last_heard is None


def test_robot_is_busy_while_its_busy_message_is_younger_than_the_timeout() -> None:
    stream = Stream()
    stream.tick(0.0)
    stream.busy(1.0, "robot1", "patrol")
    stream.busy(2.5, "robot1", "patrol")
    stream.tick(10.0)
    assert states(stream.finish(), "robot1") == [("offline", 0.0, 1.0), ("busy", 1.0, 4.5), ("offline", 4.5, 10.0)]


def test_robot_falls_back_to_idle_when_busy_expires_and_idle_is_fresh() -> None:
    stream = Stream()
    stream.tick(0.0)
    stream.busy(1.0, "robot1", "patrol")
    stream.idle(2.0, "robot1")
    stream.tick(10.0)
    assert states(stream.finish(), "robot1") == [
        ("offline", 0.0, 1.0),
        ("busy", 1.0, 3.0),
        ("idle", 3.0, 4.0),
        ("offline", 4.0, 10.0),
    ]


def test_robot_goes_offline_at_once_when_busy_and_idle_expire_together() -> None:
    stream = Stream()
    stream.idle(1.0, "robot1")
    stream.busy(1.0, "robot1", "patrol")
    stream.tick(10.0)
    assert states(stream.finish(), "robot1") == [("busy", 1.0, 3.0), ("offline", 3.0, 10.0)]


def test_message_received_when_the_state_falls_due_renews_it() -> None:
    # As binary fractions 2.3 + 1.3 is less than 3.6; as stamps they are one.
    assert 2.3 + 1.3 < 3.6
    busy = MonitoredTopic(BUSY.name, BUSY.type, BUSY.field, timeout=1.3)
    stream = Stream(mission(busy=[busy], idle=[]))
    stream.busy(2.3, "robot1", "patrol")
    stream.busy(3.6, "robot1", "patrol")
    stream.tick(4.9)
    record = stream.finish()
    assert states(record, "robot1") == [("busy", 2.3, 4.9)]
    assert len(record.allocations) == 1
    assert len(of_kind(stream.events, "robot_state")) == 1


def test_other_message_received_when_busy_falls_due_does_not_renew_it() -> None:
    stream = Stream()
    stream.busy(1.0, "robot1", "patrol")
    stream.idle(3.0, "robot1")
    stream.tick(4.0)
    assert states(stream.finish(), "robot1") == [("busy", 1.0, 3.0), ("idle", 3.0, 4.0)]


def test_each_topic_keeps_its_own_timeout() -> None:
    slow = MonitoredTopic("/slow", "", "robot", timeout=5.0)
    quick = MonitoredTopic("/quick", "", "robot", timeout=1.0)
    stream = Stream(mission(busy=[slow, quick], idle=[], allocated=[]))
    stream.say(0.0, "/quick", robot="robot1")
    stream.tick(2.0)
    stream.say(3.0, "/slow", robot="robot1")
    stream.say(4.0, "/quick", robot="robot1")
    stream.tick(20.0)
    assert states(stream.finish(), "robot1") == [
        ("busy", 0.0, 1.0),
        ("offline", 1.0, 3.0),
        ("busy", 3.0, 8.0),
        ("offline", 8.0, 20.0),
    ]


def test_shorter_busy_timeout_expires_before_a_longer_idle_one() -> None:
    idle = MonitoredTopic("/idle", "", "robot", timeout=9.0)
    stream = Stream(mission(idle=[idle]))
    stream.say(0.0, "/idle", robot="robot1")
    stream.busy(1.0, "robot1", "patrol")
    stream.tick(20.0)
    assert states(stream.finish(), "robot1") == [
        ("idle", 0.0, 1.0),
        ("busy", 1.0, 3.0),
        ("idle", 3.0, 9.0),
        ("offline", 9.0, 20.0),
    ]


@pytest.mark.parametrize("spelling", ["robot1", "/robot1"])
def test_ids_are_compared_without_the_leading_slash(spelling: str) -> None:
    stream = Stream()
    stream.say(1.0, BUSY.name, header__frame_id=spelling, task_id="patrol")
    assert states(stream.finish(), "robot1") == [("busy", 1.0, 1.0)]


def test_topic_name_tells_the_robot_where_no_field_does() -> None:
    stream = Stream()
    stream.say(1.0, "/robot2/alliance/motivation/patrol")
    assert states(stream.finish(), "robot2") == [("idle", 1.0, 1.0)]


def test_field_tells_the_robot_before_the_topic_name_does() -> None:
    topic = MonitoredTopic(IDLE.name, IDLE.type, "header/frame_id")
    stream = Stream(mission(idle=[topic]))
    stream.say(1.0, "/relay/alliance/motivation/patrol", header__frame_id="/robot2")
    assert states(stream.finish(), "robot2") == [("idle", 1.0, 1.0)]


def test_robots_that_the_application_does_not_list_are_ignored() -> None:
    stream = Stream()
    stream.busy(1.0, "stranger", "patrol")
    record = stream.finish()
    assert [robot.id for robot in record.robots] == ["robot1", "robot2"]
    assert record.allocations == ()


def test_robots_are_admitted_by_first_sight_where_none_are_listed() -> None:
    stream = Stream(mission(robots=(), tasks=()))
    stream.tick(0.0)
    stream.busy(1.0, "zeta", "patrol")
    stream.busy(2.0, "alpha", "inspect")
    record = stream.finish()
    assert [robot.id for robot in record.robots] == ["zeta", "alpha"]
    assert [task.id for task in record.tasks] == ["patrol", "inspect"]
    assert states(record, "alpha") == [("offline", 0.0, 2.0), ("busy", 2.0, 2.0)]


def test_any_topic_in_the_namespace_counts_as_hearing_the_robot() -> None:
    stream = Stream()
    stream.say(1.0, "/robot1/scan")
    stream.say(2.0, "/tf", caller="/robot2/driver")
    stream.say(3.0, "/robot12/scan")
    record = stream.finish()
    assert [robot.last_heard for robot in record.robots] == [1.0, 2.0]


def test_caller_counts_before_the_namespace_of_the_topic() -> None:
    stream = Stream()
    stream.say(1.0, "/robot2/inbox", caller="/robot1/agent")
    record = stream.finish()
    assert [robot.last_heard for robot in record.robots] == [1.0, None]


def test_named_robot_counts_before_the_caller_when_a_recorder_writes_all_publishers_as_one() -> None:
    """The recording of the original nodes has robot2's broadcasts under robot1's name."""
    stream = Stream()
    stream.say(1.0, BUSY.name, caller="/robot1/alliance/high_level", header__frame_id="/robot2", task_id="patrol")
    record = stream.finish()
    assert [robot.last_heard for robot in record.robots] == [None, 1.0]


@pytest.mark.parametrize("value", [None, 1.5, True, "", "/"])
def test_message_without_a_usable_id_changes_nothing(value: object) -> None:
    stream = Stream(mission(robots=(), tasks=()))
    stream.say(1.0, BUSY.name, header__frame_id=value, task_id="patrol")
    record = stream.finish()
    assert record.robots == ()


def test_whole_number_is_an_id() -> None:
    stream = Stream(mission(robots=("7",)))
    stream.say(1.0, BUSY.name, header__frame_id=7, task_id="patrol")
    assert states(stream.finish(), "7") == [("busy", 1.0, 1.0)]


def test_offline_is_a_warning_among_events() -> None:
    stream = Stream()
    stream.busy(1.0, "robot1", "patrol")
    stream.tick(9.0)
    told = [(event.time, event.severity.value, event.state) for event in of_kind(stream.events, "robot_state")]
    assert told == [(1.0, "info", "busy"), (3.0, "warning", "offline")]
