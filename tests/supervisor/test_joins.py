"""Topics that name an auction where the task should stand, and topics of which only some messages count."""

from __future__ import annotations

from typing import Any, List

import pytest

from rqt_mrta_py.hooks import Heard
from rqt_mrta_py.model import MonitoredTopic, TaskState, TopicCondition, TopicJoin
from rqt_mrta_py.supervisor.joins import JoinTable
from rqt_mrta_py.supervisor.values import meets
from tests.supervisor.mini import Stream, mission

NEWS = TopicJoin("/news", "", "id", "task/id")
BUSY = MonitoredTopic("/working", "", "robot", task_field="auction", join=NEWS)
AWARD = MonitoredTopic("/award", "", "auction", robot_field="winner", join=NEWS)
DONE = MonitoredTopic("/result", "", "auction", robot_field="winner", join=NEWS, condition=TopicCondition("ok", "true"))
FAILED = MonitoredTopic(
    "/result", "", "auction", robot_field="winner", join=NEWS, condition=TopicCondition("ok", "false")
)


def market(**parts: Any) -> Stream:
    return Stream(mission(idle=(), **{"busy": (), "allocated": (AWARD,), **parts}))


def taken(stream: Stream) -> List[List[str]]:
    return [[each.robot, each.task, each.outcome.value] for each in stream.supervisor.finish().allocations]


def test_an_award_goes_to_the_task_that_its_auction_was_announced_for() -> None:
    stream = market()
    stream.say(1.0, "/news", id="a-1", task__id="patrol")
    stream.say(1.1, "/news", id="a-2", task__id="/inspect")
    stream.say(2.0, "/award", auction="a-2", winner="robot1")
    stream.say(2.1, "/award", auction="a-1", winner="robot2")

    assert taken(stream) == [["robot1", "inspect", "open"], ["robot2", "patrol", "open"]]
    assert not stream.supervisor.unreadable


def test_the_newest_announcement_of_an_auction_counts() -> None:
    stream = market()
    stream.say(1.0, "/news", id="a-1", task__id="patrol")
    stream.say(1.1, "/news", id="a-1", task__id="inspect")
    stream.say(2.0, "/award", auction="a-1", winner="robot1")

    assert taken(stream) == [["robot1", "inspect", "open"]]


def test_an_auction_that_was_never_announced_is_told_of_once_and_gives_nobody_a_task() -> None:
    stream = market()
    stream.say(2.0, "/award", auction="a-1", winner="robot1")
    stream.say(2.5, "/award", auction="patrol", winner="robot1")

    assert taken(stream) == []
    assert [event.text for event in stream.events] == [
        "/award () cannot be read: 'a-1' stands for no task: nothing on /news has named it before"
    ]


def test_a_robot_is_busy_though_nobody_knows_with_which_task() -> None:
    stream = market(busy=(BUSY,), allocated=())
    stream.say(2.0, "/working", robot="robot1", auction="a-1")

    assert [str(event.state) for event in stream.events if event.kind == "robot_state"] == ["busy"]
    assert taken(stream) == []


def test_a_busy_message_that_names_an_auction_allocates_its_task() -> None:
    stream = market(busy=(BUSY,), allocated=())
    stream.say(1.0, "/news", id="a-1", task__id="patrol")
    stream.say(2.0, "/working", robot="robot1", auction="a-1")

    assert taken(stream) == [["robot1", "patrol", "open"]]


def test_a_result_counts_where_its_condition_is_met() -> None:
    stream = market(completed=(DONE,), failed=(FAILED,))
    for auction, task in (("a-1", "patrol"), ("a-2", "inspect"), ("a-3", "report")):
        stream.say(1.0, "/news", id=auction, task__id=task)
        stream.say(1.5, "/award", auction=auction, winner="robot1")
    stream.say(2.0, "/result", auction="a-1", winner="robot1", ok=True)
    stream.say(2.1, "/result", auction="a-2", winner="robot1", ok=False)
    stream.say(2.2, "/result", auction="a-3", winner="robot1", ok=2)

    assert taken(stream) == [
        ["robot1", "patrol", "done"],
        ["robot1", "inspect", "failed"],
        ["robot1", "report", "open"],
    ]
    states = {task.id: task.state for task in stream.supervisor.finish().tasks}
    assert states == {"patrol": TaskState.DONE, "inspect": TaskState.FAILED, "report": TaskState.ALLOCATED}


@pytest.mark.parametrize(
    ("value", "text", "met"),
    [
        (1, "1", True),
        (-3, "-3", True),
        (1, "2", False),
        (1, "true", False),
        (True, "true", True),
        (True, "1", False),
        (False, "false", True),
        ("won", "won", True),
        ("won", "lost", False),
        (1.0, "1.0", False),
        (["won"], "won", False),
    ],
)
def test_a_condition_compares_strings_whole_numbers_and_bools(value: object, text: str, met: bool) -> None:
    assert meets({"field": value}, "field", text) is met
    assert not meets({}, "field", text)


def test_only_the_ids_named_last_are_kept() -> None:
    """A stream of ever new auctions must not fill the memory."""
    table = JoinTable(NEWS)
    for number in range(65_537):
        table.hear(Heard("/news", "", 1.0, {"id": str(number), "task/id": "patrol"}))

    assert table.find("0") == ""
    assert table.find("1") == table.find("65536") == "patrol"
