from __future__ import annotations

import math
from typing import Any, Dict, List, Sequence, Tuple

import pytest

from rqt_mrta_py.errors import HookError
from rqt_mrta_py.hooks import (
    AllocationSign,
    Fact,
    Heard,
    IncidentBoard,
    RobotHeard,
    RobotStateChanged,
    RuleSetup,
    Subscription,
)
from rqt_mrta_py.model import Evidence, Severity
from tests.supervisor.mini import Signs, Stream, mission


class Probe:
    """A rule that writes down what it is told."""

    def __init__(self, setup: RuleSetup) -> None:
        self.setup = setup
        self.seen: List[Tuple[Any, ...]] = []

    def subscriptions(self) -> Sequence[Subscription]:
        return [Subscription("/news", "", ("value",))]

    def hear(self, heard: Heard, board: IncidentBoard) -> None:
        self.seen.append(("hear", heard.fields["value"]))

    def notice(self, fact: Fact, board: IncidentBoard) -> None:
        self.seen.append(("notice", type(fact).__name__, fact.time))

    def wake(self, time: float, board: IncidentBoard) -> None:
        self.seen.append(("wake", time))

    def finish(self, time: float, board: IncidentBoard) -> None:
        self.seen.append(("finish", time))


def stream_with(rule: type) -> Tuple[Stream, List[Any]]:
    made: List[Any] = []

    def factory(setup: RuleSetup) -> Any:
        made.append(rule(setup))
        return made[-1]

    return Stream(rules={"probe": factory}), made


def test_rule_is_made_from_the_mission_and_told_beginning_facts_messages_and_end() -> None:
    stream, made = stream_with(Probe)
    stream.idle(1.0, "robot1")
    stream.say(2.0, "/news", value=5)
    stream.tick(4.0)
    stream.finish()
    assert made[0].setup.mission == mission()
    assert made[0].seen == [
        ("wake", 1.0),
        ("notice", "RobotHeard", 1.0),
        ("notice", "RobotStateChanged", 1.0),
        ("hear", 5),
        ("notice", "RobotSilent", 3.0),
        ("notice", "RobotStateChanged", 3.0),
        ("finish", 4.0),
    ]


def test_rule_is_woken_when_the_stream_has_passed_the_time_asked_for() -> None:
    class Sleeper(Probe):
        def wake(self, time: float, board: IncidentBoard) -> None:
            super().wake(time, board)
            if time < 3.0:
                board.wake_at(time + 1.0)
                board.wake_at(time + 1.0)

    stream, made = stream_with(Sleeper)
    stream.tick(1.0)
    stream.tick(2.0)
    assert made[0].seen == [("wake", 1.0)]
    stream.tick(9.0)
    assert made[0].seen == [("wake", 1.0), ("wake", 2.0), ("wake", 3.0)]


def test_rule_is_woken_after_what_the_supervisor_derives_for_the_same_time() -> None:
    class Sleeper(Probe):
        def wake(self, time: float, board: IncidentBoard) -> None:
            super().wake(time, board)
            if time == 1.0:
                board.wake_at(3.0)

    stream, made = stream_with(Sleeper)
    stream.idle(1.0, "robot1")
    stream.tick(9.0)
    assert made[0].seen[-2:] == [("notice", "RobotStateChanged", 3.0), ("wake", 3.0)]


class Alarm(Probe):
    """Puts up one incident for each robot while it is busy."""

    def notice(self, fact: Fact, board: IncidentBoard) -> None:
        if isinstance(fact, RobotHeard):
            board.open("heard", Severity.INFO, fact.time, "heard", evidence=[fact.message])
        if isinstance(fact, RobotStateChanged) and fact.after.value == "busy":
            board.open(fact.robot, Severity.WARNING, fact.time, "busy", robots=["z", fact.robot, "z"], tasks=["t"])
            board.open(fact.robot, Severity.ERROR, fact.time + 9, "busy again")
        elif isinstance(fact, RobotStateChanged):
            board.amend(fact.robot, "was busy", [Evidence("/b", 2.0, 0), Evidence("/a", 2.0, 0)])
            board.amend(fact.robot, "was busy", [Evidence("/a", 1.0, 7)])
            board.close(fact.robot, fact.time, evidence=[Evidence("/a", 1.0, 7)])
            board.close(fact.robot, fact.time + 5, "never said")
            board.amend(fact.robot, "never said")


def test_board_keeps_one_incident_for_each_key_until_it_is_closed() -> None:
    stream, _ = stream_with(Alarm)
    stream.busy(1.0, "robot1", "patrol")
    stream.tick(5.0)
    incidents = {each.text: each for each in stream.finish().incidents}
    assert sorted(incidents) == ["heard", "was busy"]
    busy = incidents["was busy"]
    assert (busy.rule, busy.severity, busy.start, busy.end) == ("probe", Severity.WARNING, 1.0, 3.0)
    assert (busy.robots, busy.tasks) == (("robot1", "z"), ("t",))
    assert busy.evidence == (Evidence("/a", 1.0, 7), Evidence("/a", 2.0, 0), Evidence("/b", 2.0, 0))
    assert incidents["heard"].end == 5.0


