"""Teams of agents: who carries out what, and what makes it change."""

from __future__ import annotations

from typing import Dict, List

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from rqt_mrta_py.hooks import Situation, TaskReport
from rqt_mrta_py.model import Progress, Task
from tests.plugins.nearest_robot.team import Team, agent, bid, own_bid, step, team_of

T, U, V = (Task(name, "any") for name in "tuv")


def test_nobody_begins_before_all_could_be_heard() -> None:
    team = team_of({"a": {"t": 5.0}, "b": {"t": 2.0}}, [T])
    assert team.step() == {"a": None, "b": None}
    assert team.step() == {"a": None, "b": "t"}


def test_nearest_robot_takes_each_task() -> None:
    team = team_of({"a": {"t": 5.0, "u": 1.0}, "b": {"t": 2.0, "u": 9.0}, "c": {"t": 3.0, "u": 3.0}}, [T, U])
    assert team.step(2) == {"a": "u", "b": "t", "c": None}


def test_optimal_allocator_is_chosen_by_parameter() -> None:
    costs = {"a": {"t": 1.0, "u": 2.0}, "b": {"t": 3.0, "u": 10.0}}
    assert team_of(costs, [T, U]).step(2) == {"a": "t", "b": "u"}
    assert team_of(costs, [T, U], allocator="nearest_robot/optimal").step(2) == {"a": "u", "b": "t"}


def test_allocator_that_nobody_registers_is_refused_with_those_that_there_are() -> None:
    with pytest.raises(ValueError, match="nobody registers 'x'; there are: nearest_robot/nearest, nearest_robot/optim"):
        agent("a", [T], allocator="x")


def test_task_changes_hands_only_for_more_than_keep() -> None:
    team = team_of({"a": {"t": 5.0}, "b": {"t": 9.0}}, [T], keep=2.0)
    assert team.step(2) == {"a": "t", "b": None}
    team.costs["b"]["t"] = 3.5
    assert team.step(5) == {"a": "t", "b": None}
    team.costs["b"]["t"] = 2.5
    assert team.step(2) == {"a": None, "b": "t"}


def test_task_that_costs_nobody_anything_goes_to_the_first_and_stays() -> None:
    """Perpetual tasks begin where the robot is."""
    patrol = Task("patrol", "any", perpetual=True)
    team = team_of({"a": {"patrol": 0.0}, "b": {"patrol": 0.0}}, [patrol])
    for _ in range(20):
        held = team.step()
    assert held == {"a": "patrol", "b": None}


def test_robot_that_falls_silent_is_replaced_after_the_timeout() -> None:
    """Last heard in cycle 11 (its bid of cycle 10), 1 s is five cycles: it counts up to cycle 16."""
    team = team_of({"a": {"t": 1.0}, "b": {"t": 5.0}}, [T], timeout=1.0)
    team.step(10)
    team.stopped.append("a")
    assert team.step(6) == {"b": None}
    assert team.step() == {"b": "t"}


def test_robot_that_returns_listens_before_it_takes_anything() -> None:
    team = team_of({"a": {"t": 4.5}, "b": {"t": 5.0}}, [T], timeout=1.0)
    team.step(10)
    team.stopped.append("a")
    team.step(30)
    team.stopped.clear()
    assert team.step() == {"a": None, "b": "t"}
    assert team.step(10) == {"a": None, "b": "t"}


def test_task_ends_for_all_when_anybody_says_that_it_is_done() -> None:
    team = team_of({"a": {"t": 1.0}, "b": {"t": 5.0, "u": 6.0}}, [T, U])
    team.step(2)
    team.tell(TaskReport("t", Progress.DONE, robot="a"))
    assert team.step(5) == {"a": None, "b": "u"}
    assert own_bid(team.decisions["a"])["task_ids"] == ()


def test_task_that_is_withdrawn_comes_back_when_it_appears_again() -> None:
    team = team_of({"a": {"t": 1.0}}, [T])
    team.step(2)
    team.tell(TaskReport("t", Progress.WITHDRAWN))
    assert team.step(2) == {"a": None}
    team.tell(TaskReport("t", Progress.APPEARED))
    assert team.step(2) == {"a": "t"}


