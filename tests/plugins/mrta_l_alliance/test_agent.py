"""Agents, stepped by hand and in missions without a world."""

from __future__ import annotations

from typing import Any, Dict, List, Mapping, Sequence

import numpy as np
import pytest
from mrta_alliance.agent import AllianceAgent
from mrta_l_alliance.agent import LAllianceAgent
from mrta_l_alliance.memory import Memory, Performance

from rqt_mrta_py.hooks import AgentSetup, Decision, Situation, TaskReport
from rqt_mrta_py.model import Progress, Task
from tests.plugins.mrta_alliance.team import announced
from tests.plugins.mrta_l_alliance.errands import (
    ErrandMission,
    Errands,
    behaviour_sets,
    heterogeneous,
    learning,
)

TASKS = ("dig", "fill")
KNOWN = Memory(
    {
        ("r1", "dig"): Performance((20.0,)),
        ("r2", "dig"): Performance((60.0,)),
        ("r1", "fill"): Performance((40.0,)),
        ("r2", "fill"): Performance((10.0,)),
    }
)


def setup_of(robot: str, parameters: Mapping[str, Any], tasks: Sequence[Task]) -> AgentSetup:
    return AgentSetup(robot, ("r1", "r2"), tuple(tasks), parameters, np.random.default_rng(0), {})


def agent(memory: Memory, phase: str = "adaptive", robot: str = "r1", **told: Any) -> LAllianceAgent:
    """Make an agent for a digger and a filler; without a least spread, so that task times are the means."""
    group = learning(phase, memory, least_spread=0.0, **told)
    tasks = [Task(name, "errand") for name in TASKS]
    return LAllianceAgent(setup_of(robot, {**behaviour_sets(TASKS), **group}, tasks))


def step(who: LAllianceAgent, now: float, heard: Sequence[Any] = (), reports: Sequence[TaskReport] = ()) -> Decision:
    return who.step(Situation(now, heard, reports, dict.fromkeys(TASKS, True), lambda task: None))


def said(decision: Decision, type_name: str) -> List[Mapping[str, Any]]:
    return [message.fields for message in decision.messages if message.type == type_name]


def motivations(decision: Decision) -> Dict[str, Mapping[str, Any]]:
    return {fields["task_id"]: fields for fields in said(decision, "alliance_msgs/Motivation")}


def run(who: LAllianceAgent, begin: float, end: float) -> Decision:
    """Step from a time up to before another, five times a second."""
    cycles = round((end - begin) * 5)
    for cycle in range(cycles):
        decision = step(who, begin + cycle / 5)
    return decision


def test_without_knowledge_a_robot_does_and_says_what_it_does_under_alliance() -> None:
    """Beyond that it only tells, once, that it knows nothing."""
    tasks = [Task(name, "errand") for name in TASKS]
    learner, plain = agent(Memory()), AllianceAgent(setup_of("r1", behaviour_sets(TASKS), tasks))
    for cycle in range(60):
        situation = Situation(1.0 + cycle / 5, (), (), dict.fromkeys(TASKS, True), lambda task: None)
        ours, theirs = learner.step(situation), plain.step(situation)
        assert ours.task == theirs.task
        memories = [message for message in ours.messages if message.topic == "l_alliance/memory"]
        assert [message for message in ours.messages if message not in memories] == list(theirs.messages)
        assert len(memories) == (1 if cycle == 0 else 0)


def test_a_robot_takes_what_it_is_best_at_after_the_shortest_delay() -> None:
    """Head start 1.5 for the first of the team: 1 s of delay is 5 / 1.5 cycles, so 4; the fourth is at 1.6 s."""
    one = agent(KNOWN)
    assert run(one, 1.0, 1.6).task is None
    assert step(one, 1.6).task == "dig"


def test_what_another_is_better_at_waits_for_boredom() -> None:
    """r1 has dug; idle since 3.0 s. It needs 40 s for what r2 does in 10 s, so it waits 30 s; r2 might come free."""
    one = agent(KNOWN)
    run(one, 1.0, 3.0)
    step(one, 3.0, reports=[TaskReport("dig", Progress.DONE, "", "r1")])
    waiting = run(one, 3.2, 33.0)
    assert motivations(waiting)["fill"]["motivation"] == 0.0
    assert motivations(step(one, 33.0))["fill"]["motivation"] > 0.0
    assert run(one, 33.2, 38.0).task == "fill"


def test_a_rival_that_fell_silent_on_a_task_is_waited_for_no_longer() -> None:
    """r2 is heard filling for the last time at 2 s, and silent for more than 3 s at 5.2 s."""
    one = agent(KNOWN)
    run(one, 1.0, 2.0)
    step(one, 2.0, [announced("r2", "fill", 2.0)])
    run(one, 2.2, 3.0)
    step(one, 3.0, reports=[TaskReport("dig", Progress.DONE, "", "r1")])
    assert motivations(run(one, 3.2, 5.2))["fill"]["motivation"] == 0.0
    assert motivations(step(one, 5.2))["fill"]["motivation"] > 0.0


def test_an_operators_order_does_not_wait_for_boredom() -> None:
    one = agent(KNOWN)
    step(one, 1.0)
    assert step(one, 1.2, reports=[TaskReport("fill", Progress.REASSIGNED, "", "r1")]).task == "fill"
    assert step(one, 1.4).task == "fill"


