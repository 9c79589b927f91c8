"""Algorithm 1 on hand-calculated teams."""

from __future__ import annotations

import re

import numpy as np
import pytest
from mrta_demir_cf.planning import eyh_cost, select, uem_cost
from mrta_demir_cf.planning.arrays import Floats
from mrta_demir_cf.planning.costs import CostFunction
from mrta_demir_cf.planning.selection import selects_by

ROBOT = np.zeros((1, 2))
TARGETS = np.array([[-2.0, 0.0], [1.0, 0.0], [6.0, 0.0]])
ALL = np.ones(3, dtype=np.bool_)


def visits(cost: CostFunction) -> list[int]:
    """Let one robot go from choice to choice until nothing is open."""
    robots, open_targets, order = ROBOT, ALL.copy(), []
    while open_targets.any():
        chosen = select(0, robots, TARGETS, open_targets, cost).chosen
        assert chosen is not None
        order.append(chosen)
        open_targets[chosen] = False
        robots = TARGETS[[chosen]]
    return order


def test_the_worked_example_goes_as_the_reference_says() -> None:
    assert visits(uem_cost(0.6)) == [0, 1, 2]
    assert visits(eyh_cost) == [1, 0, 2]


def test_the_choice_tells_schedule_and_costs() -> None:
    choice = select(0, ROBOT, TARGETS, ALL, uem_cost(0.6))
    assert choice.schedule.tolist() == [0, 1, 2]
    assert choice.costs == pytest.approx([1.2, 1.8, 3.6])
    assert (choice.chosen, choice.cost) == (0, pytest.approx(1.2))


def test_of_equal_costs_the_first_target_is_chosen() -> None:
    targets = np.array([[5.0, 0.0], [0.0, 2.0], [2.0, 0.0]])
    assert select(0, ROBOT, targets, ALL, eyh_cost).chosen == 1


def test_a_robot_without_targets_chooses_none() -> None:
    robots = np.array([[0.0, 0.0], [0.0, 0.0]])
    choice = select(1, robots, TARGETS, ALL, uem_cost())
    assert choice.schedule.tolist() == []
    assert (choice.chosen, choice.cost) == (None, float("inf"))


def test_the_robots_own_distances_decide_on_its_schedule() -> None:
    # Behind a wall the target to the right takes 9 m; it stays in the schedule, which Eq. 1 forms as the crow flies.
    choice = select(0, ROBOT, TARGETS, ALL, eyh_cost, distances=np.array([2.0, 9.0, 6.0]))
    assert choice.schedule.tolist() == [0, 1, 2]
    assert (choice.chosen, choice.cost) == (0, 2.0)


def test_a_target_out_of_reach_is_never_chosen_and_is_no_end_of_the_pair() -> None:
    # Of (-2, 0) and (1, 0) alone both are ends: costs 0.6 * 2 and 0.6 * 1.
    choice = select(0, ROBOT, TARGETS, ALL, uem_cost(0.6), distances=np.array([2.0, 1.0, np.inf]))
    assert choice.costs == pytest.approx([1.2, 0.6, np.inf])
    assert choice.chosen == 1


def test_nothing_is_chosen_where_nothing_is_in_reach() -> None:
    choice = select(0, ROBOT, TARGETS, ALL, uem_cost(0.6), distances=np.full(3, np.inf))
    assert choice.schedule.tolist() == [0, 1, 2]
    assert (choice.chosen, choice.cost) == (None, float("inf"))


@pytest.mark.parametrize(
    ("distances", "message"),
    [
        ([1.0, np.nan, 1.0], "distances[1]: is nan m; give at least 0 m, or inf for what is out of reach"),
        ([1.0, 2.0, -1.0], "distances[2]: is -1 m; give at least 0 m, or inf for what is out of reach"),
        ([1.0, 2.0], "distances: shape is (2,); give (3,)"),
    ],
)
def test_distances_that_are_none_are_refused(distances: list[float], message: str) -> None:
    with pytest.raises(ValueError, match=f"^{re.escape(message)}$"):
        select(0, ROBOT, TARGETS, ALL, eyh_cost, distances=np.array(distances))


def test_costs_that_are_no_numbers_are_refused() -> None:
    def broken(distances: Floats, targets: Floats) -> Floats:
        return np.where(distances == 1.0, np.nan, distances)

    with pytest.raises(ValueError, match=r"^cost: gives NaN for target 1 and robot 0; costs must be numbers$"):
        select(0, ROBOT, TARGETS, ALL, broken)


def test_a_rule_selects_by_its_cost_function() -> None:
    assert selects_by(uem_cost(0.6))(0, ROBOT, TARGETS, ALL).chosen == 0
    assert selects_by(eyh_cost)(0, ROBOT, TARGETS, ALL).chosen == 1
