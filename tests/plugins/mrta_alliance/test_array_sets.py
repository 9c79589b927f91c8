"""Many behaviour sets evaluated at once give the results of evaluating them set by set, bit for bit."""

from __future__ import annotations

import struct
from dataclasses import replace
from typing import Any, List, Mapping, Optional, Sequence, Tuple

import numpy as np
from hypothesis import given, settings
from hypothesis import strategies as st
from mrta_alliance.agent import AllianceAgent

from rqt_mrta_py.hooks import AgentSetup, Heard, Outgoing, OutgoingRows, Situation, TaskReport
from rqt_mrta_py.model import Progress, Task
from tests.plugins.mrta_alliance.team import announced, behaviour_set, nested, one_by_one

TASKS = tuple(f"task{number}" for number in range(6))
LATER = "later"
TEAM = ("one", "two", "three", "four")

# Slow and fast sets, short and long delays: ties, yielding, giving up and take-over all come up within seconds.
SETS = [
    behaviour_set("task0", 10.0, 9.0),
    behaviour_set("task1", 10.0, 60.0, acquiescence={"yielding_delay": 1.0, "giving_up_delay": 3.0}),
    behaviour_set("task2", 7.5, 4.5, impatience={"fast_rate": 7.5, "head_start": 0.3}),
    behaviour_set("task3", 7.3, 60.0, acquiescence={"yielding_delay": 0.0, "giving_up_delay": 1.5}),
    behaviour_set("task4", 0.1, 400.0),
    behaviour_set("task5", 30.0, 2.0, acquiescence={"yielding_delay": 0.5, "giving_up_delay": 0.7}),
]

announcement = st.tuples(
    st.sampled_from([*TEAM, "stranger", ""]),
    st.sampled_from([*TASKS, LATER, "unknown"]),
    st.one_of(st.just(0.0), st.floats(0.0, 5.0)),
    st.sampled_from([60.0, 5.0, 2.5, 0.7, 0.0, -1.0, float("nan"), 1e9]),
)
report = st.builds(
    TaskReport,
    st.sampled_from([*TASKS, "unknown"]),
    st.sampled_from(list(Progress)),
    robot=st.sampled_from([None, "one", "two"]),
)
appearance = st.just(TaskReport(LATER, Progress.APPEARED, definition=Task(LATER, "anything")))
moment = st.tuples(
    st.one_of(st.just(0.2), st.sampled_from([5e-7, 0.1, 0.5, 2.0]), st.floats(0.01, 3.0)),
    st.lists(announcement, max_size=4),
    st.lists(st.one_of(report, report, report, appearance), max_size=1),
    st.lists(st.sampled_from(TASKS), max_size=2),
)
retuned = st.sampled_from([None, None, None, *range(len(TASKS))])


def agent(many: int, **rates: Any) -> AllianceAgent:
    later = (Task(LATER, "anything"),) if rates.pop("with_later", False) else ()
    tasks = tuple(Task(task, "anything") for task in TASKS)
    setup = AgentSetup("one", TEAM, tasks, nested(*SETS, **rates), np.random.default_rng(0), later_tasks=later)
    return AllianceAgent(setup, many)


def exactly(value: Any) -> Any:
    """Give a value such that floats are equal only with the same bits, and NaN equals itself."""
    if isinstance(value, float):
        return struct.pack("<d", value)
    if isinstance(value, Mapping):
        return {name: exactly(item) for name, item in value.items()}
    if isinstance(value, (list, tuple)):
        return [exactly(item) for item in value]
    return (type(value), value)


def situation(
    now: float,
    spoken: Sequence[Tuple[str, str, float, float]],
    reports: Sequence[TaskReport],
    impossible: Sequence[str],
) -> Situation:
    heard: List[Heard] = [announced(robot, task, now - age, expected) for robot, task, age, expected in spoken]
    applicable = {task: task not in impossible for task in (*TASKS, LATER)}
    return Situation(now, heard, reports, applicable, lambda task: None)


def assert_equal_lives(
    moments: Sequence[Any], start: float, retunes: Sequence[Optional[int]] = (), **rates: Any
) -> Tuple[AllianceAgent, AllianceAgent]:
    readable, at_once = agent(1000, **rates), agent(1, **rates)
    now = start
    for cycle, (passed, spoken, reports, impossible) in enumerate(moments):
        now += passed
        told = situation(now, spoken, reports, impossible)
        expected, found = readable.step(told), at_once.step(told)
        assert found.task == expected.task
        assert exactly(one_by_one(found.messages)) == exactly(one_by_one(expected.messages))
        retune = retunes[cycle] if cycle < len(retunes) else None
        if retune is not None:
            for each in (readable, at_once):
                fast = {"task_expected_duration": 9.0, "threshold": 20.0, "fast_rate": 5.0 + cycle % 7}
                each.retune(replace(each.behaviour_sets[TASKS[retune]], giving_up_delay=4.0, **fast))
    return readable, at_once


