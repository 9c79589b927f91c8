"""Eq. 2 and Eq. 3, by hand."""

from __future__ import annotations

import numpy as np
import pytest
from mrta_demir_cf.planning import eyh_cost, uem_cost

# The reference's worked example: robot (0, 0); the pair is the first and the last target, 8 m apart.
TARGETS = np.array([[-2.0, 0.0], [1.0, 0.0], [6.0, 0.0]])
DISTANCES = np.array([2.0, 1.0, 6.0])


def test_eyh_costs_are_the_distances() -> None:
    assert eyh_cost(DISTANCES, TARGETS).tolist() == [2.0, 1.0, 6.0]


def test_uem_costs_are_those_of_the_worked_example() -> None:
    # Inner target: 0.6 times 1 m, and 0.4 times the 8 m of the pair less 5 m to its farther end.
    assert uem_cost(0.6)(DISTANCES, TARGETS) == pytest.approx([1.2, 1.8, 3.6])


def test_uem_weighs_with_0_6_unless_told_otherwise() -> None:
    assert uem_cost() == uem_cost(0.6)


def test_uem_with_weight_1_is_eyh() -> None:
    assert uem_cost(1.0)(DISTANCES, TARGETS).tolist() == eyh_cost(DISTANCES, TARGETS).tolist()


def test_uem_with_weight_0_is_the_bracket() -> None:
    assert uem_cost(0.0)(DISTANCES, TARGETS).tolist() == [0.0, 3.0, 0.0]


def test_a_single_target_has_no_bracket() -> None:
    assert uem_cost(0.6)(np.array([5.0]), np.array([[3.0, 4.0]])) == pytest.approx([3.0])


def test_no_targets_cost_nothing() -> None:
    assert uem_cost(0.6)(np.zeros(0), np.zeros((0, 2))).tolist() == []


def test_targets_that_coincide_have_a_bracket_of_zero() -> None:
    assert uem_cost(0.6)(np.full(3, 5.0), np.full((3, 2), 3.0)) == pytest.approx([3.0, 3.0, 3.0])


@pytest.mark.parametrize("alpha", [-0.1, 1.1, float("nan")])
def test_a_weight_outside_of_0_to_1_is_refused(alpha: float) -> None:
    with pytest.raises(ValueError, match=f"^alpha: is {alpha}; give a weight, 0 <= alpha <= 1$"):
        uem_cost(alpha)
