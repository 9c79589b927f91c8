from __future__ import annotations

import itertools
import math
from collections import deque
from typing import Deque, List

import numpy as np
import pytest
from block_construction.diagram.codes import FAULTS
from block_construction.learning.credit import is_fault, local_cost
from block_construction.learning.fala import chosen_probability, other_probability
from block_construction.learning.memory import HELD, LEAST_HELD, TOTAL, empty_memory, remember
from block_construction.learning.network import network_of
from block_construction.learning.pla import boltzmann, log_gradient, parameter_change, restoring_force
from block_construction.learning.reward import reward
from block_construction.learning.stops import greatest, hits_among_recent
from block_construction.structure.library import library_structure
from hypothesis import given
from hypothesis import strategies as st

from rqt_mrta_py.hooks import Structure


@pytest.mark.parametrize(
    ("mean", "least", "cost", "expected"),
    [
        (10.0, 6.0, 8.0, 0.5),
        (10.0, 6.0, 6.0, 1.0),
        (10.0, 6.0, 10.0, 0.0),
        (10.0, 6.0, 12.0, 0.0),
        (7.0, 7.0, 7.0, 0.0),
        (-1.0, -3.0, -2.5, 0.75),
    ],
)
def test_reward_is_the_share_of_the_way_from_the_mean_to_the_least(
    mean: float, least: float, cost: float, expected: float
) -> None:
    assert reward(mean, least, cost) == expected


def test_reward_inaction_moves_towards_the_chosen_action() -> None:
    # 0.2 + 0.1 * 0.5 * 0.8; 0.2 - 0.1 * 0.5 * 0.2
    assert chosen_probability(0.2, 0.5, 0.1, 0.0) == pytest.approx(0.24)
    assert other_probability(0.2, 0.5, 0.1, 0.0, 5) == pytest.approx(0.19)


def test_reward_penalty_does_both_at_one_rate() -> None:
    # From 0.24 and 0.19 above: less 0.1 * 0.5 * 0.2, and more by 0.1 * 0.5 * (1/4 - 0.2).
    assert chosen_probability(0.2, 0.5, 0.1, 0.1) == pytest.approx(0.23)
    assert other_probability(0.2, 0.5, 0.1, 0.1, 5) == pytest.approx(0.1925)


def test_inaction_penalty_moves_away_from_an_action_without_reward() -> None:
    assert chosen_probability(0.2, 0.0, 0.0, 0.1) == pytest.approx(0.18)
    assert other_probability(0.2, 0.0, 0.0, 0.1, 5) == pytest.approx(0.205)
    assert chosen_probability(0.2, 1.0, 0.0, 0.1) == 0.2


@given(
    st.lists(st.floats(0.01, 1.0), min_size=2, max_size=6),
    st.floats(0.0, 1.0),
    st.floats(0.0, 1.0),
    st.floats(0.0, 1.0),
)
def test_probabilities_stay_probabilities(weights: List[float], b: float, l1: float, l2: float) -> None:
    p = [weight / sum(weights) for weight in weights]
    new = [chosen_probability(p[0], b, l1, l2), *(other_probability(each, b, l1, l2, len(p)) for each in p[1:])]
    assert sum(new) == pytest.approx(1.0)
    assert all(-1e-12 <= each <= 1.0 + 1e-12 for each in new)


def test_boltzmann_shares_by_the_exponentials() -> None:
    probabilities = np.zeros(3)
    boltzmann(np.log([1.0, 2.0, 5.0]), probabilities)
    assert probabilities.tolist() == pytest.approx([0.125, 0.25, 0.625])


def test_boltzmann_does_not_overflow() -> None:
    probabilities = np.zeros(2)
    boltzmann(np.array([5000.0, 5000.0]), probabilities)
    assert probabilities.tolist() == [0.5, 0.5]


@given(st.lists(st.floats(-3.0, 3.0), min_size=2, max_size=5))
def test_the_gradient_is_that_of_the_logarithm(parameters: List[float]) -> None:
    step = 1e-6

    def log_of_first(moved: int, by: float) -> float:
        u = np.array([value + (by if index == moved else 0.0) for index, value in enumerate(parameters)])
        p = np.zeros(u.size)
        boltzmann(u, p)
        return math.log(p[0])

    p = np.zeros(len(parameters))
    boltzmann(np.array(parameters), p)
    for index in range(p.size):
        slope = (log_of_first(index, step) - log_of_first(index, -step)) / (2.0 * step)
        assert log_gradient(float(p[index]), index == 0) == pytest.approx(slope, abs=1e-6)