def test_motivation_for_anothers_task_reaches_the_threshold_when_the_other_should_be_done() -> None:
    """r2 is known to need 60 s for digging, is first heard at 1 s and resets r1's motivation in that cycle.

    60 s at 5 Hz are 300 cycles, at 1.5 times the rate 200: at 41 s, or a cycle later where 200 times 0.15 is below 30.
    """
    tasks = [Task("dig", "errand")]
    parameters = {**behaviour_sets(["dig"]), **learning("adaptive", KNOWN, least_spread=0.0)}
    one = LAllianceAgent(setup_of("r1", parameters, tasks))
    begun = None
    for cycle in range(250):
        now = 1.0 + cycle / 5
        heard = [announced("r2", "dig", now, expected=7.0)] if cycle % 2 == 0 else []
        if begun is None and one.step(Situation(now, heard, (), {"dig": True}, lambda task: None)).task == "dig":
            begun = now
    assert begun in (pytest.approx(41.0), pytest.approx(41.2))


def test_what_a_robot_learns_it_says_latched() -> None:
    one = agent(Memory())
    (first,) = [message for message in step(one, 1.0).messages if message.topic == "l_alliance/memory"]
    assert (first.latched, first.fields["robots"]) == (True, ())
    for cycle in range(1, 100):
        step(one, 1.0 + cycle / 5, [announced("r2", "dig", 1.0 + cycle / 5)])
    done = step(one, 21.0, reports=[TaskReport("dig", Progress.DONE, "", "r2")])
    (fields,) = said(done, "mrta_l_alliance_msgs/Memory")
    assert (fields["robots"], fields["tasks"], fields["trials"], fields["failures"]) == (("r2",), ("dig",), (1,), (0,))
    assert fields["times"] == pytest.approx((19.8,))
    assert fields["task_times"] == pytest.approx((19.8,))


def test_a_robot_learns_its_own_times_too() -> None:
    one = agent(KNOWN)
    run(one, 1.0, 11.6)
    step(one, 11.6, reports=[TaskReport("dig", Progress.DONE, "", "r1")])
    assert one.memory.of("r1", "dig").times == pytest.approx((20.0, 10.0))


def test_perpetual_tasks_are_left_to_alliance() -> None:
    known = Memory({("r2", "guard"): Performance((10.0,))})
    parameters = {**behaviour_sets(["guard"]), **learning("adaptive", known)}
    one = LAllianceAgent(setup_of("r1", parameters, [Task("guard", "errand", perpetual=True)]))
    decision = one.step(Situation(1.0, (), (), {"guard": True}, lambda task: None))
    assert motivations(decision)["guard"]["impatience"] == 1.5


def test_a_task_that_appears_is_learned_of_like_the_others() -> None:
    one = agent(KNOWN)
    step(one, 1.0)
    rows = [TaskReport("pave", Progress.APPEARED, "", None, Task("pave", "errand"))]
    applicable = dict.fromkeys((*TASKS, "pave"), True)
    one.step(Situation(1.2, (), rows, applicable, lambda task: None))
    one.step(Situation(1.4, [announced("r2", "pave", 1.4)], (), applicable, lambda task: None))
    done = [TaskReport("pave", Progress.DONE, "", "r2")]
    one.step(Situation(2.4, (), done, applicable, lambda task: None))
    assert one.memory.of("r2", "pave").times == pytest.approx((1.0,))


@pytest.mark.parametrize("phase", ["active", "adaptive"])
def test_equal_seeds_give_equal_missions(phase: str) -> None:
    errands = heterogeneous(2, 4)
    parameters = {
        robot: {**behaviour_sets(list(errands.places)), **learning(phase, Memory())} for robot in errands.starts
    }
    first, second = (ErrandMission(errands, parameters, 5) for _ in range(2))
    assert first.run() == second.run()
    assert first.spells == second.spells


def test_with_one_robot_left_alive_everything_is_done() -> None:
    """The two that are lost are the best at two thirds of the tasks."""
    errands = heterogeneous(3, 4, 2.0)
    known = Memory({pair: Performance((time + 10.0,) * 3) for pair, time in errands.work.items()})
    for survivor in errands.starts:
        parameters = {
            robot: {**behaviour_sets(list(errands.places)), **learning("adaptive", known)} for robot in errands.starts
        }
        mission = ErrandMission(errands, parameters, 1)
        mission.stopped = {robot: 10.0 for robot in errands.starts if robot != survivor}
        assert mission.run(900.0) < 900.0
        assert {spell.robot for spell in mission.spells if spell.outcome == "done"} == {survivor}


def test_a_robot_that_has_become_slow_is_relieved_and_its_times_are_learned_anew() -> None:
    """robot0 used to dig in 20 s and now never ends; robot1, known to need 40 s, takes over and digs it."""
    errands = Errands(
        {"robot0": (0.0, 0.0), "robot1": (0.0, 0.0)},
        {"robot0": 1.0, "robot1": 1.0},
        {"dig": (0.0, 0.0)},
        {("robot0", "dig"): 1e6, ("robot1", "dig"): 40.0},
        spread=0.0,
    )
    known = Memory({("robot0", "dig"): Performance((20.0,) * 3), ("robot1", "dig"): Performance((40.0,) * 3)})
    parameters = {robot: {**behaviour_sets(["dig"]), **learning("adaptive", known)} for robot in errands.starts}
    mission = ErrandMission(errands, parameters, 1)
    assert mission.run(200.0) < 100.0
    after = mission.agents["robot1"]
    assert isinstance(after, LAllianceAgent)
    performance = after.memory.of("robot0", "dig")
    assert (performance.failures, performance.times[:3]) == (1, (20.0, 20.0, 20.0))
    assert performance.times[3] > 25.0
