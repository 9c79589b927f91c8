from __future__ import annotations

from typing import Dict

import pytest

from rqt_mrta_py.model import MonitoredTopic, Progress, TaskState
from rqt_mrta_py.supervisor.tasks import FINAL, TRANSITIONS
from tests.supervisor.mini import ALLOCATED, Stream, allocations, history, mission, of_kind

INCOMING = MonitoredTopic("/incoming", "", "task")
COMPLETED = MonitoredTopic("/completed", "", "task", robot_field="robot")
FAILED = MonitoredTopic("/failed", "", "task")


def test_listed_task_waits_from_the_start_and_executes_while_its_robot_is_busy() -> None:
    stream = Stream()
    stream.tick(0.0)
    stream.busy(1.0, "robot1", "patrol")
    stream.odom(3.5, "robot1")
    stream.tick(4.0)
    record = stream.finish()
    assert history(record, "patrol") == [("waiting", 0.0, 1.0), ("executing", 1.0, 3.0), ("waiting", 3.0, 4.0)]
    assert history(record, "inspect") == [("waiting", 0.0, 4.0)]


def test_task_is_allocated_while_its_robot_is_not_busy_with_it() -> None:
    award = MonitoredTopic("/award", "", "task", robot_field="winner", timeout=10.0)
    stream = Stream(mission(allocated=[award]))
    stream.say(1.0, "/award", task="patrol", winner="robot2")
    stream.busy(2.0, "robot2", "")
    stream.odom(3.5, "robot2")
    stream.tick(5.0)
    record = stream.finish()
    assert history(record, "patrol") == [
        ("allocated", 1.0, 2.0),
        ("executing", 2.0, 4.0),
        ("allocated", 4.0, 5.0),
    ]


def test_allocated_message_that_names_nobody_allocates_the_task_only() -> None:
    nameless = MonitoredTopic("/allocated", "", "task", timeout=3.0)
    stream = Stream(mission(allocated=[nameless]))
    stream.tick(0.0)
    stream.say(1.0, "/allocated", task="patrol")
    stream.say(2.0, "/allocated", task="patrol")
    stream.tick(9.0)
    record = stream.finish()
    assert history(record, "patrol") == [("waiting", 0.0, 1.0), ("allocated", 1.0, 5.0), ("waiting", 5.0, 9.0)]
    assert record.allocations == ()


def test_incoming_message_brings_up_a_task_that_was_not_listed() -> None:
    stream = Stream(mission(incoming=[INCOMING]))
    stream.tick(0.0)
    stream.say(2.0, "/incoming", task="/rescue")
    stream.tick(3.0)
    record = stream.finish()
    assert [task.id for task in record.tasks] == ["patrol", "inspect", "report", "rescue"]
    assert history(record, "rescue") == [("waiting", 2.0, 3.0)]
    assert [event.text for event in of_kind(stream.events, "task_state")] == ["rescue has come up and is waiting"]


def test_later_task_waits_from_the_moment_it_appears() -> None:
    stream = Stream(mission(later=["rescue"]))
    stream.tick(0.0)
    stream.progress(2.0, "/rescue", "", Progress.APPEARED)
    stream.busy(3.0, "robot1", "rescue")
    stream.tick(4.0)
    record = stream.finish()
    assert [task.id for task in record.tasks] == ["patrol", "inspect", "report", "rescue"]
    assert history(record, "rescue") == [("waiting", 2.0, 3.0), ("executing", 3.0, 4.0)]
    texts = [event.text for event in of_kind(stream.events, "task_state")]
    assert texts == ["rescue has come up and is waiting", "rescue is executing"]


def test_later_task_enters_the_books_when_it_is_taken_though_nobody_heard_it_appear() -> None:
    stream = Stream(mission(later=["rescue"]))
    stream.tick(0.0)
    stream.busy(3.0, "robot1", "rescue")
    stream.tick(4.0)
    record = stream.finish()
    assert history(record, "rescue") == [("executing", 3.0, 4.0)]
    assert allocations(record) == [("robot1", "rescue", 3.0, 4.0, "open")]