@pytest.mark.parametrize(
    ("u", "k", "n", "expected"),
    [
        (9.9, 1.0, 1, 0.0),
        (-10.0, 1.0, 1, 0.0),
        (11.0, 1.0, 1, -2.0),
        (-12.0, 1.0, 1, 4.0),
        # By hand: -2 * 2 * 0.5 * 2^3 and -2 * 3 * 2 * (-2)^5.
        (12.0, 0.5, 2, -16.0),
        (-12.0, 2.0, 3, 384.0),
    ],
)
def test_the_force_sets_in_beyond_the_bound(u: float, k: float, n: int, expected: float) -> None:
    assert restoring_force(u, k, 10.0, n) == expected


def test_parameters_change_by_reward_force_and_noise() -> None:
    # Reward adds 0.25 * 0.5 * 0.8, force 0.25 * (-2), noise sqrt(0.25) * 0.1.
    assert parameter_change(0.5, 0.8, -2.0, 0.05, 0.25) == pytest.approx(-0.35)


@given(st.integers(1, 7), st.lists(st.integers(-5, 5), min_size=1, max_size=40))
def test_memory_is_that_of_the_last_costs(size: int, costs: List[int]) -> None:
    memory = empty_memory(2, size)
    kept: Deque[int] = deque(maxlen=size)
    for cost in costs:
        remember(memory.costs[1], memory.sums[1], cost)
        kept.append(cost)
        assert memory.sums[1, [HELD, TOTAL, LEAST_HELD]].tolist() == [len(kept), sum(kept), min(kept)]
    memory.sums[1] = 0
    remember(memory.costs[1], memory.sums[1], 9)
    assert memory.sums[1, [HELD, TOTAL, LEAST_HELD]].tolist() == [1, 9, 9]


def test_faults_are_the_sources_thirteen() -> None:
    listed = ["22", "33", "55", "66", "44", "42", "43", "45", "46", "24", "34", "54", "64"]
    found = [f"{lower}{upper}" for lower in range(1, 7) for upper in range(1, 7) if is_fault(lower, upper)]
    assert found == sorted(listed)


def test_rule_of_faults_that_is_compiled_is_that_of_the_cost_of_diagrams() -> None:
    for pair in itertools.product(range(1, 7), repeat=2):
        assert is_fault(*pair) is (pair in FAULTS)


def test_a_block_is_told_its_own_faults_less_its_units() -> None:
    # Two cells along x, two levels: actions 1 and 2 of the left automaton, 1 of the right one, on both levels.
    network = network_of(Structure("pair", ((2, 2),)), (1, 2, 3))
    assert network.lengths.tolist() == [1, 2, 1, 1, 2, 1]
    # A block of two below, singles above: two faults below, one for each single.
    codes = np.array([2, 3, 4, 4])
    assert [local_cost(network, codes, action) for action in (1, 3, 5)] == [0, 0, 0]
    # A block of two on singles of which the left has no code of an end: one fault.
    assert local_cost(network, np.array([1, 4, 2, 3]), 4) == -1


@pytest.mark.parametrize(
    ("name", "cells", "actions"),
    [("wall", 14, 32), ("cistern", 96, 272), ("pyramid", 120, 320), ("vertical_extension", 336, 952)],
)
def test_networks_have_as_many_automata_as_cells(name: str, cells: int, actions: int) -> None:
    network = network_of(library_structure(name), (1, 2, 3))
    assert (network.above.size, network.lengths.size) == (cells, actions)
    assert (network.first[-1], network.begin.size) == (actions, actions + 1)
    assert np.abs(network.lengths).sum() == network.cells.size


@given(st.lists(st.integers(1, 3), min_size=1, max_size=300), st.integers(0, 120))
def test_hits_are_counted_among_the_last_hundred_of_the_leg(costs: List[int], begun: int) -> None:
    begun = min(begun, len(costs) - 1)
    least, hits = 99, 0
    for run in range(begun + 1, len(costs) + 1):
        hits = hits_among_recent(hits, np.array(costs), run, begun, least)
        least = min(least, costs[run - 1])
        assert hits == costs[max(begun, run - 100) : run].count(least)


def test_the_greatest_is_found_wherever_it_stands() -> None:
    assert [greatest(np.roll([0.2, 0.5, 0.3], shift)) for shift in range(3)] == [0.5] * 3
