"""Algorithm 2: what a robot would do next, by the worked example and where Eq. 1 says nothing."""

from __future__ import annotations

import math
from typing import List

import numpy as np
import pytest
from mrta_demir_cf.agent import DemirCfAgent
from mrta_demir_cf.message_kinds import Kind

from rqt_mrta_py.hooks import AgentSetup, Situation
from rqt_mrta_py.model import Pose, Progress, Task
from tests.plugins.mrta_demir_cf.script import Script, kinds

EXAMPLE = {"t1": (-2.0, 0.0), "t2": (1.0, 0.0), "t3": (6.0, 0.0)}


@pytest.mark.parametrize(("cost", "first"), [("uem", "t1"), ("eyh", "t2")])
def test_worked_example(cost: str, first: str) -> None:
    """Costs by Eq. 3: 1.2, 1.8, 3.6; by Eq. 2: 2, 1, 6."""
    (request,) = Script(EXAMPLE, cost=cost).wait(1.5)
    assert request.task == first
    assert request.cost == {"t1": 2.0, "t2": 1.0}[first]


def test_cost_that_a_behaviour_cannot_tell_counts_as_very_dear_and_none_at_all_as_impossible() -> None:
    script = Script(EXAMPLE)
    script.costs.update(t1=None, t2=math.inf, t3=999.0)
    assert [message.task for message in script.wait(1.5)] == ["t3"]
    script = Script(EXAMPLE)
    script.costs.update(t1=None, t2=math.inf, t3=math.inf)
    (request,) = script.wait(1.5)
    assert (request.task, request.cost) == ("t1", 1000.0)


def test_robot_that_does_not_know_where_it_is_requests_nothing() -> None:
    setup = AgentSetup("b", ("b",), (Task("t", "visit"),), {"rate": 2.0}, np.random.default_rng(0))
    agent = DemirCfAgent(setup)
    for number in range(1, 9):
        decision = agent.step(Situation(0.5 * number, (), (), {"t": True}, lambda task: 0.0, None))
        assert decision.task is None
    assert agent.mind.mine is None


def test_task_that_is_done_anywhere_is_where_the_robot_is() -> None:
    setup = AgentSetup(
        "b", ("b",), (Task("t", "visit"), Task("u", "visit", Pose(1.0, 0.0))), {}, np.random.default_rng(0)
    )
    agent = DemirCfAgent(setup)
    for number in range(1, 26):
        decision = agent.step(
            Situation(0.1 * number, (), (), {"t": True, "u": True}, {"t": 0.0, "u": 1.0}.__getitem__, Pose(0.0, 0.0))
        )
    assert decision.task == "t"


def test_task_for_several_robots_that_appears_is_left_alone() -> None:
    script = Script({})
    script.applicable["lift"] = True
    script.costs["lift"] = 1.0
    script.step(reports=[script.report("lift", Progress.APPEARED, definition=Task("lift", "visit", robots=2))])
    assert script.wait(5.0) == []


def test_of_two_robots_at_one_depot_the_smaller_id_goes_first() -> None:
    script = Script({"t": (4.0, 0.0)})
    script.step(script.hello("c", (0.0, 0.0)))
    assert kinds(script.wait(1.0, "c")) == [Kind.REQUEST]
    script = Script({"t": (4.0, 0.0)})
    script.step(script.hello("a", (0.0, 0.0)))
    assert script.wait(3.0, "a") == []


def test_offer_is_not_repeated_before_long_and_something_else_is_done_meanwhile() -> None:
    script = Script({"t": (4.0, 0.0), "u": (0.0, 6.0)}, exchange=True)
    script.step(script.execution("a", "t", 5.0))
    said = script.wait(5.0)
    assert [(message.kind, message.task) for message in said][:2] == [(Kind.EXCHANGE, "t"), (Kind.REQUEST, "u")]
    assert kinds(said).count(Kind.EXCHANGE) == 1


@pytest.mark.parametrize(
    ("looks_ahead", "objective", "requests"), [(True, "time", ["t"]), (False, "time", []), (True, "path", [])]
)
def test_robot_that_looks_ahead_takes_what_it_reaches_before_a_busy_neighbour(
    looks_ahead: bool, objective: str, requests: List[str]
) -> None:
    """a is 1 m from t but goes to z first, 9 m and as far back; from b it is 4 m. To u a is on its way."""
    script = Script({"t": (4.0, 0.0), "z": (13.0, 1.0), "u": (15.0, 1.0)}, looks_ahead=looks_ahead, objective=objective)
    script.step(script.execution("a", "z", 9.0, (4.0, 1.0)))
    said = script.wait(2.0, "a")
    assert [message.task for message in said if message.kind is Kind.REQUEST] == requests


def test_robot_that_imagines_its_route_begins_with_the_near_end_of_it() -> None:
    """t2, t1, t3 is 12 m; t1, t2, t3 is 10 m, and what UEM finds as well; the request tells the way to t1."""
    (request,) = Script(EXAMPLE, cost="rollout", objective="path").wait(1.5)
    assert (request.task, request.cost) == ("t1", 2.0)


def test_robot_that_imagines_leaves_to_its_neighbour_what_that_one_passes_by() -> None:
    """t is 4 m away, and 5 m from a, which goes to u beyond it in any case."""
    places = {"t": (0.0, 4.0), "u": (0.0, 3.0), "v": (0.0, -2.0)}
    script = Script(places, cost="rollout", objective="path")
    script.step(script.hello("a", (0.0, 9.0)))
    (request,) = script.wait(1.0)
    assert request.task == "v"


def test_robot_that_imagines_passes_over_idle_neighbours_like_others() -> None:
    script = Script({"t": (4.0, 0.0)}, cost="rollout")
    script.step(script.hello("a", (4.0, 1.0)))
    assert kinds(script.wait(9.0, "a"))[0] is Kind.REQUEST


def test_greedy_robot_takes_what_costs_it_least_whoever_is_nearer() -> None:
    """By Eq. 1 t is left to a, which is nearer to it; so is u, and the robot waits for its turn."""
    places = {"t": (4.0, 0.0), "u": (5.0, 0.0)}
    script = Script(places, cost="greedy")
    script.costs.update(t=5.0, u=4.5)
    script.step(script.hello("a", (4.0, 1.0)))
    (request,) = script.wait(1.0)
    assert (request.task, request.cost) == ("u", 4.5)
    script = Script(places, cost="eyh")
    script.step(script.hello("a", (4.0, 1.0)))
    assert script.wait(1.0) == []