def test_incidents_are_told_when_they_begin_and_when_they_end() -> None:
    stream, _ = stream_with(Alarm)
    stream.busy(1.0, "robot1", "patrol")
    stream.tick(5.0)
    told = [message.fields for message in stream.supervisor.news() if message.topic == "/mrta/incident"]
    assert [(each["text"], each["header"]["stamp"], each["start"], each["end"]) for each in told] == [
        ("heard", 1.0, 1.0, 0.0),
        ("busy", 1.0, 1.0, 0.0),
        ("was busy", 3.0, 1.0, 3.0),
    ]


def test_incidents_are_listed_by_start_then_rule_whatever_the_order_of_registration() -> None:
    def rules(names: Sequence[str]) -> List[Tuple[float, str]]:
        stream = Stream(rules=dict.fromkeys(names, Alarm))
        stream.busy(1.0, "robot1", "patrol")
        stream.busy(2.0, "robot2", "patrol")
        return [(each.start, each.rule) for each in stream.finish().incidents]

    expected = [(1.0, "a"), (1.0, "a"), (1.0, "b"), (1.0, "b"), (2.0, "a"), (2.0, "b")]
    assert rules(["a", "b"]) == rules(["b", "a"]) == expected


def fails(*args: Any) -> None:
    raise KeyError("robot9")


@pytest.mark.parametrize(
    ("method", "where"),
    [
        ("wake", "woken at 1.0"),
        ("notice", "noticing RobotHeard(time=1.0, robot='robot1', message=Evidence("),
        ("hear", "hearing /news"),
        ("finish", "finishing"),
    ],
)
def test_rule_that_raises_stops_supervision_and_is_named(method: str, where: str) -> None:
    stream, _ = stream_with(type("Broken", (Probe,), {method: fails}))

    def run() -> None:
        stream.odom(1.0, "robot1")
        stream.say(2.0, "/news", value=1)
        stream.finish()

    with pytest.raises(HookError) as caught:
        run()
    assert str(caught.value).startswith(f"incident rule probe: KeyError: 'robot9', {where}")


@pytest.mark.parametrize(("method", "where"), [("__init__", "being made"), ("subscriptions", "subscribing")])
def test_rule_that_cannot_even_begin_is_named(method: str, where: str) -> None:
    with pytest.raises(HookError) as caught:
        stream_with(type("Broken", (Probe,), {method: fails}))
    assert str(caught.value) == f"incident rule probe: KeyError: 'robot9', {where}"


def test_rule_that_would_never_sleep_again_is_stopped() -> None:
    class Restless(Probe):
        def wake(self, time: float, board: IncidentBoard) -> None:
            board.wake_at(time)

    stream, _ = stream_with(Restless)
    with pytest.raises(HookError, match=r"wake_at\(1.0\) within wake\(1.0\); ask for a later time"):
        stream.tick(1.0)


def test_interpreter_that_raises_is_named() -> None:
    class Broken:
        def subscriptions(self) -> Sequence[Subscription]:
            return [Subscription("/signs")]

        hear = fails

    stream = Stream(interpreter=Broken())
    with pytest.raises(HookError, match="interpreter of mrta_mini: KeyError: 'robot9', hearing /signs"):
        stream.say(1.0, "/signs")


def test_interpreter_that_cannot_say_what_to_hear_is_named() -> None:
    class Broken:
        subscriptions = fails

        def hear(self, heard: Heard) -> Sequence[AllocationSign]:
            return ()

    with pytest.raises(HookError, match="interpreter of mrta_mini: KeyError: 'robot9', subscribing"):
        Stream(interpreter=Broken())


def test_interpreter_that_answers_nothing_at_all_is_named() -> None:
    class Silent(Signs):
        def hear(self, heard: Heard) -> Any:
            return None

    stream = Stream(interpreter=Silent())
    with pytest.raises(HookError, match=r"interpreter of mrta_mini: TypeError: .*, hearing /signs"):
        stream.say(1.0, "/signs")


def test_statistic_that_raises_is_named() -> None:
    broken: Dict[str, Any] = {"odd": fails}
    stream = Stream(statistics=broken)
    with pytest.raises(HookError, match="statistic odd: KeyError: 'robot9'"):
        stream.finish()


@pytest.mark.parametrize("value", [{"robot1"}, math.nan, {"robot1": [math.inf]}, {(1, 2): 3}, object()])
def test_statistic_that_no_summary_can_hold_is_named(value: object) -> None:
    stream = Stream(statistics={"odd": lambda record: value})
    with pytest.raises(HookError, match=r"statistic odd: its value is no plain JSON .*; accepted: finite numbers"):
        stream.finish()
