from __future__ import annotations

import pytest

from rqt_mrta_py.model import MonitoredTopic, Progress
from tests.supervisor.mini import ALLOCATED, BUSY, Signs, Stream, allocations, history, mission, of_kind


def test_broadcasts_slower_than_the_allocated_timeout_hold_for_the_busy_timeout() -> None:
    """Appendix A gives 0.5 s, while the original's broadcasts come 0.4 and 0.6 s apart."""
    assert ALLOCATED.timeout == 0.5
    stream = Stream()
    for time in (1.0, 1.4, 2.0, 2.4, 3.0):
        stream.busy(time, "robot1", "patrol")
    assert allocations(stream.finish()) == [("robot1", "patrol", 1.0, 3.0, "open")]


def test_sign_with_an_outcome_ends_the_allocation() -> None:
    stream = Stream(interpreter=Signs())
    stream.busy(1.0, "robot1", "patrol")
    stream.sign(2.0, "robot1", "patrol", "gave_up")
    stream.tick(2.5)
    record = stream.finish()
    assert allocations(record) == [("robot1", "patrol", 1.0, 2.0, "gave_up")]
    assert history(record, "patrol") == [("executing", 1.0, 2.0), ("waiting", 2.0, 2.5)]
    (event,) = of_kind(stream.events, "allocation_ended")
    assert event.text == "robot1 has given up patrol: said so"


def test_sign_that_the_task_is_done_ends_the_task() -> None:
    stream = Stream(interpreter=Signs())
    stream.busy(1.0, "robot1", "patrol")
    stream.sign(2.0, "robot1", "patrol", "done")
    assert history(stream.finish(), "patrol") == [("executing", 1.0, 2.0), ("done", 2.0, 2.0)]


def test_sign_of_an_allocation_that_is_not_open_says_nothing() -> None:
    stream = Stream(interpreter=Signs())
    stream.sign(1.0, "robot1", "patrol")
    stream.sign(2.0, "robot1", "patrol", "gave_up")
    assert stream.finish().allocations == ()


def test_sign_that_the_robot_still_holds_the_task_keeps_the_allocation_going() -> None:
    stream = Stream(interpreter=Signs())
    stream.busy(1.0, "robot1", "patrol")
    stream.sign(2.5, "robot1", "patrol")
    stream.odom(4.0, "robot1")
    stream.odom(5.0, "robot1")
    stream.tick(5.1)
    assert allocations(stream.finish()) == [("robot1", "patrol", 1.0, 4.5, "gave_up")]


def test_running_task_keeps_the_allocation_going() -> None:
    stream = Stream()
    stream.busy(1.0, "robot1", "patrol")
    stream.progress(2.5, "patrol", "robot1", Progress.RUNNING)
    stream.odom(4.0, "robot1")
    assert allocations(stream.finish()) == [("robot1", "patrol", 1.0, 4.0, "open")]


def test_late_message_does_not_begin_an_allocation_again_after_the_sign_that_ended_it() -> None:
    stream = Stream(interpreter=Signs())
    stream.busy(1.0, "robot1", "patrol")
    stream.sign(2.0, "robot1", "patrol", "gave_up")
    stream.busy(2.2, "robot1", "patrol", stamp=1.9)
    stream.busy(2.3, "robot1", "patrol", stamp=2.0)
    assert allocations(stream.finish()) == [("robot1", "patrol", 1.0, 2.0, "gave_up")]


@pytest.mark.parametrize("stamp", [2.1, 0.0], ids=["newer stamp", "no stamp"])
def test_message_that_is_not_known_to_be_late_begins_an_allocation_again(stamp: float) -> None:
    stream = Stream(interpreter=Signs())
    stream.busy(1.0, "robot1", "patrol")
    stream.sign(2.0, "robot1", "patrol", "gave_up")
    stream.busy(2.2, "robot1", "patrol", stamp=stamp)
    assert allocations(stream.finish()) == [
        ("robot1", "patrol", 1.0, 2.0, "gave_up"),
        ("robot1", "patrol", 2.2, 2.2, "open"),
    ]


def test_robot_without_any_sign_gave_up_when_it_is_heard_again() -> None:
    stream = Stream()
    stream.busy(1.0, "robot1", "patrol")
    stream.odom(2.9, "robot1")
    stream.tick(3.5)
    assert allocations(stream.supervisor.record()) == [("robot1", "patrol", 1.0, 3.5, "open")]
    stream.odom(4.0, "robot1")
    stream.tick(4.5)
    record = stream.finish()
    assert allocations(record) == [("robot1", "patrol", 1.0, 3.0, "gave_up")]
    assert history(record, "patrol") == [("executing", 1.0, 3.0), ("waiting", 3.0, 4.5)]


