"""The methods as allocators: of all routes that a method plans, each robot is given the first target.

A method plans anew whenever it is asked, from where the robots are now; so it allocates incrementally, like the
architecture that asks.
"""

from __future__ import annotations

from typing import Callable, Dict, Sequence, Tuple

import numpy as np

from mtrp_allocators.assignment import assign_in_rounds, assign_to_nearest
from mtrp_allocators.insertion import sell_for_makespan, sell_for_sum
from mtrp_allocators.prim import prim_lightest_first, prim_original
from mtrp_allocators.routes import Distances, Routes
from rqt_mrta_py.hooks import AllocationProblem, Allocator

__all__ = ["ALLOCATORS", "METHODS", "first_targets"]

Method = Callable[[Distances], Routes]

METHODS: Dict[str, Method] = {
    "prim_original": prim_original,
    "prim_lightest_first": prim_lightest_first,
    "single_item_sum": sell_for_sum,
    "single_item_makespan": sell_for_makespan,
    "iterated_assignment": assign_in_rounds,
    "nearest_target": assign_to_nearest,
}
"""All methods, by name."""

_UNREACHABLE_FACTOR = 1e6
"""What a way counts that there is not, in longest ways that there are: more than all of them together."""


def first_targets(problem: AllocationProblem, method: Method) -> Sequence[Tuple[str, str]]:
    """Plan routes over a problem's tasks and give each robot the first task of its route.

    A task whose place is not known, that needs several robots, or that no robot can carry out is left out; so is a task
    that comes to stand first for a robot that cannot carry it out. What robots cost is taken from the problem; from
    task to task the straight way counts.

    Args:
        problem: see there.
        method: plans.

    Returns:
        Pairs of task and robot, in the problem's order of tasks.
    """
    costs = np.asarray(problem.costs, dtype=np.float64).reshape(len(problem.robots), len(problem.tasks))
    possible = np.isfinite(costs)
    shown = [
        index
        for index, task in enumerate(problem.tasks)
        if task.place is not None and task.robots == 1 and possible[:, index].any()
    ]
    if not shown or not problem.robots:
        return ()
    places = np.array([[place.x, place.y] for place in (problem.tasks[index].place for index in shown) if place])
    between = np.hypot(*np.moveaxis(places[:, None] - places[None], 2, 0))
    starts = costs[:, shown]
    longest = max(float(starts[np.isfinite(starts)].max()), float(between.max()), 1.0)
    starts = np.where(np.isfinite(starts), starts, longest * _UNREACHABLE_FACTOR)
    pairs = []
    for robot, route in enumerate(method(Distances(starts, between))):
        if route and possible[robot, shown[route[0]]]:
            pairs.append((shown[route[0]], robot))
    return [(problem.tasks[index].id, problem.robots[robot]) for index, robot in sorted(pairs)]


def _allocator(method: Method) -> Allocator:
    return lambda problem: first_targets(problem, method)


ALLOCATORS: Dict[str, Allocator] = {f"mtrp_allocators/{name}": _allocator(method) for name, method in METHODS.items()}
"""The methods as allocators, by the name that parameters use."""
