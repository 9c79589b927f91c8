"""Part ``budget``: DEMiR-CF against solvers of vehicle routing problems that have a given time."""

from __future__ import annotations

import logging
from typing import Any, Callable, Dict, List, Tuple

from team_measures.statistics.estimates import estimated_mean
from team_measures.statistics.tables import MEANS, estimate_text

from mtrp_allocators.experiments.instances import Instance, random_instance
from mtrp_allocators.experiments.methods import total_methods
from mtrp_allocators.experiments.part import Options
from mtrp_allocators.references.optimum import least_total_length
from mtrp_allocators.references.vehicle_routing import route_with_ortools, route_with_pyvrp
from mtrp_allocators.routes import Routes, distances, total_length
from rqt_mrta_py.hooks import BenchmarkReport, BenchmarkTable

__all__ = ["measure_budgets"]

_log = logging.getLogger("mtrp_allocators.experiments")

_SIZES = ((3, 50), (5, 20), (5, 50), (10, 50), (50, 50))
_SEEDS = 6


def measure_budgets(options: Options) -> BenchmarkReport:
    """Let all find routes on a few sizes, and divide by the least total length there is."""
    sizes = _SIZES[1:2] if options.quick else _SIZES
    ways = _ways(options)
    ratios: Dict[Tuple[str, Tuple[int, int]], List[float]] = {}
    for size in sizes:
        for seed in range(min(options.seeds, _SEEDS)):
            instance = random_instance(*size, seed)
            apart = distances(*instance)
            least = least_total_length(apart).length
            for name, find in ways.items():
                ratios.setdefault((name, size), []).append(total_length(apart, find(instance)) / least)
        _log.info("part=budget robots=%d targets=%d", *size)
    rows: List[Tuple[Any, ...]] = [
        (name, *(estimate_text(estimated_mean(ratios[name, size]), 3) for size in sizes)) for name in ways
    ]
    table = BenchmarkTable(
        "Total length over the proved optimum, solvers with a given time",
        ("method", *(f"{robots} robots, {targets} targets" for robots, targets in sizes)),
        tuple(rows),
        ("Solvers know everything at once and plan centrally; EYH, UEM and rollout decide target by target.", MEANS),
    )
    return BenchmarkReport((table,))


def _ways(options: Options) -> Dict[str, Callable[[Instance], Routes]]:
    methods = total_methods(options.alpha)
    return {
        "EYH": methods["EYH"],
        "UEM": methods["UEM"],
        "rollout": methods["rollout"],
        "OR-tools, first solution": lambda instance: route_with_ortools(distances(*instance), 0.0),
        "OR-tools, 0.1 s": lambda instance: route_with_ortools(distances(*instance), 0.1),
        "OR-tools, 1 s": lambda instance: route_with_ortools(distances(*instance), 1.0),
        "PyVRP, 0.1 s": lambda instance: route_with_pyvrp(distances(*instance), 0.1, 1),
        "PyVRP, 1 s": lambda instance: route_with_pyvrp(distances(*instance), 1.0, 1),
    }
