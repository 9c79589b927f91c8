"""Part ``ratios``: total length of routes against the proved optimum."""

from __future__ import annotations

import logging
from typing import Any, Dict, List, Optional, Sequence, Tuple

from mrta_demir_cf.planning.costs import ALPHA
from team_measures.statistics.estimates import estimated_mean
from team_measures.statistics.tables import MEANS, estimate_line, estimate_text, rounded

from mtrp_allocators.experiments.instances import random_instance
from mtrp_allocators.experiments.methods import total_methods
from mtrp_allocators.experiments.part import Options
from mtrp_allocators.experiments.reference_ratios import reference_mean
from mtrp_allocators.references.optimum import least_total_length
from mtrp_allocators.routes import distances, total_length
from rqt_mrta_py.hooks import BenchmarkReport, BenchmarkTable, Chart, Figure, Line, LineStyle

__all__ = ["measure_ratios"]

_log = logging.getLogger("mtrp_allocators.experiments")

_DENSITIES = (1.0, 2.0, 5.0, 10.0, 25.0, float("inf"))
"""Upper ends of the ranges of targets for each robot."""

_REFERENCE = "The reference is another implementation on 30 of the same instances of each size, given to three digits."

_FAR_OFF = ("iterated assignment", "nearest target")
"""What tables hold and the figure does not, for all others would lie on one line in it."""

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
    tables = [_summary(ratios, options), _densities(ratios, options), _grid(ratios, options)]
    offsets = _offsets(ratios, options)
    return BenchmarkReport((*tables, offsets) if offsets.rows else tuple(tables), (_figure(ratios, options),))


def _summary(ratios: _Ratios, options: Options) -> BenchmarkTable:
    rows = []
    for name, cells in ratios.items():
        values = _joined(ratios, name, list(cells))
        known = _known(name, list(cells), options)
        off = None if known is None else 100.0 * (sum(values) / len(values) / known - 1.0)
        mean = estimate_text(estimated_mean(values), 4)
        rows.append((name, len(values), mean, round(max(values), 4), rounded(known, 4), rounded(off)))
    return BenchmarkTable(
        "Total length of routes over the proved optimum, all sizes together",
        ("method", "instances", "mean ratio", "worst", "reference", "off by [%]"),
        tuple(rows),
        (
            "Robots and targets are strewn evenly over a square; the optimum of every instance is proved.",
            "EYH, UEM and rollout decide target by target, one robot at a time; all others plan all routes at once.",
            _REFERENCE,
            MEANS,
        ),
    )


def _densities(ratios: _Ratios, options: Options) -> BenchmarkTable:
    rows: List[Tuple[Any, ...]] = []
    low = 0.0
    for high in _DENSITIES:
        sizes = [
            (robots, targets)
            for robots in options.robots
            for targets in options.targets
            if low < targets / robots <= high
        ]
        if sizes:
            means = [estimate_text(estimated_mean(_joined(ratios, name, sizes)), 3) for name in ratios]
            rows.append((f"{low:g} to {high:g}", "measured", *means))
            rows.append(("", "reference", *(rounded(_known(name, sizes, options), 3) for name in ratios)))
        low = high
    return BenchmarkTable(
        "Mean ratio to the optimum by targets for each robot",
        ("targets a robot", "", *ratios),
        tuple(rows),
        ("The upper end of each range belongs to it.", _REFERENCE, MEANS),
    )


def _grid(ratios: _Ratios, options: Options) -> BenchmarkTable:
    rows: List[Tuple[Any, ...]] = []
    for name in ratios:
        for robots in options.robots:
            means = [_mean(ratios, name, (robots, targets)) for targets in options.targets]
            rows.append((name, robots, *(round(mean, 3) for mean in means)))
    return BenchmarkTable("Mean ratio to the optimum by size", ("method", "robots", *_heads(options)), tuple(rows))


def _offsets(ratios: _Ratios, options: Options) -> BenchmarkTable:
    rows: List[Tuple[Any, ...]] = []
    for name in ratios:
        for robots in options.robots:
            cells = [(robots, targets) for targets in options.targets]
            known = [_known(name, [cell], options) for cell in cells]
            if any(mean is not None for mean in known):
                offs = (None if mean is None else _mean(ratios, name, cell) - mean for cell, mean in zip(cells, known))
                rows.append((name, robots, *(rounded(off, 3) for off in offs)))
    columns = ("method", "robots", *_heads(options))
    return BenchmarkTable("Mean ratio by size, less the reference's", columns, tuple(rows), (_REFERENCE,))


def _heads(options: Options) -> Tuple[str, ...]:
    return tuple(f"{targets} targets" for targets in options.targets)


def _joined(ratios: _Ratios, name: str, sizes: Sequence[_Cell]) -> List[float]:
    return [value for size in sizes for value in ratios[name][size]]


def _mean(ratios: _Ratios, name: str, size: _Cell) -> float:
    values = ratios[name][size]
    return sum(values) / len(values)


def _known(name: str, sizes: Sequence[_Cell], options: Options) -> Optional[float]:
    """Give the reference's mean; None of UEM with another alpha, which is another method."""
    if name == "UEM" and options.alpha != ALPHA:
        return None
    return reference_mean(name, sizes)


def _figure(ratios: _Ratios, options: Options) -> Figure:
    """Show the grid: the ratio over the team's size, a chart for each number of targets."""
    charts = []
    for targets in options.targets:
        lines: List[Line] = []
        for name, cells in ratios.items():
            if name not in _FAR_OFF:
                means = [estimated_mean(cells[robots, targets]) for robots in options.robots]
                lines.append(estimate_line(name, range(len(means)), means, LineStyle.POINTS))
        ticks = tuple(map(str, options.robots))
        charts.append(Chart(tuple(lines), "length / optimum [1]", f"{targets} targets", x_ticks=ticks, bottom=1.0))
    return Figure("mtrp_ratios", "Total length over the proved optimum", "robots", tuple(charts))
