"""Allocators against hand calculation and exhaustive search."""

from __future__ import annotations

import itertools
import math
import sys
from typing import Dict, List, Optional, Sequence, Tuple

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from nearest_robot.allocators import allocate_nearest, allocate_optimally

from rqt_mrta_py.hooks import AllocationProblem, Allocator, MissingDependencyError
from rqt_mrta_py.model import Task

INF = math.inf
BOTH = pytest.mark.parametrize("allocate", [allocate_nearest, allocate_optimally])


def problem(costs: Sequence[Sequence[float]], needed: Optional[Sequence[int]] = None) -> AllocationProblem:
    """Make a problem with robots r0, r1 ... (rows) and tasks t0, t1 ... (columns)."""
    columns = len(costs[0]) if costs else 0
    counts = needed or [1] * columns
    return AllocationProblem(
        tuple(f"r{row}" for row in range(len(costs))),
        tuple(Task(f"t{column}", "any", robots=count) for column, count in enumerate(counts)),
        np.array(costs, dtype=np.float64).reshape(len(costs), columns),
    )


def test_nearest_takes_the_cheapest_pair_first_though_the_rest_pays_for_it() -> None:
    """1 goes first, which leaves 10 for the other: 11 in all, where the other way round were 2 + 3 = 5."""
    assert allocate_nearest(problem([[1.0, 2.0], [3.0, 10.0]])) == [("t0", "r0"), ("t1", "r1")]


def test_optimal_takes_the_least_total_cost() -> None:
    assert allocate_optimally(problem([[1.0, 2.0], [3.0, 10.0]])) == [("t0", "r1"), ("t1", "r0")]


def test_nearest_breaks_ties_by_task_then_robot() -> None:
    assert allocate_nearest(problem([[5.0, 5.0], [5.0, 5.0], [5.0, 5.0]])) == [("t0", "r0"), ("t1", "r1")]
    assert allocate_nearest(problem([[7.0, 5.0, 5.0]])) == [("t1", "r0")]
    assert allocate_nearest(problem([[7.0], [5.0], [5.0]])) == [("t0", "r1")]


@BOTH
def test_nobody_gets_what_he_cannot_do(allocate: Allocator) -> None:
    assert allocate(problem([[INF, 4.0], [INF, 1.0]])) == [("t1", "r1")]
    assert allocate(problem([[INF, INF]])) == []


@BOTH
@pytest.mark.parametrize("costs", [[], [[]], [[], []]])
def test_nothing_comes_of_nothing(allocate: Allocator, costs: List[List[float]]) -> None:
    assert allocate(problem(costs)) == []


def test_optimal_serves_one_more_task_at_any_price() -> None:
    """Two pairs for 1000000 in all come before one for 1: r1 can do t0 only."""
    assert allocate_optimally(problem([[1.0, 999_999.0], [1.0, INF]])) == [("t0", "r1"), ("t1", "r0")]


@BOTH
def test_costs_below_zero_are_costs(allocate: Allocator) -> None:
    """A task that is held may count as less than nothing."""
    assert allocate(problem([[-1.0, 5.0], [-3.0, INF]])) == [("t0", "r1"), ("t1", "r0")]


@BOTH
def test_task_gets_all_the_robots_that_it_needs_or_none(allocate: Allocator) -> None:
    assert allocate(problem([[1.0], [2.0], [3.0]], [2])) == [("t0", "r0"), ("t0", "r1")]
    assert allocate(problem([[1.0], [INF], [INF]], [2])) == []
    assert allocate(problem([[1.0, 9.0], [2.0, INF]], [3, 1])) == [("t1", "r0")]


@BOTH
def test_of_two_tasks_short_of_robots_the_last_one_waits(allocate: Allocator) -> None:
    """Each needs two of three robots; each alone would get them."""
    costs = [[1.0, 9.0], [9.0, 1.0], [5.0, 5.0]]
    assert allocate(problem(costs, [2, 2])) == [("t0", "r0"), ("t0", "r2")]


@BOTH
def test_task_that_needs_more_robots_than_there_can_be_costs_no_memory(allocate: Allocator) -> None:
    assert allocate(problem([[1.0, 2.0]], [4_294_967_295, 1])) == [("t1", "r0")]


def best_by_search(costs: np.ndarray) -> Tuple[int, float]:
    """Give the most pairs that can be and the least that so many cost, by looking at every assignment."""
    rows, columns = costs.shape
    best = (0, 0.0)
    choices = [None, *range(columns)]
    for choice in itertools.product(choices, repeat=rows):
        taken = [column for column in choice if column is not None]
        if len(set(taken)) < len(taken):
            continue
        total = sum(costs[row, column] for row, column in enumerate(choice) if column is not None)
        if math.isfinite(total) and (-len(taken), total) < (-best[0], best[1]):
            best = (len(taken), float(total))
    return best


COSTS = st.one_of(st.integers(0, 12).map(float), st.just(INF))


@given(
    st.integers(1, 4).flatmap(
        lambda columns: st.lists(st.lists(COSTS, min_size=columns, max_size=columns), min_size=1, max_size=4)
    )
)
def test_optimal_is_as_good_as_exhaustive_search(costs: List[List[float]]) -> None:
    told = problem(costs)
    rows: Dict[str, int] = {robot: row for row, robot in enumerate(told.robots)}
    pairs = [(rows[robot], int(task[1:])) for task, robot in allocate_optimally(told)]
    total = sum(told.costs[row, column] for row, column in pairs)
    assert (len(pairs), total) == best_by_search(told.costs)


@given(
    st.integers(1, 5).flatmap(
        lambda columns: st.lists(st.lists(COSTS, min_size=columns, max_size=columns), max_size=5)
    ),
    st.lists(st.integers(1, 3), min_size=5, max_size=5),
)
def test_both_give_each_robot_one_task_at_the_most_and_whole_teams(costs: List[List[float]], needed: List[int]) -> None:
    told = problem(costs, needed[: len(costs[0])] if costs else None)
    for allocate in (allocate_nearest, allocate_optimally):
        pairs = allocate(told)
        robots = [robot for _, robot in pairs]
        assert len(set(robots)) == len(robots)
        for task in told.tasks:
            assert sum(each == task.id for each, _ in pairs) in (0, task.robots)
        assert all(math.isfinite(told.costs[int(robot[1:]), int(task[1:])]) for task, robot in pairs)


def test_optimal_says_what_to_install_where_scipy_is_missing(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setitem(sys.modules, "scipy.optimize", None)
    with pytest.raises(MissingDependencyError, match="install scipy, or choose nearest_robot/nearest") as caught:
        allocate_optimally(problem([[1.0]]))
    assert caught.value.exit_code == 4
