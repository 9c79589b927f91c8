"""Part ``rates``: the cistern at all learning rates (table 6)."""

from __future__ import annotations

import math
from typing import Any, List, Sequence, Tuple

from team_measures.statistics.estimates import Estimate
from team_measures.statistics.tables import MEANS, SHARES, estimate_line, estimate_text, share_text

from block_construction.experiments.part import Options
from block_construction.experiments.published import RATE_RESULTS, RateResult
from block_construction.experiments.readings import READING_NOTE, READINGS, reading_of
from block_construction.experiments.trainings import Case, Sample, trained
from rqt_mrta_py.hooks import BenchmarkReport, BenchmarkTable, Chart, Figure, Laboratory, Line, LineStyle

__all__ = ["measure_rates", "off_by"]

_RUNS, _ITERATIONS = 100, 10_000
_NEAR = 4.0
"""Off by so much, a cost counts as the source's [%]."""


def measure_rates(options: Options, laboratory: Laboratory) -> BenchmarkReport:
    """Train on the cistern at all of the source's rates, by both readings of PLA's noise."""
    rows = [(method, extra, row) for method, extra in READINGS for row in RATE_RESULTS[method]]
    seeds, iterations = options.repetitions(_RUNS), options.iterations(_ITERATIONS)
    cases = [
        Case("cistern", method, {"rate": row.rate, "iterations": iterations, **extra}, seeds)
        for method, extra, row in rows
    ]
    samples = trained(laboratory, cases)
    table = BenchmarkTable(
        f"Table 6: the cistern at learning rates, J 100, {seeds} runs of at most {iterations} iterations",
        (
            *("method", "rate", "cost", "source's", "off by [%]", f"within {_NEAR:g} %"),
            *("hits", "source's [%]", "iterations", "source's iterations"),
        ),
        tuple(_row(row, sample) for (_, _, row), sample in zip(rows, samples)),
        (
            "Cost: mean of the best diagrams' costs; a hit is the minimum of 32. "
            "Literal method: global credit, stop at a convergence of 0.95.",
            READING_NOTE,
            "The source's hit rates at medium and large rates are not reproduced; why is unknown.",
            MEANS,
            SHARES,
        ),
    )
    return BenchmarkReport((table,), (_figure(samples),))


def off_by(cost: Estimate, published: float) -> Estimate:
    """Tell by how much a mean differs from a published one, with its interval [%]."""
    value, low, high = (100.0 * (each / published - 1.0) for each in cost[:3])
    return Estimate(value, low, high, cost.number)


def _row(row: RateResult, sample: Sample) -> Tuple[Any, ...]:
    off = off_by(sample.cost, row.cost)
    near = "yes" if abs(off.value) <= _NEAR else "no"
    return (
        *(reading_of(sample.case), row.rate, estimate_text(sample.cost, 2), row.cost, estimate_text(off, 1), near),
        *(share_text(sample.hit_share), row.hits, estimate_text(sample.mean_iterations, 0), row.iterations),
    )


def _figure(samples: Sequence[Sample]) -> Figure:
    lines: List[Line] = []
    names = [reading_of(sample.case) for sample in samples]
    for colour, name in enumerate(dict.fromkeys(names)):
        found = [sample for sample, other in zip(samples, names) if other == name]
        x = [math.log10(sample.case.settings["rate"]) for sample in found]
        line = estimate_line(name, x, [sample.cost for sample in found])
        lines.append(Line(name, line.x, line.y, line.low, line.high, line.style, colour))
    colours = {line.label: line.colour for line in lines}
    for method, rows in RATE_RESULTS.items():
        x = [math.log10(row.rate) for row in rows]
        y = tuple(row.cost for row in rows)
        lines.append(Line(f"{method}, source", tuple(x), y, style=LineStyle.DASHED, colour=colours[method]))
    chart = Chart(tuple(lines), "mean best cost [1]")
    return Figure("construction_rates", "The cistern at learning rates", "log10 of the rate", (chart,))