def test_later_task_counts_the_robots_that_its_list_says_it_needs() -> None:
    stream = Stream(mission(later=["rescue"], robots_a_task=2))
    stream.progress(1.0, "rescue", "", Progress.APPEARED)
    stream.busy(2.0, "robot1", "rescue")
    stream.busy(2.0, "robot2", "rescue")
    stream.progress(3.0, "rescue", "robot1", Progress.DONE)
    assert [outcome for *_, outcome in allocations(stream.finish())] == ["done", "done"]


def test_team_whose_tasks_all_come_later_is_not_one_that_lists_none() -> None:
    stream = Stream(mission(tasks=(), later=["rescue"]))
    stream.busy(1.0, "robot1", "ghost")
    stream.tick(2.0)
    assert stream.finish().tasks == ()


def test_task_withdrawn_before_anybody_took_it_stays_in_the_books_and_may_appear_again() -> None:
    stream = Stream(mission(later=["rescue"]))
    stream.tick(0.0)
    stream.progress(1.0, "rescue", "", Progress.APPEARED)
    stream.progress(2.0, "rescue", "", Progress.WITHDRAWN)
    stream.busy(2.5, "robot1", "rescue")
    stream.progress(3.0, "rescue", "", Progress.APPEARED)
    stream.busy(4.0, "robot1", "rescue")
    stream.progress(5.0, "rescue", "", Progress.WITHDRAWN)
    stream.tick(6.0)
    record = stream.finish()
    assert history(record, "rescue") == [
        ("waiting", 1.0, 2.0),
        ("withdrawn", 2.0, 3.0),
        ("waiting", 3.0, 4.0),
        ("executing", 4.0, 5.0),
        ("withdrawn", 5.0, 6.0),
    ]
    assert allocations(record) == [("robot1", "rescue", 4.0, 5.0, "preempted")]


def test_unlisted_task_stays_unknown_when_only_allocated() -> None:
    stream = Stream()
    stream.busy(1.0, "robot1", "rescue")
    record = stream.finish()
    assert [task.id for task in record.tasks] == ["patrol", "inspect", "report"]
    assert record.allocations == ()


@pytest.mark.parametrize(
    ("topic", "fields", "state", "outcome"),
    [
        ("/completed", {"task": "patrol", "robot": "robot1"}, "done", "done"),
        ("/completed", {"task": "patrol"}, "done", "done"),
        ("/failed", {"task": "patrol"}, "failed", "failed"),
    ],
)
def test_completed_and_failed_topics_end_the_task(topic: str, fields: Dict[str, str], state: str, outcome: str) -> None:
    stream = Stream(mission(completed=[COMPLETED], failed=[FAILED]))
    stream.busy(1.0, "robot1", "patrol")
    stream.say(2.0, topic, **fields)
    stream.tick(3.0)
    record = stream.finish()
    assert history(record, "patrol") == [("executing", 1.0, 2.0), (state, 2.0, 3.0)]
    assert allocations(record) == [("robot1", "patrol", 1.0, 2.0, outcome)]


@pytest.mark.parametrize(
    ("progress", "state", "outcome"),
    [
        (Progress.DONE, "done", "done"),
        (Progress.FAILED, "failed", "failed"),
        (Progress.WITHDRAWN, "withdrawn", "preempted"),
        (Progress.UNREACHABLE, "waiting", "failed"),
    ],
)
def test_progress_ends_the_allocation_under_every_architecture(progress: Progress, state: str, outcome: str) -> None:
    stream = Stream()
    stream.busy(1.0, "robot1", "patrol")
    stream.progress(2.0, "patrol", "/robot1", progress, caller="/robot1/agent")
    stream.tick(3.0)
    record = stream.finish()
    assert history(record, "patrol") == [("executing", 1.0, 2.0), (state, 2.0, 3.0)]
    assert allocations(record) == [("robot1", "patrol", 1.0, 2.0, outcome)]


@pytest.mark.parametrize("again", [Progress.DONE, Progress.FAILED, Progress.WITHDRAWN, Progress.RUNNING])
@pytest.mark.parametrize("final", [Progress.DONE, Progress.FAILED, Progress.WITHDRAWN])
def test_final_state_stays_whatever_is_told_later(final: Progress, again: Progress) -> None:
    stream = Stream()
    stream.busy(1.0, "robot1", "patrol")
    stream.progress(2.0, "patrol", "robot1", final)
    stream.progress(3.0, "patrol", "robot1", again)
    stream.busy(4.0, "robot2", "patrol")
    record = stream.finish()
    assert history(record, "patrol") == [("executing", 1.0, 2.0), (final.value, 2.0, 4.0)]
    assert len(record.allocations) == 1


