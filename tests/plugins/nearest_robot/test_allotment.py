from __future__ import annotations

from typing import Dict, List, Mapping, Sequence, Tuple

import pytest
from hypothesis import given
from hypothesis import strategies as st
from nearest_robot.allocators import allocate_nearest
from nearest_robot.allotment import allot, kept_cost, merged_order
from nearest_robot.bids import Bid, Offer

from rqt_mrta_py.hooks import AllocationProblem
from rqt_mrta_py.model import Task


def bid(robot: str, costs: Mapping[str, float], holding: str = "", ordered: str = "", robots: int = 1) -> Bid:
    return Bid(robot, {task: Offer(cost, robots) for task, cost in costs.items()}, holding, ordered)


def allotted(*bids: Bid, ended: Sequence[str] = (), keep: float = 1.0) -> Dict[str, str]:
    return dict(allot(bids, {}, set(ended), keep, allocate_nearest))


def test_kept_cost_is_less_by_keep_for_who_holds_the_task() -> None:
    assert kept_cost(5.0, True, 1.5) == 3.5
    assert kept_cost(5.0, False, 1.5) == 5.0


def test_robot_keeps_its_task_until_another_is_nearer_by_more_than_keep() -> None:
    assert allotted(bid("a", {"t": 5.0}, holding="t"), bid("b", {"t": 4.1})) == {"a": "t"}
    assert allotted(bid("a", {"t": 5.0}, holding="t"), bid("b", {"t": 3.9})) == {"b": "t"}


def test_of_two_who_hold_one_task_the_nearer_keeps_it() -> None:
    """As after a radio that was parted."""
    assert allotted(bid("a", {"t": 5.0}, holding="t"), bid("b", {"t": 4.0}, holding="t")) == {"b": "t"}


def test_task_that_is_over_is_not_given_out_whatever_bids_say() -> None:
    assert allotted(bid("a", {"t": 5.0, "u": 6.0}), ended=["t"]) == {"a": "u"}


def test_order_of_an_operator_goes_before_any_cost() -> None:
    assert allotted(bid("a", {"t": 1.0, "u": 2.0}, holding="t"), bid("b", {"t": 90.0, "u": 95.0}, ordered="t")) == {
        "a": "u",
        "b": "t",
    }


def test_order_that_cannot_be_obeyed_holds_up_nobody() -> None:
    assert allotted(bid("a", {"t": 1.0}), bid("b", {"u": 2.0}, ordered="t")) == {"a": "t", "b": "u"}


def test_of_two_robots_ordered_to_a_task_for_one_the_first_of_the_team_goes() -> None:
    assert allotted(bid("a", {"t": 9.0}, ordered="t"), bid("b", {"t": 1.0, "u": 1.0}, ordered="t")) == {
        "a": "t",
        "b": "u",
    }


def test_robot_that_was_ordered_counts_among_the_robots_that_a_task_needs() -> None:
    bids = [bid("a", {"t": 1.0}, robots=2), bid("b", {"t": 2.0}, robots=2), bid("c", {"t": 9.0}, ordered="t", robots=2)]
    assert allotted(*bids) == {"c": "t", "a": "t"}


def test_allocator_gets_what_is_known_of_tasks_in_one_order_and_infinity_for_no_bid() -> None:
    seen: List[AllocationProblem] = []

    def allocate(problem: AllocationProblem) -> Sequence[Tuple[str, str]]:
        seen.append(problem)
        return ()

    known = {"t": Task("t", "digging", robots=7)}
    allot([bid("a", {"u": 2.0, "t": 3.0}, holding="t"), bid("b", {"t": 4.0})], known, set(), 1.0, allocate)
    assert seen[0].robots == ("a", "b")
    assert seen[0].tasks == (Task("u", ""), Task("t", "digging", robots=1))
    assert seen[0].costs.tolist() == [[2.0, 2.0], [float("inf"), 4.0]]


@pytest.mark.parametrize("pairs", [[("x", "a")], [("t", "x")], [("t", "a"), ("t", "a")]])
def test_allocator_that_makes_things_up_is_told_so(pairs: List[Tuple[str, str]]) -> None:
    with pytest.raises(ValueError, match="the allocator gives"):
        allot([bid("a", {"t": 1.0})], {}, set(), 1.0, lambda problem: pairs)


def test_orders_are_merged_by_what_they_say_then_by_id() -> None:
    assert merged_order([["wander", "patrol"], ["wander", "dig", "patrol"]]) == ("wander", "dig", "patrol")
    assert merged_order([["c", "d"], ["a", "b"]]) == ("a", "b", "c", "d")
    assert merged_order([]) == ()


def test_orders_that_contradict_one_another_lose_no_task() -> None:
    assert merged_order([["z", "a", "b"], ["b", "a"]]) == ("z", "a", "b")


@given(
    st.permutations("abcdefg").flatmap(
        lambda order: st.tuples(st.just(order), st.lists(st.sets(st.sampled_from("abcdefg"))))
    )
)
def test_merged_order_keeps_the_order_of_every_list(drawn: Tuple[List[str], List[set]]) -> None:
    order, subsets = drawn
    lists = [[task for task in order if task in subset] for subset in subsets]
    merged = merged_order(lists)
    assert sorted(merged) == sorted(set().union(*subsets) if subsets else set())
    for each in lists:
        assert [task for task in merged if task in each] == each
    assert merged == merged_order(lists[::-1])
