from __future__ import annotations

from typing import Callable, List

import pytest

from rqt_mrta_py.hooks import Heard
from rqt_mrta_py.model import MissionRecord
from rqt_mrta_py.supervisor.plugin import mrta_register_incident_rules
from tests.supervisor.mini import Signs, Stream, allocations, history, of_kind, states


def test_record_before_the_first_message_is_empty() -> None:
    record = Stream().supervisor.record(5.0)
    assert (record.start, record.end, record.robots, record.tasks) == (None, None, (), ())


def test_mission_without_messages_can_be_finished() -> None:
    record = Stream(rules=mrta_register_incident_rules()).finish()
    assert (record.start, record.end, record.incidents, record.events) == (None, None, (), ())


def test_mission_starts_with_the_first_message_and_ends_with_the_last() -> None:
    stream = Stream()
    stream.tick(3.0)
    stream.say(8.5, "/unrelated")
    record = stream.finish()
    assert (record.start, record.end) == (3.0, 8.5)


def test_expiries_are_dated_when_due_and_happen_in_that_order_however_late_they_are_noticed() -> None:
    stream = Stream()
    stream.busy(1.0, "robot2", "inspect")
    stream.busy(1.5, "robot1", "patrol")
    stream.tick(100.0)
    times = [(event.time, event.kind, event.robot or event.task) for event in stream.events[6:]]
    assert times == [
        (3.0, "allocation_ended", "robot2"),
        (3.0, "task_state", "inspect"),
        (3.0, "robot_state", "robot2"),
        (3.5, "allocation_ended", "robot1"),
        (3.5, "task_state", "patrol"),
        (3.5, "robot_state", "robot1"),
    ]


def test_what_is_due_exactly_now_has_not_expired_yet() -> None:
    stream = Stream()
    stream.busy(1.0, "robot1", "patrol")
    stream.tick(3.0)
    assert states(stream.supervisor.record(3.0), "robot1") == [("busy", 1.0, 3.0)]
    assert states(stream.supervisor.record(3.001), "robot1")[-1] == ("offline", 3.0, 3.001)


def test_record_of_a_moment_shows_what_is_due_before_it_and_changes_nothing() -> None:
    stream, untouched = Stream(interpreter=Signs()), Stream(interpreter=Signs())
    for each in (stream, untouched):
        each.busy(1.0, "robot1", "patrol")
    shown = stream.supervisor.record(9.0)
    assert shown.end == 9.0
    assert states(shown, "robot1") == [("busy", 1.0, 3.0), ("offline", 3.0, 9.0)]
    assert allocations(shown) == [("robot1", "patrol", 1.0, 3.0, "lost")]
    assert history(shown, "patrol") == [("executing", 1.0, 3.0), ("waiting", 3.0, 9.0)]
    assert shown.events[-1].text == "robot1 is offline"
    assert stream.events == untouched.events
    for each in (stream, untouched):
        each.busy(2.0, "robot1", "patrol")
    assert stream.supervisor.record() == untouched.supervisor.record()
    assert stream.supervisor.news() == untouched.supervisor.news()


def test_record_never_looks_back_behind_the_newest_message() -> None:
    stream = Stream()
    stream.tick(1.0)
    stream.tick(5.0)
    assert stream.supervisor.record(2.0).end == 5.0


@pytest.mark.parametrize("moment", [4.0, 4.05])
def test_record_settles_what_the_newest_message_decides(moment: float) -> None:
    stream = Stream()
    stream.busy(1.0, "robot1", "patrol")
    stream.odom(2.9, "robot1")
    stream.odom(4.0, "robot1")
    expected = [("robot1", "patrol", 1.0, 3.0, "gave_up")]
    assert allocations(stream.supervisor.record(moment)) == expected
    assert of_kind(stream.events, "allocation_ended") == []
    assert allocations(stream.finish()) == expected
    assert len(of_kind(stream.events, "allocation_ended")) == 1


def test_time_that_jumps_back_counts_as_the_newest_time_seen() -> None:
    stream = Stream()
    stream.busy(10.0, "robot1", "patrol")
    stream.busy(2.0, "robot2", "inspect")
    stream.tick(11.0)
    record = stream.finish()
    assert (record.start, record.end) == (10.0, 11.0)
    assert states(record, "robot2") == [("busy", 10.0, 11.0)]
    assert record.robots[1].last_heard == 10.0
    assert [each.start for each in record.allocations] == [10.0, 10.0]


def test_finishing_twice_gives_the_same_record() -> None:
    stream = Stream()
    stream.busy(1.0, "robot1", "patrol")
    assert stream.finish() is stream.finish() is stream.supervisor.record(9.0)


def test_epoch_times_keep_their_expiries() -> None:
    stream = Stream()
    start = 1510520000.123456
    stream.busy(start, "robot1", "patrol")
    stream.busy(start + 2.0, "robot1", "patrol")
    stream.tick(start + 10.0)
    assert states(stream.finish(), "robot1") == [
        ("busy", start, start + 4.0),
        ("offline", start + 4.0, start + 10.0),
    ]


def scenario(listen: Callable[[Stream], None]) -> MissionRecord:
    stream = Stream(interpreter=Signs(), rules=mrta_register_incident_rules())
    listen(stream)
    stream.every(0.5, 1.0, 9.0, lambda time: stream.busy(time, "robot1", "patrol"))
    stream.every(0.5, 9.0, 15.0, lambda time: stream.idle(time, "robot2"))
    return stream.finish()


def test_order_in_which_one_message_reaches_the_callbacks_does_not_matter() -> None:
    """A message may reach a topic's own listener before the one that hears everything."""

    def reverse(stream: Stream) -> None:
        stream._listeners.reverse()

    def leave(stream: Stream) -> None:
        pass

    assert allocations(scenario(reverse)) == allocations(scenario(leave))
    assert scenario(reverse).incidents == scenario(leave).incidents


def test_unreadable_messages_are_told_once_for_each_topic_and_type() -> None:
    stream = Stream()
    heard: List[Heard] = [Heard("/a", "x/Y", float(index), {}, ordinal=index) for index in range(3)]
    for each in heard:
        stream.supervisor.report(each, "the definition lacks field z")
    stream.supervisor.report(Heard("/b", "x/Y", 3.0, {}), "7 bytes are missing")
    told = [(event.time, event.severity.value, event.text) for event in of_kind(stream.events, "unreadable")]
    assert told == [
        (0.0, "warning", "/a (x/Y) cannot be read: the definition lacks field z"),
        (3.0, "warning", "/b (x/Y) cannot be read: 7 bytes are missing"),
    ]
    assert stream.finish().end == 3.0
