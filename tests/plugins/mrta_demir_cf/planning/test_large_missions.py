"""Fast forms decide what the readable ones decide, ties included."""

from __future__ import annotations

from typing import Tuple

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from mrta_demir_cf.planning import CostFunction, eyh_cost, select, uem_cost
from mrta_demir_cf.planning.arrays import Floats
from mrta_demir_cf.planning.compiled import has_compiler
from mrta_demir_cf.planning.costs import inner_penalty
from mrta_demir_cf.planning.farthest_pair import farthest_pair_of_all
from mrta_demir_cf.planning.kernels.pairs import farthest_of
from mrta_demir_cf.planning.large_missions import event_driven
from mrta_demir_cf.planning.missions import commit_until_arrival
from mrta_demir_cf.planning.pruning import PrunedSelection
from mrta_demir_cf.planning.selection import selects_by

WAYS = [False, pytest.param(True, marks=pytest.mark.skipif(not has_compiler(), reason="numba is not installed"))]
COSTS = {"eyh": eyh_cost, "uem": uem_cost(0.6), "uem 0": uem_cost(0.0)}


def team(kind: str, seed: int, robots: int, targets: int) -> Tuple[Floats, Floats]:
    generator = np.random.default_rng([seed, robots, targets])
    if kind == "plane":
        return generator.uniform(0, 100, (robots, 2)), generator.uniform(0, 100, (targets, 2))
    side = {"coarse grid": 6, "fine grid": 100}.get(kind, 50)
    starts = generator.integers(0, side, (robots, 2)).astype(np.float64)
    if kind == "depot":
        starts[:] = 25.0
    if kind == "outside":
        starts += 200.0
    return starts, generator.integers(0, side, (targets, 2)).astype(np.float64)


KINDS = ["plane", "coarse grid", "fine grid", "depot", "outside"]


@pytest.mark.parametrize("compiled", WAYS)
@pytest.mark.parametrize("cost", COSTS.values(), ids=list(COSTS))
@pytest.mark.parametrize("kind", KINDS)
def test_missions_are_those_of_the_readable_form(kind: str, cost: CostFunction, compiled: bool) -> None:
    for robots, targets in ((1, 30), (2, 1), (7, 40), (25, 60), (12, 5)):
        starts, places = team(kind, 1, robots, targets)
        assert event_driven(starts, places, cost, compiled=compiled) == commit_until_arrival(
            starts, places, selects_by(cost)
        )


@given(st.integers(0, 2**32 - 1), st.sampled_from(KINDS), st.integers(1, 30), st.integers(1, 60))
@settings(max_examples=40, deadline=None)
def test_pruned_selections_are_those_of_the_readable_form(seed: int, kind: str, robots: int, targets: int) -> None:
    starts, places = team(kind, seed, robots, targets)
    open_targets = np.random.default_rng(seed).uniform(size=targets) < 0.7
    pruned = PrunedSelection(places, uem_cost())
    for robot in range(robots):
        expected = select(robot, starts, places, open_targets, uem_cost())
        choice = pruned(robot, starts, places, open_targets)
        assert choice.schedule.tolist() == expected.schedule.tolist()
        assert choice.costs.tolist() == expected.costs.tolist()
        assert (choice.chosen, choice.cost) == (expected.chosen, expected.cost)


@given(st.lists(st.tuples(st.integers(0, 9), st.integers(0, 9)), min_size=2, max_size=40))
@settings(max_examples=60, deadline=None)
def test_the_compiled_pair_is_the_readable_one(points: list[Tuple[int, int]]) -> None:
    array = np.array(points, dtype=np.float64)
    assert tuple(farthest_of(array, np.arange(len(array)), len(array))) == farthest_pair_of_all(array)


@pytest.mark.parametrize("compiled", WAYS)
def test_nothing_is_decided_without_targets(compiled: bool) -> None:
    assert event_driven(np.zeros((2, 2)), np.zeros((0, 2)), eyh_cost, compiled=compiled).routes == ((), ())


@pytest.mark.parametrize("compiled", WAYS)
def test_targets_without_robots_are_refused(compiled: bool) -> None:
    with pytest.raises(ValueError, match=r"^robots: there is none for 1 target\(s\); give at least one$"):
        event_driven(np.zeros((0, 2)), np.zeros((1, 2)), eyh_cost, compiled=compiled)


def test_a_cost_function_of_ones_own_is_not_compiled() -> None:
    def inner(distances: Floats, targets: Floats) -> Floats:
        return distances + inner_penalty(targets)

    starts, places = team("plane", 4, 3, 12)
    assert event_driven(starts, places, inner) == commit_until_arrival(starts, places, selects_by(inner))
    with pytest.raises(ValueError, match=r"^compiled: is True; it needs numba"):
        event_driven(starts, places, inner, compiled=True)


@pytest.mark.long
@pytest.mark.parametrize("cost", [eyh_cost, uem_cost()], ids=["eyh", "uem"])
def test_large_missions_are_the_same_either_way(cost: CostFunction) -> None:
    if not has_compiler():
        pytest.skip("numba is not installed")
    starts, places = team("plane", 2, 200, 2000)
    assert event_driven(starts, places, cost, compiled=True) == event_driven(starts, places, cost, compiled=False)
