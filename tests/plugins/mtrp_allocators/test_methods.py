"""The methods, on instances small enough to be worked out by hand, and against what is known of them."""

from __future__ import annotations

from typing import List, Tuple

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from mtrp_allocators.allocators import METHODS
from mtrp_allocators.assignment import assign_in_rounds, assign_to_nearest
from mtrp_allocators.insertion import insertion_costs, sell_for_makespan, sell_for_sum
from mtrp_allocators.prim import prim_lightest_first, prim_original
from mtrp_allocators.references.optimum import least_total_length
from mtrp_allocators.routes import Distances, distances, makespan, route_lengths, total_length

scipy = pytest.importorskip("scipy", reason="SciPy is not installed")

Places = List[Tuple[float, float]]


def ways(robots: Places, targets: Places) -> Distances:
    return distances(np.array(robots, float).reshape(-1, 2), np.array(targets, float).reshape(-1, 2))


places = st.lists(st.tuples(st.integers(0, 12), st.integers(0, 12)), min_size=1, max_size=7)


def test_lengths_are_those_of_open_paths() -> None:
    between = ways([(0, 0), (10, 0), (5, 5)], [(3, 4), (3, 0), (10, 2)])
    routes = ((0, 1), (2,), ())
    assert route_lengths(between, routes).tolist() == [9.0, 2.0, 0.0]
    assert (total_length(between, routes), makespan(between, routes)) == (11.0, 9.0)


@pytest.mark.parametrize("value", [float("nan"), float("inf")])
def test_places_that_are_not_finite_are_refused_by_index(value: float) -> None:
    with pytest.raises(ValueError, match="targets: 1 has a coordinate"):
        distances(np.zeros((1, 2)), np.array([[0.0, 0.0], [1.0, value]]))


# A robot at 0; targets at 1, 2 and -1.5: 1 joins, then 2 below 1 (1 m), then -1.5 below the root.
LINE = ways([(0, 0)], [(1, 0), (2, 0), (-1.5, 0)])


def test_prim_walks_children_as_they_joined_or_the_lightest_subtree_first() -> None:
    """The subtree of 1 weighs 2 m with the edge that joins it, that of -1.5 weighs 1.5 m."""
    assert prim_original(LINE) == ((0, 1, 2),)
    assert prim_lightest_first(LINE) == ((2, 0, 1),)


def test_of_equally_near_robots_the_first_gets_the_target() -> None:
    shared = ways([(0, 0), (0, 0)], [(1, 0), (0, 1)])
    assert prim_original(shared) == ((0, 1), ())
    assert assign_to_nearest(shared) == ((0, 1), ())
    assert sell_for_sum(shared) == ((0,), (1,))


def test_a_target_is_inserted_where_the_route_grows_least() -> None:
    """Into 0 -> (4, 0): (2, 0) costs nothing before it, (5, 0) one way after it, (0, 3) 3 + 5 - 4 before it."""
    line = ways([(0, 0)], [(4, 0), (2, 0), (5, 0), (0, 3)])
    growth, before = insertion_costs(line, 0, [0])
    assert growth[1:].tolist() == [0.0, 1.0, 4.0]
    assert before[1:].tolist() == [0, 1, 0]


def test_bids_by_growth_load_one_robot_and_bids_by_path_share() -> None:
    """Targets lie on a line away from both robots; the near one takes all of them, or they take turns."""
    row = ways([(0, 0), (-1, 0)], [(1, 0), (2, 0), (3, 0), (4, 0)])
    assert sell_for_sum(row) == ((0, 1, 2, 3), ())
    shared = sell_for_makespan(row)
    assert makespan(row, shared) <= makespan(row, sell_for_sum(row))
    assert sorted(shared[0] + shared[1]) == [0, 1, 2, 3]


def test_assignment_goes_round_by_round_at_the_least_total() -> None:
    """First 0 -> 1 and 10 -> 9 (2 m), not both to what is nearest in turn; then each goes on to the middle."""
    pairs = ways([(0, 0), (10, 0)], [(1, 0), (9, 0), (4, 0), (7, 0)])
    assert assign_in_rounds(pairs) == ((0, 2), (1, 3))


@settings(max_examples=60, deadline=None)
@given(places, places)
def test_every_target_is_visited_once_by_every_method(robots: Places, targets: Places) -> None:
    instance = ways(robots, targets)
    for method in METHODS.values():
        routes = method(instance)
        assert len(routes) == len(robots)
        assert sorted(target for route in routes for target in route) == list(range(len(targets)))


@settings(max_examples=40, deadline=None)
@given(places, places)
def test_nobody_beats_the_optimum_and_prim_takes_at_most_twice_as_long(robots: Places, targets: Places) -> None:
    instance = ways(robots, targets)
    optimum = least_total_length(instance)
    for name, method in METHODS.items():
        length = total_length(instance, method(instance))
        assert length >= optimum.length - 1e-9, name
        if name.startswith("prim"):
            assert length <= 2.0 * optimum.length + 1e-9


@settings(max_examples=60, deadline=None)
@given(places, places)
def test_prims_forest_spans_all_at_the_least_weight(robots: Places, targets: Places) -> None:
    """With all robots made one place, it is the minimum spanning tree that SciPy finds."""
    from mtrp_allocators.prim import _forest
    from scipy.sparse.csgraph import minimum_spanning_tree

    instance = ways(robots, sorted(set(targets) - set(robots)))
    graph = np.zeros((len(instance.between) + 1,) * 2)
    graph[1:, 1:], graph[0, 1:] = instance.between, instance.starts.min(axis=0)
    weight = sum(edge for tree in _forest(instance) for edge in tree.edges.values())
    assert weight == pytest.approx(minimum_spanning_tree(graph).sum())


def test_without_robots_or_targets_there_is_nothing_to_plan() -> None:
    for method in METHODS.values():
        assert method(ways([], [(1, 1)])) == ()
        assert method(ways([(0, 0), (1, 0)], [])) == ((), ())