def test_task_that_appears_again_begins_anew() -> None:
    stream = Stream()
    stream.tick(0.0)
    stream.progress(1.0, "patrol", "", Progress.DONE)
    stream.progress(2.0, "patrol", "", Progress.APPEARED)
    stream.busy(3.0, "robot1", "patrol")
    stream.tick(4.0)
    assert history(stream.finish(), "patrol") == [
        ("waiting", 0.0, 1.0),
        ("done", 1.0, 2.0),
        ("waiting", 2.0, 3.0),
        ("executing", 3.0, 4.0),
    ]


def test_task_that_appears_while_it_is_held_goes_on() -> None:
    stream = Stream()
    stream.busy(1.0, "robot1", "patrol")
    stream.progress(2.0, "patrol", "", Progress.APPEARED)
    stream.tick(2.5)
    assert history(stream.finish(), "patrol") == [("executing", 1.0, 2.5)]


def test_operator_who_withdraws_a_task_does_not_count_as_the_robot() -> None:
    stream = Stream()
    stream.progress(1.0, "patrol", "robot1", Progress.WITHDRAWN)
    stream.progress(2.0, "inspect", "robot2", Progress.DONE)
    assert [robot.last_heard for robot in stream.finish().robots] == [None, 2.0]


def test_report_of_an_unknown_task_or_of_none_changes_nothing() -> None:
    stream = Stream()
    stream.progress(1.0, "rescue", "robot1", Progress.DONE)
    stream.progress(2.0, "", "", Progress.APPEARED)
    record = stream.finish()
    assert [task.id for task in record.tasks] == ["patrol", "inspect", "report"]
    assert {task.state.value for task in record.tasks} == {"waiting"}


def test_allocation_to_nobody_known_is_over_when_the_task_has_ended() -> None:
    nameless = MonitoredTopic("/allocated", "", "task", timeout=9.0)
    stream = Stream(mission(allocated=[nameless, ALLOCATED]))
    stream.say(1.0, "/allocated", task="patrol")
    stream.progress(2.0, "patrol", "", Progress.DONE)
    stream.progress(3.0, "patrol", "", Progress.APPEARED)
    stream.busy(4.0, "robot1", "patrol")
    stream.tick(20.0)
    assert history(stream.finish(), "patrol") == [
        ("allocated", 1.0, 2.0),
        ("done", 2.0, 3.0),
        ("waiting", 3.0, 4.0),
        ("executing", 4.0, 6.0),
        ("waiting", 6.0, 20.0),
    ]


def test_ended_task_stays_ended_when_an_allocation_to_nobody_known_expires() -> None:
    nameless = MonitoredTopic("/allocated", "", "task", timeout=3.0)
    stream = Stream(mission(allocated=[nameless]))
    stream.say(1.0, "/allocated", task="patrol")
    stream.progress(2.0, "patrol", "", Progress.FAILED)
    stream.tick(20.0)
    assert history(stream.finish(), "patrol") == [("allocated", 1.0, 2.0), ("failed", 2.0, 20.0)]


def test_unknown_progress_is_reported_once() -> None:
    stream = Stream()
    for time in (1.0, 2.0):
        stream.say(time, "/mrta/task_progress", task_id="patrol", robot_id="", progress=9, detail="", header__stamp=0.0)
    (event,) = of_kind(stream.events, "unreadable")
    assert (event.time, event.text) == (
        1.0,
        "/mrta/task_progress () cannot be read: progress is 9; accepted is 0 to 6",
    )


def test_transition_table_names_every_state_and_ends_in_the_final_ones() -> None:
    assert set(TRANSITIONS) == set(TaskState)
    assert {TaskState.DONE, TaskState.FAILED, TaskState.WITHDRAWN} == FINAL
    assert all(state not in successors for state, successors in TRANSITIONS.items())