def test_later_task_is_taken_once_it_is_applicable() -> None:
    team = team_of({"a": {}}, [], [T])
    assert team.step(3) == {"a": None}
    team.tell(TaskReport("t", Progress.APPEARED))
    team.costs["a"]["t"] = 3.0
    assert team.step(2) == {"a": "t"}


def test_task_that_nobody_knew_is_taken_by_its_definition() -> None:
    team = team_of({"a": {}, "b": {}, "c": {}}, [])
    team.step()
    team.tell(TaskReport("t", Progress.APPEARED, definition=Task("t", "any", robots=2)))
    for cost, robot in enumerate("abc"):
        team.costs[robot]["t"] = 9.0 - cost
    assert team.step(2) == {"a": None, "b": "t", "c": "t"}


def test_operator_gives_a_task_to_another_robot_and_it_stays_there() -> None:
    team = team_of({"a": {"t": 1.0}, "b": {"t": 50.0}}, [T])
    team.step(2)
    team.tell(TaskReport("t", Progress.REASSIGNED, robot="b"))
    assert team.step() == {"a": None, "b": "t"}
    assert team.step(50) == {"a": None, "b": "t"}


def test_operator_may_change_his_mind() -> None:
    team = team_of({"a": {"t": 1.0, "u": 9.0}, "b": {"t": 50.0, "u": 50.0}}, [T, U])
    team.step(2)
    team.tell(TaskReport("t", Progress.REASSIGNED, robot="b"))
    assert team.step() == {"a": "u", "b": "t"}
    assert team.step(9) == {"a": "u", "b": "t"}
    team.tell(TaskReport("t", Progress.REASSIGNED, robot="a"))
    assert team.step() == {"a": "t", "b": "u"}
    assert team.step(9) == {"a": "t", "b": "u"}


def test_robot_that_missed_an_order_follows_the_bid_of_whom_it_names() -> None:
    team = team_of({"a": {"t": 1.0}, "b": {"t": 50.0}}, [T])
    team.step(2)
    team.reports["b"].append(TaskReport("t", Progress.REASSIGNED, robot="b"))
    team.step()
    assert team.step() == {"a": None, "b": "t"}
    assert team.step(20) == {"a": None, "b": "t"}


def test_order_to_a_robot_that_is_silent_holds_up_nobody() -> None:
    team = team_of({"a": {"t": 1.0}, "b": {"t": 50.0}}, [T])
    team.step(2)
    team.stopped.append("b")
    team.step(20)
    team.tell(TaskReport("t", Progress.REASSIGNED, robot="b"))
    assert team.step(5) == {"a": "t"}


def test_task_that_is_unreachable_for_one_goes_to_another_and_is_tried_again() -> None:
    team = team_of({"a": {"t": 1.0}, "b": {"t": 5.0}}, [T], retry=2.0)
    team.step(2)
    team.reports["a"].append(TaskReport("t", Progress.UNREACHABLE, robot="a"))
    assert team.step() == {"a": None, "b": None}
    assert team.step() == {"a": None, "b": "t"}
    assert "t" not in own_bid(team.decisions["a"])["task_ids"]
    team.step(10)
    assert own_bid(team.decisions["a"])["task_ids"] == ("t",)


def test_cost_that_a_behaviour_cannot_tell_counts_as_very_dear() -> None:
    team = team_of({"a": {"t": None}, "b": {"t": 900.0}}, [T])
    assert team.step(2) == {"a": None, "b": "t"}
    assert own_bid(team.decisions["a"])["costs"] == (1000.0,)
    assert team_of({"a": {"t": None}}, [T]).step(2) == {"a": "t"}


def test_robot_that_does_not_know_where_it_is_makes_no_bid_for_what_it_cannot_tell() -> None:
    one = agent("a", [T, U])
    costs: Dict[str, object] = {"t": None, "u": 2.0}
    decision = one.step(Situation(1.0, (), (), {"t": True, "u": True}, costs.get, None))  # type: ignore[arg-type]
    assert own_bid(decision)["task_ids"] == ("u",)


