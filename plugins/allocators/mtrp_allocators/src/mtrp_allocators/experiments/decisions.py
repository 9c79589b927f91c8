"""Part ``decision``: how long one robot takes to decide what to do next, and how long the optimum takes."""

from __future__ import annotations

import logging
from typing import Any, Callable, Dict, List, Tuple

import numpy as np
from mrta_demir_cf.planning.balanced_plan import balanced_routes
from mrta_demir_cf.planning.costs import eyh_cost, uem_cost
from mrta_demir_cf.planning.rollout import Rollout
from mrta_demir_cf.planning.selection import select
from team_measures.statistics.quantiles import quantile

from mtrp_allocators.allocators import METHODS
from mtrp_allocators.experiments.instances import Instance, random_instance
from mtrp_allocators.experiments.part import Options
from mtrp_allocators.references.optimum import least_total_length
from mtrp_allocators.routes import distances
from rqt_mrta_py.hooks import BenchmarkReport, BenchmarkTable, Chart, Figure, Line, LineStyle

__all__ = ["measure_decisions"]

_log = logging.getLogger("mtrp_allocators.experiments")

_QUANTILES = (0.0, 0.5, 0.9, 1.0)


def measure_decisions(options: Options) -> BenchmarkReport:
    """Time one decision of the first robot on every instance of the most targets."""
    targets = max(options.targets)
    ways = _ways(options)
    for decide in ways.values():
        # What is compiled or imported on first use is no part of a decision.
        decide(random_instance(2, 3, 0))
    times: Dict[Tuple[str, int], List[float]] = {}
    for robots in options.robots:
        for seed in range(options.seeds):
            instance = random_instance(robots, targets, seed)
            for name, decide in ways.items():
                begin = options.clock()
                decide(instance)
                times.setdefault((name, robots), []).append(1000.0 * (options.clock() - begin))
        _log.info("part=decision robots=%d", robots)
    rows: List[Tuple[Any, ...]] = []
    for name in ways:
        for robots in options.robots:
            spread = [quantile(times[name, robots], share) for share in _QUANTILES]
            rows.append((name, robots, *spread))
    table = BenchmarkTable(
        f"Processor time of one decision among {targets} targets",
        ("method", "robots", "least [ms]", "median [ms]", "9 of 10 below [ms]", "greatest [ms]"),
        tuple(rows),
        (
            "EYH, UEM and rollout: what one robot computes before it moves to its next target.",
            "Balanced plan: what one robot computes before it moves at all; afterwards it looks up what comes next.",
            "All others: the routes of all robots, for nobody can decide before all are planned.",
        ),
    )
    return BenchmarkReport((table,), (_figure(times, list(ways), options),))


def _ways(options: Options) -> Dict[str, Callable[[Instance], object]]:
    uem = uem_cost(options.alpha)
    return {
        "EYH": lambda instance: select(0, *instance, np.ones(len(instance.targets), bool), eyh_cost),
        "UEM": lambda instance: select(0, *instance, np.ones(len(instance.targets), bool), uem),
        "rollout": lambda instance: Rollout()(0, *instance, np.ones(len(instance.targets), bool)),
        "balanced plan": lambda instance: balanced_routes(*instance),
        "PRIM-SD": lambda instance: METHODS["prim_lightest_first"](distances(*instance)),
        "SSI": lambda instance: METHODS["single_item_sum"](distances(*instance)),
        "optimum": lambda instance: least_total_length(distances(*instance)),
    }


def _figure(times: Dict[Tuple[str, int], List[float]], names: List[str], options: Options) -> Figure:
    """Show the exponents of ten, for the optimum takes ten thousand times as long."""
    x = tuple(map(float, options.robots))
    lines = []
    for name in names:
        median, least, greatest = (
            tuple(_exponent(quantile(times[name, robots], share)) for robots in options.robots)
            for share in (0.5, 0.0, 1.0)
        )
        lines.append(Line(name, x, median, least, greatest, LineStyle.POINTS))
    chart = Chart(tuple(lines), "log10 of time [ms]", title="median, least and greatest")
    return Figure("mtrp_decision", f"One decision among {max(options.targets)} targets", "robots", (chart,))


def _exponent(value: float | None) -> float:
    return float(np.log10(max(value or 0.0, 1e-6)))
