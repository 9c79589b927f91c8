"""What the timekeeper tells of hand-made streams; times by hand."""

from __future__ import annotations

from typing import Any, List, Sequence, Tuple

import pytest

from rqt_mrta_py.hooks import (
    ClockOff,
    ClockRight,
    Fact,
    Heard,
    IncidentBoard,
    RuleSetup,
    Subscription,
    TopicHeard,
    TopicSilent,
)
from rqt_mrta_py.model import Evidence, MonitoredTopic
from tests.supervisor.mini import ALLOCATED, BUSY, COMMUNICATION, IDLE, Stream, mission

MOTIVATION = "/robot1/alliance/motivation/patrol"


class Notebook:
    """A rule that writes down what it is told of time."""

    causes = ""

    def __init__(self) -> None:
        self.facts: List[Fact] = []

    def subscriptions(self) -> Sequence[Subscription]:
        return ()

    def hear(self, heard: Heard, board: IncidentBoard) -> None:
        pass

    def notice(self, fact: Fact, board: IncidentBoard) -> None:
        if isinstance(fact, (ClockOff, ClockRight, TopicSilent, TopicHeard)):
            self.facts.append(fact)

    def wake(self, time: float, board: IncidentBoard) -> None:
        pass

    def finish(self, time: float, board: IncidentBoard) -> None:
        pass


def listening(**parts: Any) -> Tuple[Stream, List[Fact]]:
    notebook = Notebook()

    def make(setup: RuleSetup) -> Notebook:
        return notebook

    return Stream(mission(**parts), rules={"notebook": make}), notebook.facts


def test_a_clock_that_is_ahead_is_told_once_with_its_first_message() -> None:
    stream, facts = listening()
    stream.busy(1.0, "robot1", "patrol")
    stream.every(0.5, 2.0, 9.0, lambda time: stream.busy(time, "robot1", "patrol", stamp=time + 5.0))
    stream.finish()
    first, third = Evidence(COMMUNICATION, 2.0, 1), Evidence(COMMUNICATION, 3.0, 3)
    # Half of the timeout of 2.0 s; the third message comes 1.0 s after the first.
    assert facts == [ClockOff(3.0, "robot1", COMMUNICATION, 5.0, 1.0, first, third)]


def test_a_clock_that_is_set_right_is_told_with_the_first_right_message() -> None:
    stream, facts = listening()
    stream.every(0.5, 1.0, 4.0, lambda time: stream.busy(time, "robot1", "patrol", stamp=time + 5.0))
    stream.every(0.5, 4.0, 8.0, lambda time: stream.busy(time, "robot1", "patrol"))
    stream.finish()
    assert facts[1:] == [ClockRight(4.0, "robot1", COMMUNICATION, Evidence(COMMUNICATION, 4.0, 6))]


def test_the_latest_lead_is_told_at_the_end() -> None:
    stream, facts = listening()
    stream.every(0.5, 1.0, 4.0, lambda time: stream.busy(time, "robot1", "patrol", stamp=time - 3.0))
    stream.every(0.5, 4.0, 6.0, lambda time: stream.busy(time, "robot1", "patrol", stamp=time - 3.5))
    stream.finish()
    assert [fact.lead for fact in facts if isinstance(fact, ClockOff)] == [-3.0, -3.5]
    assert facts[-1].time == 5.5


def test_each_robot_is_judged_by_itself_and_strangers_are_not() -> None:
    stream, facts = listening()

    def all_speak(time: float) -> None:
        stream.busy(time, "robot1", "patrol")
        stream.busy(time, "robot2", "inspect", stamp=time + 2.0)
        stream.busy(time, "nobody", "report", stamp=time + 9.0)

    stream.every(0.5, 1.0, 6.0, all_speak)
    stream.finish()
    assert [(fact.robot, fact.lead) for fact in facts if isinstance(fact, ClockOff)] == [("robot2", 2.0)]


@pytest.mark.parametrize("stamp", [0.0, "noon", 7, None, True])
def test_what_is_no_stamp_is_passed_over(stamp: Any) -> None:
    stream, facts = listening()
    fields = {"header__frame_id": "/robot1", "header__stamp": stamp, "task_id": "patrol"}
    stream.every(0.5, 100.0, 104.0, lambda time: stream.say(time, COMMUNICATION, **fields))
    stream.finish()
    assert facts == []


@pytest.mark.parametrize("name", [["robot1"], {"id": "robot1"}, 1.5, None, ""])
def test_what_is_no_name_of_a_robot_is_nobody(name: Any) -> None:
    stream, facts = listening(robots=())
    fields = {"header__frame_id": name, "header__stamp": 1.0, "task_id": "patrol"}
    stream.every(0.5, 100.0, 104.0, lambda time: stream.say(time, COMMUNICATION, **fields))
    stream.finish()
    assert facts == []


def test_a_stamp_is_looked_at_though_the_architecture_names_no_field_of_the_header() -> None:
    plain = MonitoredTopic("/claims", "x/Claim", "robot_id", task_field="task_id", timeout=1.0)
    stream, facts = listening(busy=[plain], idle=[], allocated=[])

    def claim(time: float) -> None:
        stream.say(time, "/claims", robot_id="robot1", task_id="t", header__stamp=time + 0.6)

    stream.every(0.5, 1.0, 3.0, claim)
    stream.finish()
    assert [(fact.robot, fact.topic) for fact in facts if isinstance(fact, ClockOff)] == [("robot1", "/claims")]


def test_a_topic_that_is_busy_and_allocated_is_heard_once() -> None:
    stream, _ = listening(busy=[BUSY], allocated=[ALLOCATED, BUSY])
    wishes = [wish for wish, _ in stream.supervisor.listeners() if wish.optional]
    assert [wish.topic for wish in wishes] == [COMMUNICATION, IDLE.name]


def test_a_gap_is_told_when_it_falls_due_and_ends_with_the_next_message() -> None:
    stream, facts = listening()
    stream.every(0.5, 1.0, 4.0, lambda time: stream.idle(time, "robot1"))
    stream.tick(20.0)
    stream.idle(30.0, "robot1")
    stream.finish()
    assert facts == [
        TopicSilent(5.5, "robot1", IDLE.name, Evidence(MOTIVATION, 3.5, 5), 0.5),
        TopicHeard(30.0, "robot1", IDLE.name, Evidence(MOTIVATION, 30.0, 6)),
    ]


def test_a_message_that_comes_exactly_when_it_is_missed_comes_in_time() -> None:
    stream, facts = listening()
    stream.every(0.5, 1.0, 4.0, lambda time: stream.idle(time, "robot1"))
    stream.idle(5.5, "robot1")
    stream.finish()
    assert facts == []


def test_a_robot_that_speaks_of_one_task_is_not_missed_for_another() -> None:
    stream, facts = listening()
    of_both = [lambda time: stream.idle(time, "robot1", "patrol"), lambda time: stream.idle(time, "robot1", "inspect")]
    stream.every(0.5, 1.0, 4.0, *of_both)
    stream.every(0.5, 4.0, 20.0, lambda time: stream.idle(time, "robot1", "inspect"))
    stream.finish()
    assert facts == []


def test_a_jump_of_years_makes_one_gap() -> None:
    stream, facts = listening()
    stream.every(0.5, 1.0, 4.0, lambda time: stream.idle(time, "robot1"))
    stream.tick(1e9)
    assert stream.supervisor.next_due == float("inf")
    assert [type(fact) for fact in facts] == [TopicSilent]
