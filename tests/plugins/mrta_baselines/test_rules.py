"""The two rules, by hand."""

from __future__ import annotations

from typing import Dict, Sequence

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from mrta_baselines.chance import RandomRule
from mrta_baselines.fixed import FixedRule, deal
from nearest_robot.bids import Bid, Offer


def bid(robot: str, *tasks: str, holding: str = "", ordered: str = "") -> Bid:
    return Bid(robot, dict.fromkeys(tasks, Offer(0.0)), holding, ordered)


def test_tasks_are_dealt_in_turns_to_those_that_can() -> None:
    """a to r1, b to r2, which alone can do c and d; e, which all can do, to r3, which has none yet."""
    bids = [bid("r1", "a", "b", "e"), bid("r2", "a", "b", "c", "d", "e"), bid("r3", "b", "e")]
    assert deal("abcde", bids, {}) == {"a": "r1", "b": "r2", "c": "r2", "d": "r2", "e": "r3"}
    assert deal("e", bids, {"a": "r1", "b": "r2"}) == {"a": "r1", "b": "r2", "e": "r3"}


@given(st.lists(st.sampled_from("abcdef"), unique=True), st.integers(1, 4))
def test_robots_that_can_do_all_get_equally_many(tasks: Sequence[str], robots: int) -> None:
    hands = deal(tasks, [bid(f"r{number}", *tasks) for number in range(robots)], {})
    counts = [list(hands.values()).count(f"r{number}") for number in range(robots)]
    assert sum(counts) == len(tasks)
    assert max(counts) - min(counts) <= 1


def test_nothing_is_dealt_before_offers_have_gone_round() -> None:
    rule = FixedRule("r1", 1.0)
    assert rule.choose(1.0, "", ["a", "b"], []) is None
    assert rule.choose(1.2, "", ["a", "b"], [bid("r1", "a", "b")]) is None
    team = [bid("r1", "a", "b"), bid("r2", "a", "b")]
    assert rule.choose(2.0, "", ["a", "b"], team) is None
    assert rule.choose(2.2, "", ["a", "b"], team) == "a"


def test_a_robot_works_off_its_own_and_nothing_else() -> None:
    """a and c are r1's; c must wait until it is possible; b is r2's, though r2 has fallen silent."""
    rule = FixedRule("r1", 0.0)
    rule.choose(1.0, "", ["a", "b", "c"], [bid("r1", "a", "b", "c"), bid("r2", "a", "b", "c")])
    assert rule.choose(1.2, "a", ["a", "b", "c"], [bid("r1", "a", "b", "c")]) == "a"
    assert rule.choose(9.0, "a", ["b"], [bid("r1", "b")]) is None
    assert rule.choose(9.2, "", ["b", "c"], [bid("r1", "b", "c")]) == "c"


def test_a_task_that_appears_later_is_dealt_then() -> None:
    rule = FixedRule("r1", 0.0)
    rule.choose(1.0, "", ["a"], [bid("r1", "a"), bid("r2", "a")])
    assert rule.choose(5.0, "", ["b"], [bid("r1", "b"), bid("r2", "b")]) is None


def test_an_operator_moves_a_task_to_another_hand() -> None:
    rule = FixedRule("r1", 0.0)
    team = [bid("r1", "a", "b"), bid("r2", "a", "b")]
    assert rule.choose(1.0, "", ["a", "b"], team) == "a"
    rule.reassign("a", "r2")
    assert rule.choose(1.2, "a", ["a", "b"], team) is None
    rule.reassign("b", "r1")
    assert rule.choose(1.4, "", ["a", "b"], team) == "b"


def chances(*tasks: str, taken: str = "") -> Dict[str, int]:
    """Count what a hundred robots of different seeds take."""
    counts = dict.fromkeys(tasks, 0)
    for seed in range(100):
        rule = RandomRule("r1", np.random.default_rng(seed))
        chosen = rule.choose(1.0, "", tasks, [bid("r2", *tasks, holding=taken)])
        assert chosen is not None
        counts[chosen] += 1
    return counts


def test_every_free_task_has_its_chance_and_no_other() -> None:
    """Of a hundred, fifty for each; fewer than thirty is a chance of one in thirty thousand, and seeds are fixed."""
    counts = chances("a", "b", "c", taken="b")
    assert counts["b"] == 0
    assert min(counts["a"], counts["c"]) >= 30


def test_what_a_robot_has_taken_it_keeps() -> None:
    rule = RandomRule("r1", np.random.default_rng(0))
    for now in range(1, 50):
        assert rule.choose(float(now), "b", ["a", "b", "c"], [bid("r1", "a", "b", "c", holding="b")]) == "b"


def test_of_two_that_took_one_task_the_first_of_the_team_keeps_it() -> None:
    team = [bid("r1", "a", "b", holding="a"), bid("r2", "a", "b", holding="a")]
    first, second = (RandomRule(robot, np.random.default_rng(0)) for robot in ("r1", "r2"))
    assert first.choose(1.0, "a", ["a", "b"], team) == "a"
    assert second.choose(1.0, "a", ["a", "b"], team) == "b"


def test_what_another_is_ordered_to_is_let_go() -> None:
    rule = RandomRule("r1", np.random.default_rng(0))
    assert rule.choose(1.0, "a", ["a"], [bid("r1", "a", holding="a"), bid("r2", "a", ordered="a")]) is None


@pytest.mark.parametrize("offers", [[], ["a"]])
def test_where_nothing_is_free_a_robot_does_nothing(offers: Sequence[str]) -> None:
    assert RandomRule("r1", np.random.default_rng(0)).choose(1.0, "", offers, [bid("r2", "a", holding="a")]) is None
