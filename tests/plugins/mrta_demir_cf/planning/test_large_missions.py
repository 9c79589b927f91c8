"""Fast forms decide what the readable ones decide, ties included."""

from __future__ import annotations

from random import Random
from typing import Tuple

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from mrta_demir_cf.planning import CostFunction, eyh_cost, rough_schedule, select, uem_cost
from mrta_demir_cf.planning.arrays import Floats, Indices
from mrta_demir_cf.planning.compiled import has_compiler, kernel
from mrta_demir_cf.planning.costs import inner_penalty
from mrta_demir_cf.planning.farthest_pair import farthest_pair_of_all
from mrta_demir_cf.planning.kernels.pairs import farthest_of
from mrta_demir_cf.planning.large_missions import event_driven
from mrta_demir_cf.planning.mission import Mission
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
    if kind == "depots":
        starts = starts // 25 * 25
    if kind == "line":
        starts[:, 1] = 7.0
        return starts, np.column_stack([generator.integers(0, side, targets), np.full(targets, 7)]).astype(np.float64)
    if kind == "heap":
        return starts, np.full((targets, 2), 30.0)
    if kind == "outside":
        starts += 200.0
    return starts, generator.integers(0, side, (targets, 2)).astype(np.float64)


KINDS = ["plane", "coarse grid", "fine grid", "depot", "depots", "outside", "line", "heap"]


def readable(starts: Floats, places: Floats, cost: CostFunction) -> Mission:
    return commit_until_arrival(starts, places, selects_by(cost))


FORMS = (False, True) if has_compiler() else (False,)


@pytest.mark.parametrize("cost", COSTS.values(), ids=list(COSTS))
@pytest.mark.parametrize("kind", KINDS)
def test_missions_are_those_of_the_readable_form(kind: str, cost: CostFunction) -> None:
    for robots, targets in ((1, 20), (2, 1), (4, 40), (18, 30), (12, 5)):
        starts, places = team(kind, 1, robots, targets)
        expected = readable(starts, places, cost)
        for compiled in FORMS:
            assert event_driven(starts, places, cost, compiled=compiled) == expected


@given(st.integers(0, 2**32 - 1), st.sampled_from(KINDS), st.integers(1, 20), st.integers(1, 30), st.booleans())
@settings(max_examples=25, deadline=None)
def test_any_mission_is_that_of_the_readable_form(seed: int, kind: str, robots: int, targets: int, uem: bool) -> None:
    starts, places = team(kind, seed, robots, targets)
    cost = uem_cost() if uem else eyh_cost
    expected = readable(starts, places, cost)
    for compiled in FORMS:
        assert event_driven(starts, places, cost, compiled=compiled) == expected


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


@given(st.integers(0, 2**32 - 1), st.sampled_from(KINDS), st.integers(1, 30), st.integers(1, 60))
@settings(max_examples=40, deadline=None)
def test_robots_are_left_out_only_if_they_own_nothing(seed: int, kind: str, robots: int, targets: int) -> None:
    starts, places = team(kind, seed, robots, targets)
    open_targets = np.random.default_rng(seed).uniform(size=targets) < 0.7
    owning = [robot for robot in range(robots) if len(rough_schedule(robot, starts, places, open_targets))]
    assert PrunedSelection(places, eyh_cost).who_may_own(list(range(robots)), starts, open_targets) == owning


def test_robots_are_asked_one_by_one_where_comparing_all_would_cost_more() -> None:
    starts, places = team("plane", 5, 300, 1000)
    assert PrunedSelection(places, eyh_cost).who_may_own([7], starts, np.ones(1000, dtype=np.bool_)) == [7]


@kernel
def compiled_pair(points: Floats, chosen: Indices, outer: Indices) -> Tuple[int, int]:
    return farthest_of(points, chosen, len(chosen), outer)


@given(st.lists(st.tuples(st.integers(0, 9), st.integers(0, 9)), min_size=2, max_size=40), st.randoms())
@settings(max_examples=60, deadline=None)
def test_the_compiled_pair_is_the_readable_one(points: list[Tuple[int, int]], random: Random) -> None:
    array = np.array(points, dtype=np.float64)
    chosen = np.array(random.sample(range(len(array)), len(array)), dtype=np.intp)
    assert compiled_pair(array, chosen, chosen.copy()) == farthest_pair_of_all(array)


@pytest.mark.parametrize("compiled", WAYS)
def test_distances_that_have_no_square_end_the_mission(compiled: bool) -> None:
    refused = pytest.raises(ValueError, match=r"^rule: chooses nothing for any robot, though 1 target\(s\) are open$")
    with np.errstate(over="ignore", invalid="ignore"), refused:
        event_driven(np.array([[0.0, 0.0]]), np.array([[1e200, 0.0]]), eyh_cost, compiled=compiled)


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