def test_robots_of_a_task_for_two_come_together_and_go_together() -> None:
    lift = Task("lift", "any", robots=2)
    team = team_of({"a": {"lift": 1.0}, "b": {"lift": 2.0, "t": 3.0}, "c": {"t": 9.0}}, [lift, T])
    assert team.step(2) == {"a": "lift", "b": "lift", "c": "t"}
    del team.costs["a"]["lift"]
    assert team.step(3) == {"a": None, "b": "t", "c": None}


def test_robot_drops_at_once_what_has_become_impossible() -> None:
    team = team_of({"a": {"t": 1.0}}, [T])
    team.step(2)
    del team.costs["a"]["t"]
    assert team.step() == {"a": None}


def test_bids_in_ones_own_name_and_bids_that_make_no_sense_are_passed_over() -> None:
    one = agent("a", [T], ["a", "b"])
    step(one, 1.0, {"t": 5.0})
    forged = bid("a", {"t": 5.0}, 1.2, ordered="u")
    broken = bid("b", {"t": float("nan")}, 1.2)
    assert step(one, 1.2, {"t": 5.0}, [forged, broken]).task == "t"


def test_strangers_bids_count_like_the_teams() -> None:
    one = agent("a", [T], ["a"])
    step(one, 1.0, {"t": 5.0})
    assert step(one, 1.2, {"t": 5.0}, [bid("zz", {"t": 4.0}, 1.2)]).task is None


@pytest.mark.parametrize("allocator", ["nearest_robot/nearest", "nearest_robot/optimal"])
@settings(max_examples=30, deadline=None)
@given(st.integers(0, 2**32 - 1))
def test_no_task_is_ever_held_by_more_robots_than_it_needs_where_all_are_heard(allocator: str, seed: int) -> None:
    """Costs wander at random, tasks end, robots come and go: who hears everybody decides like everybody."""
    random = np.random.default_rng(seed)
    tasks = [T, Task("u", "any", robots=2), V]
    robots = ["a", "b", "c", "d"]
    team = team_of({robot: {task.id: float(random.uniform(0, 9)) for task in tasks} for robot in robots}, tasks)
    for who in team.agents.values():
        who._allocator = agent("x", [], allocator=allocator)._allocator
    for _ in range(40):
        for robot in robots:
            for task in tasks:
                team.costs[robot][task.id] = float(random.integers(0, 5))
        held: List[str] = [task for task in team.step().values() if task]
        assert {task.id: held.count(task.id) in (0, task.robots) for task in tasks} == dict.fromkeys("tuv", True)
    assert len(held) >= 3


def test_equal_bids_in_any_order_give_equal_decisions() -> None:
    others = [bid("b", {"t": 3.0}, 1.2), bid("c", {"t": 3.0, "u": 1.0}, 1.2), bid("d", {"u": 1.0}, 1.2)]
    decisions = []
    for heard in (others, others[::-1]):
        one = agent("a", [T, U], ["a", "b", "c"])
        step(one, 1.0, {"t": 3.0, "u": 5.0})
        decisions.append(step(one, 1.2, {"t": 3.0, "u": 5.0}, heard))
    assert decisions[0] == decisions[1]
    assert decisions[0].task == "t"


def test_parted_team_works_on_in_parts_and_agrees_again() -> None:
    team = team_of({"a": {"t": 4.0, "u": 6.0}, "b": {"t": 3.0, "u": 8.0}}, [T, U])
    assert team.step(5) == {"a": "u", "b": "t"}
    team.lost = lambda sender, receiver: True
    assert team.step(15) == {"a": "t", "b": "t"}
    team.lost = lambda sender, receiver: False
    assert team.step(2) == {"a": "u", "b": "t"}


def test_team_that_hears_nothing_at_all_is_a_team_of_one_each() -> None:
    team = Team({"a": agent("a", [T]), "b": agent("b", [T])}, {"a": {"t": 1.0}, "b": {"t": 1.0}})
    team.lost = lambda sender, receiver: True
    assert team.step(2) == {"a": "t", "b": "t"}
