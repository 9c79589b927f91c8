"""Benchmark ``allocators``: what greed costs, and what the optimum takes, on random instances."""

from __future__ import annotations

import math
import time
from argparse import ArgumentParser, ArgumentTypeError, Namespace
from typing import Callable, Dict, List, Sequence

import numpy as np

from nearest_robot.allocators import allocate_nearest, allocate_optimally
from rqt_mrta_py.hooks import AllocationProblem, Allocator, Benchmark, BenchmarkTable
from rqt_mrta_py.model import Task

__all__ = ["ALLOCATORS", "allocators_benchmark", "random_problem", "total_cost"]

ALLOCATORS: Dict[str, Allocator] = {
    "nearest_robot/nearest": allocate_nearest,
    "nearest_robot/optimal": allocate_optimally,
}
"""The allocators of this package, by the name that parameters use."""

_SIDE = 100.0


def allocators_benchmark(clock: Callable[[], float] = time.perf_counter) -> Benchmark:
    """Make the benchmark.

    Args:
        clock: tells the time [s].
    """
    return Benchmark(
        "total cost and time of the allocators nearest and optimal on random instances",
        _add_arguments,
        lambda options, _laboratory: _measure(options, clock),
    )


def random_problem(robots: int, tasks: int, random: np.random.Generator) -> AllocationProblem:
    """Strew robots and tasks evenly over a square of 100 m; a task costs the straight way to it [m]."""
    places, goals = random.uniform(0.0, _SIDE, (robots, 1, 2)), random.uniform(0.0, _SIDE, (1, tasks, 2))
    return AllocationProblem(
        tuple(f"robot{number}" for number in range(robots)),
        tuple(Task(f"task{number}", "go_to_place") for number in range(tasks)),
        np.hypot(*np.moveaxis(places - goals, 2, 0)),
    )


def total_cost(problem: AllocationProblem, allocator: Allocator) -> float:
    """Let an allocator give out a problem's tasks and add up what they cost [m]."""
    rows = {robot: row for row, robot in enumerate(problem.robots)}
    columns = {task.id: column for column, task in enumerate(problem.tasks)}
    return math.fsum(float(problem.costs[rows[robot], columns[task]]) for task, robot in allocator(problem))


def _add_arguments(parser: ArgumentParser) -> None:
    parser.add_argument("--robots", metavar="N", type=_count, default=20, help="robots of an instance (default: 20)")
    parser.add_argument("--tasks", metavar="N", type=_count, default=20, help="tasks of an instance (default: 20)")
    parser.add_argument("--instances", metavar="N", type=_count, default=100, help="random instances (default: 100)")
    parser.add_argument("--seed", metavar="N", type=_seed, default=0, help="of the random instances (default: 0)")


def _measure(options: Namespace, clock: Callable[[], float]) -> BenchmarkTable:
    random = np.random.default_rng(options.seed)
    problems = [random_problem(options.robots, options.tasks, random) for _ in range(options.instances)]
    costs: Dict[str, List[float]] = {}
    times: Dict[str, List[float]] = {}
    for name, allocator in ALLOCATORS.items():
        # SciPy is imported by the first call, which is not what is measured.
        allocator(problems[0])
        costs[name], times[name] = [], []
        for problem in problems:
            before = clock()
            cost = total_cost(problem, allocator)
            times[name].append(clock() - before)
            costs[name].append(cost)
    best = costs["nearest_robot/optimal"]
    return BenchmarkTable(
        f"{options.robots} robots and {options.tasks} tasks, {options.instances} random instances, seed {options.seed}",
        (
            "allocator",
            "total cost, mean [m]",
            "of the optimum, mean [1]",
            "the worst [1]",
            "time, mean [ms]",
            "least [ms]",
        ),
        tuple((name, *_row(costs[name], best, times[name])) for name in ALLOCATORS),
        (f"Robots and tasks lie evenly over a square of {_SIDE:g} m; a task costs the straight way to it.",),
    )


def _row(costs: Sequence[float], best: Sequence[float], times: Sequence[float]) -> Sequence[float]:
    ratios = [cost / least if least else 1.0 for cost, least in zip(costs, best)]
    numbers = (math.fsum(costs) / len(costs), math.fsum(ratios) / len(ratios), max(ratios))
    return (*numbers, 1000.0 * math.fsum(times) / len(times), 1000.0 * min(times))


def _count(text: str) -> int:
    if not text.isascii() or not text.isdigit() or not 1 <= int(text[:9]) <= 100_000:
        raise ArgumentTypeError(f"{text!r}: a whole number from 1 to 100000 is expected")
    return int(text)


def _seed(text: str) -> int:
    if not text.isascii() or not text.isdigit():
        raise ArgumentTypeError(f"{text!r}: a whole number of at least 0 is expected")
    return int(text)
