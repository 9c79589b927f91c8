"""The extension by which perpetual tasks share the time; shares are of the time in which some task was carried out."""

from __future__ import annotations

from typing import Any, Dict, Mapping

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from mrta_alliance.agent import AllianceAgent
from mrta_alliance.fairness import FairShares, quickening
from mrta_alliance.parameters import BehaviourSetParameters

from tests.plugins.mrta_alliance.team import Team, agent, behaviour_set, motivations, nested, step, time_of


def robot(name: str, rates: Mapping[str, float], fairness: float, perpetual: bool = True, **more: Any) -> AllianceAgent:
    sets = [
        behaviour_set(task, rate, 200.0, impatience={"fast_rate": rate, "fairness": fairness})
        for task, rate in rates.items()
    ]
    return agent(name, nested(*sets, **more), list(rates), perpetual=perpetual)


def shares(team: Team, cycles: int) -> Dict[str, float]:
    held = dict.fromkeys(team.tasks, 0)
    for _ in range(cycles):
        team.step()
        for task, holders in team.holders().items():
            held[task] += bool(holders)
    total = sum(held.values())
    return {task: count / total for task, count in held.items()}


def alone(rates: Mapping[str, float], fairness: float, **more: Any) -> Team:
    return Team({"one": robot("one", rates, fairness, **more)}, list(rates))


def test_factor_grows_by_fairness_for_each_turn_that_a_task_is_behind() -> None:
    """1 + 0.5 x 80 s / 40 s = 2."""
    assert quickening(0.5, 80.0, 40.0) == 2.0
    assert quickening(0.0, 80.0, 40.0) == 1.0
    assert quickening(3.0, 0.0, 40.0) == 1.0


def test_without_fairness_the_fastest_set_wins_again_and_again() -> None:
    """As robot2 in the recording of the original nodes: after 89 s inspect (1.25) beats patrol (1.0) each time."""
    assert shares(alone({"patrol": 1.0, "inspect": 1.25}, 0.0), 3000) == {"patrol": 0.0, "inspect": 1.0}


@pytest.mark.parametrize("fairness", [0.3, 1.0, 4.0])
def test_with_fairness_perpetual_tasks_share_one_robot(fairness: float) -> None:
    """1000 s by turns of 40 s: 1.25 to 1.0 is made good by the first turn behind, if 1 + fairness > 1.25."""
    assert shares(alone({"patrol": 1.0, "inspect": 1.25}, fairness), 5000)["patrol"] == pytest.approx(0.5, abs=0.03)


def test_with_fairness_even_a_task_of_a_tenth_of_the_rate_has_its_share() -> None:
    found = shares(alone({"patrol": 0.3, "inspect": 3.0, "report": 1.0}, 2.0), 8000)
    assert found == {task: pytest.approx(1 / 3, abs=0.08) for task in found}


def test_tasks_that_end_are_not_touched_by_fairness() -> None:
    rates = {"patrol": 1.0, "inspect": 1.25}
    assert shares(alone(rates, 1.0, perpetual=False), 3000) == {"patrol": 0.0, "inspect": 1.0}


def test_strict_agent_knows_no_fairness() -> None:
    rates = {"patrol": 1.0, "inspect": 1.25}
    assert shares(alone(rates, 1.0, strict_original=True), 3000) == {"patrol": 0.0, "inspect": 1.0}


def test_two_robots_share_three_perpetual_tasks() -> None:
    """A task that another robot is heard on counts as carried out, so the one that nobody is on comes first."""
    rates = {"patrol": 1.5, "inspect": 1.25, "report": 0.8}
    without, fair = (
        shares(Team({name: robot(name, rates, fairness) for name in ("one", "two")}, list(rates)), 3000)
        for fairness in (0.0, 1.0)
    )
    assert min(without.values()) < 0.05
    assert min(fair.values()) > 0.25


def test_task_that_becomes_applicable_begins_at_the_least() -> None:
    """report comes after 500 s of the others: it is not owed those."""
    kept = FairShares()
    for task in ("patrol", "inspect", "report"):
        kept.follow(BehaviourSetParameters(task, fairness=1.0, giving_up_delay=100.0))
    applicable = {"patrol": True, "inspect": True, "report": False}
    kept.pass_time(300.0, applicable, ["patrol"])
    kept.pass_time(200.0, applicable, ["inspect"])
    assert (kept.factor("patrol"), kept.factor("inspect"), kept.factor("report")) == (1.0, 2.0, 1.0)
    kept.pass_time(0.0, {**applicable, "report": True}, [])
    assert kept.factor("report") == 2.0


@settings(max_examples=10, deadline=None)
@given(st.floats(0.3, 3.0), st.floats(0.3, 3.0), st.floats(0.0, 5.0))
def test_fairness_only_quickens(patrol: float, inspect: float, fairness: float) -> None:
    """So every bound on take-over that the equations give holds with it too."""
    rates = {"patrol": patrol, "inspect": inspect}
    one = robot("one", rates, fairness)
    for cycle in range(1, 300):
        for task, said in motivations(step(one, time_of(cycle))).items():
            assert said["impatience"] >= rates[task]
