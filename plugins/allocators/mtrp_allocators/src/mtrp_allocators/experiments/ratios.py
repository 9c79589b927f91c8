"""Part ``ratios``: total length of routes against the proved optimum."""

from __future__ import annotations

import logging
from typing import Any, Dict, List, Tuple

from team_measures.statistics.estimates import estimated_mean
from team_measures.statistics.tables import MEANS, estimate_line, estimate_text

from mtrp_allocators.experiments.instances import random_instance
from mtrp_allocators.experiments.methods import total_methods
from mtrp_allocators.experiments.part import Options
from mtrp_allocators.references.optimum import least_total_length
from mtrp_allocators.routes import distances, total_length
from rqt_mrta_py.hooks import BenchmarkReport, BenchmarkTable, Chart, Figure, Line, LineStyle

__all__ = ["measure_ratios"]

_log = logging.getLogger("mtrp_allocators.experiments")

_DENSITIES = (1.0, 2.0, 5.0, 10.0, 25.0, float("inf"))
"""Upper ends of the ranges of targets for each robot."""

_Cell = Tuple[int, int]
_Ratios = Dict[str, Dict[_Cell, List[float]]]


def measure_ratios(options: Options) -> BenchmarkReport:
    """Let all methods find routes on every instance, and divide by the least total length there is."""
    methods = total_methods(options.alpha)
    ratios: _Ratios = {name: {} for name in methods}
    for robots in options.robots:
        for targets in options.targets:
            for seed in range(options.seeds):
                instance = random_instance(robots, targets, seed)
                ways = distances(*instance)
                least = least_total_length(ways).length
                for name, find in methods.items():
                    ratio = total_length(ways, find(instance)) / least
                    ratios[name].setdefault((robots, targets), []).append(ratio)
            _log.info("part=ratios robots=%d targets=%d instances=%d", robots, targets, options.seeds)
    return BenchmarkReport((_summary(ratios), _densities(ratios), _grid(ratios, options)), (_figure(ratios, options),))


def _summary(ratios: _Ratios) -> BenchmarkTable:
    rows = []
    for name, cells in ratios.items():
        values = [value for cell in cells.values() for value in cell]
        rows.append((name, len(values), estimate_text(estimated_mean(values), 4), round(max(values), 4)))
    return BenchmarkTable(
        "Total length of routes over the proved optimum, all sizes together",
        ("method", "instances", "mean ratio", "worst"),
        tuple(rows),
        (
            "Robots and targets are strewn evenly over a square; the optimum of every instance is proved.",
            "EYH, UEM and rollout decide target by target, one robot at a time; all others plan all routes at once.",
            MEANS,
        ),
    )


def _densities(ratios: _Ratios) -> BenchmarkTable:
    rows: List[List[Any]] = []
    low = 0.0
    for high in _DENSITIES:
        row: List[Any] = [f"{low:g} to {high:g}"]
        for cells in ratios.values():
            values = [v for (robots, targets), cell in cells.items() if low < targets / robots <= high for v in cell]
            row.append(estimate_text(estimated_mean(values), 3))
        rows.append(row)
        low = high
    return BenchmarkTable(
        "Mean ratio to the optimum by targets for each robot",
        ("targets a robot", *ratios),
        tuple(map(tuple, rows)),
        ("The upper end of each range belongs to it.", MEANS),
    )


def _grid(ratios: _Ratios, options: Options) -> BenchmarkTable:
    rows: List[Tuple[Any, ...]] = []
    for name, cells in ratios.items():
        for robots in options.robots:
            means = [sum(cells[robots, targets]) / len(cells[robots, targets]) for targets in options.targets]
            rows.append((name, robots, *(round(mean, 3) for mean in means)))
    heads = tuple(f"{targets} targets" for targets in options.targets)
    return BenchmarkTable("Mean ratio to the optimum by size", ("method", "robots", *heads), tuple(rows))


def _figure(ratios: _Ratios, options: Options) -> Figure:
    """Show the ratio over the team's size: a chart for the fewest targets and one for the most."""
    charts = []
    for targets in sorted({min(options.targets), max(options.targets)}):
        lines: List[Line] = []
        for name, cells in ratios.items():
            means = [estimated_mean(cells[robots, targets]) for robots in options.robots]
            lines.append(estimate_line(name, options.robots, means, LineStyle.POINTS))
        charts.append(Chart(tuple(lines), "length / optimum [1]", title=f"{targets} targets", bottom=1.0))
    return Figure("mtrp_ratios", "Total length over the proved optimum", "robots", tuple(charts))