@settings(max_examples=60, deadline=None)
@given(st.lists(moment, max_size=60), st.sampled_from([0.0, 1.0, 1.6e9]), st.lists(retuned, max_size=60))
def test_both_forms_say_and_do_the_same_whatever_happens(moments: list, start: float, retunes: list) -> None:
    """Also about zero and in the years since 1970, with parameters changed and behaviour sets added on the way."""
    readable, at_once = assert_equal_lives(moments, start, retunes, with_later=True)
    assert at_once.hazards == readable.hazards


usual = st.tuples(
    st.sampled_from([*TEAM, "stranger"]),
    st.sampled_from(TASKS),
    st.sampled_from([0.0, 0.0, 0.3, 1.0]),
    st.sampled_from([60.0, 60.0, 12.0, 5.0, 2.5]),
)
quiet_moment = st.tuples(
    st.sampled_from([0.1, 0.2, 0.5, 2.5]),
    st.lists(usual, max_size=6),
    st.just([]),
    st.lists(st.just("task5"), max_size=1),
)


@settings(max_examples=40, deadline=None)
@given(st.lists(quiet_moment, max_size=80), st.sampled_from([0.0, 1.0, 1.6e9]))
def test_both_forms_do_the_same_as_long_as_there_are_announcements_only(moments: list, start: float) -> None:
    """Then histories are not asked for a long time."""
    assert_equal_lives(moments, start)


@settings(max_examples=15, deadline=None)
@given(st.lists(moment, max_size=40))
def test_both_forms_do_the_same_with_a_low_level_node(moments: list) -> None:
    """Which tells, in this mission, of nothing: then nothing is applicable, and feedback is not said."""
    assert_equal_lives(moments, 1.0, low_level_feedback=True)


def test_both_forms_do_the_same_with_what_was_heard_at_zero() -> None:
    """Equation 3.3 passes over a message at 0 s; at 6 s the one at 2 s is not yet 5 s old, and task0 grows slowly."""
    spoken = [[("two", "task0", 1.0, 5.0)], *[[("two", "task0", 0.0, 5.0)]] * 8]
    assert_equal_lives([(1.0, each, [], []) for each in spoken], 0.0)


def test_at_once_the_earlier_of_two_that_reach_the_threshold_together_wins() -> None:
    """task0 and task1 grow by 10, task5 by 30 to 30: it begins in cycle 1; task0 and task1 never grow while it goes on.

    task5 gives up after more than 0.7 s, in cycle 5 (0.8 s); nothing before it is free in that cycle, and of those
    after it there is none.
    """
    who = agent(1, head_start=0.0)
    held = []
    for cycle in range(9):
        said = who.step(situation(1.0 + 0.2 * cycle, (), (), ()))
        held.append(said.task)
    assert held == ["task5", "task5", "task5", "task5", None, "task5", "task5", "task5", "task5"]


def test_at_once_a_change_is_known_to_the_next_set_in_the_same_cycle() -> None:
    """task2 alone is possible and begins; when it becomes impossible, sets after it are free at once, before it not."""
    who = agent(1)
    others = [task for task in TASKS if task != "task2"]
    for cycle in range(4):
        decision = who.step(situation(1.0 + 0.2 * cycle, (), (), others))
    assert decision.task == "task2"
    rows = who.step(situation(1.8, (), (), ("task2",))).messages[0]
    assert isinstance(rows, OutgoingRows)
    # task3 and task4 grow by 7.3 and 0.1; task5 reaches its threshold of 30 in one step.
    assert rows.columns["suppressed"].tolist() == [True, True, False, False, False, False]
    assert rows.columns["motivation"].tolist() == [0.0, 0.0, 0.0, 7.3, 0.1, 30.0]


def test_a_robot_of_a_large_team_that_has_no_behaviour_sets_hears_on_and_does_nothing() -> None:
    setup = AgentSetup("one", tuple(f"robot{number}" for number in range(99)), (), nested(), np.random.default_rng(0))
    decision = AllianceAgent(setup).step(Situation(1.0, [announced("two", "x", 1.0)], (), {}, lambda task: None))
    assert decision.task is None
    assert [message.topic for message in decision.messages] == ["alliance/time_to_activation"]


def test_few_sets_of_few_robots_and_what_departs_from_the_equations_go_set_by_set() -> None:
    """Six sets of one of four robots make ten."""
    fair = nested(behaviour_set("task0", impatience={"fast_rate": 1.0, "fairness": 1.0}), SETS[1])
    tasks = tuple(Task(task, "anything", perpetual=True) for task in TASKS[:2])
    found = {
        "fair": AllianceAgent(AgentSetup("one", TEAM, tasks, fair, np.random.default_rng(0)), 2),
        "strict": agent(2, strict_original=True),
        "few": agent(11),
        "many": agent(10),
    }
    first = {name: type(who.step(situation(1.0, (), (), ())).messages[0]) for name, who in found.items()}
    assert first == {"fair": Outgoing, "strict": Outgoing, "few": Outgoing, "many": OutgoingRows}