def test_robot_yielded_when_another_holds_the_task_after_the_expiry() -> None:
    stream = Stream()
    stream.busy(1.0, "robot1", "patrol")
    stream.busy(2.5, "robot2", "patrol")
    stream.odom(2.9, "robot1")
    stream.odom(3.1, "robot1")
    stream.tick(3.2)
    assert allocations(stream.finish()) == [
        ("robot1", "patrol", 1.0, 3.0, "yielded"),
        ("robot2", "patrol", 2.5, 3.2, "open"),
    ]


@pytest.mark.parametrize("switches", [2.0, 3.5], ids=["before the expiry", "as its first word after the expiry"])
def test_robot_was_taken_from_the_task_when_it_has_taken_another(switches: float) -> None:
    stream = Stream()
    stream.busy(1.0, "robot1", "patrol")
    stream.odom(1.9, "robot1")
    stream.busy(switches, "robot1", "inspect")
    stream.odom(3.6, "robot1")
    stream.tick(3.7)
    assert allocations(stream.finish()) == [
        ("robot1", "patrol", 1.0, 3.0, "preempted"),
        ("robot1", "inspect", switches, 3.7, "open"),
    ]


def test_same_task_taken_again_after_the_expiry_is_another_allocation() -> None:
    stream = Stream()
    stream.busy(1.0, "robot1", "patrol")
    stream.odom(2.9, "robot1")
    stream.busy(3.5, "robot1", "patrol")
    assert allocations(stream.finish()) == [
        ("robot1", "patrol", 1.0, 3.0, "gave_up"),
        ("robot1", "patrol", 3.5, 3.5, "open"),
    ]


def test_robot_that_falls_silent_loses_the_task_when_the_silence_falls_due() -> None:
    stream = Stream()
    stream.busy(1.0, "robot1", "patrol")
    stream.odom(1.5, "robot1")
    stream.tick(9.0)
    record = stream.finish()
    assert allocations(record) == [("robot1", "patrol", 1.0, 3.5, "lost")]
    assert history(record, "patrol") == [("executing", 1.0, 3.5), ("waiting", 3.5, 9.0)]


def test_robot_that_speaks_on_any_topic_is_not_lost() -> None:
    stream = Stream(interpreter=Signs())
    stream.busy(1.0, "robot1", "patrol")
    stream.every(0.5, 1.0, 8.0, lambda time: stream.odom(time, "robot1"))
    assert [outcome for *_, outcome in allocations(stream.finish())] == ["gave_up"]


def test_silence_lasts_as_long_as_the_longest_timeout() -> None:
    patient = MonitoredTopic(BUSY.name, BUSY.type, BUSY.field, timeout=5.0)
    stream = Stream(mission(busy=[patient], idle=[]))
    stream.busy(1.0, "robot1", "patrol")
    stream.tick(9.0)
    assert allocations(stream.finish()) == [("robot1", "patrol", 1.0, 6.0, "lost")]


def test_silence_lasts_two_seconds_at_least() -> None:
    hasty = MonitoredTopic(BUSY.name, BUSY.type, BUSY.field, timeout=0.5)
    stream = Stream(mission(busy=[hasty], idle=[]))
    stream.busy(1.0, "robot1", "patrol")
    stream.tick(9.0)
    assert allocations(stream.finish()) == [("robot1", "patrol", 1.0, 3.0, "lost")]


def test_winner_that_never_spoke_is_lost_when_the_award_expires() -> None:
    award = MonitoredTopic("/award", "", "task", robot_field="winner", timeout=4.0)
    stream = Stream(mission(allocated=[award]))
    stream.say(1.0, "/award", caller="/auctioneer", task="patrol", winner="robot2")
    stream.tick(9.0)
    record = stream.finish()
    assert allocations(record) == [("robot2", "patrol", 1.0, 5.0, "lost")]
    assert record.robots[1].last_heard is None


def test_reassigned_task_is_taken_from_all_others() -> None:
    stream = Stream()
    stream.busy(1.0, "robot1", "patrol")
    stream.progress(2.0, "patrol", "robot2", Progress.REASSIGNED)
    stream.busy(2.1, "robot1", "patrol", stamp=1.9)
    stream.busy(2.5, "robot2", "patrol")
    assert allocations(stream.finish()) == [
        ("robot1", "patrol", 1.0, 2.0, "preempted"),
        ("robot2", "patrol", 2.5, 2.5, "open"),
    ]


def test_task_reassigned_to_the_robot_that_holds_it_goes_on() -> None:
    stream = Stream()
    stream.busy(1.0, "robot1", "patrol")
    stream.progress(2.0, "patrol", "/robot1", Progress.REASSIGNED)
    assert allocations(stream.finish()) == [("robot1", "patrol", 1.0, 2.0, "open")]


def test_task_reassigned_to_one_of_two_holders_is_taken_from_the_other_only() -> None:
    stream = Stream(mission(robots_a_task=2))
    stream.busy(1.0, "robot1", "patrol")
    stream.busy(1.5, "robot2", "patrol")
    stream.progress(2.0, "patrol", "robot2", Progress.REASSIGNED)
    stream.tick(2.5)
    record = stream.finish()
    assert allocations(record) == [
        ("robot1", "patrol", 1.0, 2.0, "preempted"),
        ("robot2", "patrol", 1.5, 2.5, "open"),
    ]
    assert history(record, "patrol") == [("executing", 1.0, 2.5)]


@pytest.mark.parametrize("named", ["", "robot9"])
def test_task_reassigned_to_nobody_known_is_taken_from_all_and_waits(named: str) -> None:
    stream = Stream()
    stream.busy(1.0, "robot1", "patrol")
    stream.progress(2.0, "patrol", named, Progress.REASSIGNED)
    stream.tick(2.5)
    record = stream.finish()
    assert allocations(record) == [("robot1", "patrol", 1.0, 2.0, "preempted")]
    assert history(record, "patrol") == [("executing", 1.0, 2.0), ("waiting", 2.0, 2.5)]


def test_task_that_has_ended_stays_ended_when_it_is_reassigned() -> None:
    stream = Stream()
    stream.busy(1.0, "robot1", "patrol")
    stream.progress(2.0, "patrol", "robot1", Progress.DONE)
    stream.progress(2.5, "patrol", "robot2", Progress.REASSIGNED)
    stream.tick(3.0)
    record = stream.finish()
    assert allocations(record) == [("robot1", "patrol", 1.0, 2.0, "done")]
    assert history(record, "patrol") == [("executing", 1.0, 2.0), ("done", 2.0, 3.0)]


def test_robot_whose_clock_is_far_behind_gets_its_task_into_the_books_all_the_same() -> None:
    """An operator's stamp and a robot's are of different clocks; by stamps alone robot1 held nothing for a minute."""
    stream = Stream()
    stream.every(0.5, 61.0, 62.0, lambda time: stream.busy(time, "robot1", "patrol", stamp=time - 60.0))
    stream.progress(62.0, "patrol", "robot2", Progress.REASSIGNED)
    stream.busy(62.3, "robot1", "patrol", stamp=2.3)
    stream.every(0.5, 64.5, 66.0, lambda time: stream.busy(time, "robot1", "patrol", stamp=time - 60.0))
    stream.tick(66.0)
    assert allocations(stream.finish()) == [
        ("robot1", "patrol", 61.0, 62.0, "preempted"),
        ("robot1", "patrol", 64.5, 66.0, "open"),
    ]


def test_done_by_one_robot_preempts_another_on_a_single_robot_task() -> None:
    stream = Stream()
    stream.busy(1.0, "robot1", "patrol")
    stream.busy(1.5, "robot2", "patrol")
    stream.progress(2.0, "patrol", "robot2", Progress.DONE)
    assert [(robot, outcome) for robot, *_, outcome in allocations(stream.finish())] == [
        ("robot1", "preempted"),
        ("robot2", "done"),
    ]


def test_done_by_one_robot_is_done_by_all_on_a_task_of_several_robots() -> None:
    stream = Stream(mission(robots_a_task=2))
    stream.busy(1.0, "robot1", "patrol")
    stream.busy(1.5, "robot2", "patrol")
    stream.progress(2.0, "patrol", "robot2", Progress.DONE)
    assert [outcome for *_, outcome in allocations(stream.finish())] == ["done", "done"]


def test_busy_message_that_names_the_task_allocates_it() -> None:
    busy = MonitoredTopic("/busy", "", "robot", task_field="task")
    stream = Stream(mission(busy=[busy], allocated=[]))
    stream.say(1.0, "/busy", robot="robot1", task="patrol")
    stream.tick(2.0)
    assert allocations(stream.finish()) == [("robot1", "patrol", 1.0, 2.0, "open")]


def test_busy_topic_whose_name_tells_the_task_allocates_it() -> None:
    busy = MonitoredTopic("/@robot_id@/busy/@task_id@", "")
    stream = Stream(mission(busy=[busy], allocated=[]))
    stream.say(1.0, "/robot1/busy/patrol")
    stream.tick(2.0)
    record = stream.finish()
    assert allocations(record) == [("robot1", "patrol", 1.0, 2.0, "open")]
    assert history(record, "patrol") == [("executing", 1.0, 2.0)]


def test_names_of_topics_tell_robot_and_task() -> None:
    tokens = MonitoredTopic("/@robot_id@/doing/@task_id@", "", timeout=1.0)
    stream = Stream(mission(allocated=[tokens]))
    stream.say(1.0, "/robot2/doing/report")
    assert allocations(stream.finish()) == [("robot2", "report", 1.0, 1.0, "open")]


def test_allocation_without_length_is_left_out() -> None:
    stream = Stream()
    stream.busy(1.0, "robot1", "patrol")
    stream.progress(1.0, "patrol", "robot1", Progress.DONE)
    stream.tick(2.0)
    record = stream.finish()
    assert record.allocations == ()
    assert history(record, "patrol") == [("done", 1.0, 2.0)]
