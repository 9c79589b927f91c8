"""Part ``rates``: the cistern at all learning rates (table 6), and in other ways."""

from __future__ import annotations

import math
from typing import Any, Dict, List, Sequence, Tuple

from team_measures.statistics.tables import MEANS, SHARES, estimate_line, estimate_text, rounded, share_text

from block_construction.experiments.part import Options
from block_construction.experiments.published import RATE_RESULTS, RateResult
from block_construction.experiments.trainings import Case, Sample, trained
from block_construction.experiments.ways import SAMPLE_COLUMNS, WAY_NOTES, WAYS, sample_row
from rqt_mrta_py.hooks import BenchmarkReport, BenchmarkTable, Chart, Figure, Laboratory, Line, LineStyle

__all__ = ["measure_rates"]

_RUNS, _ITERATIONS = 100, 10_000
_SCALED = "PLA, noise l1 s"
_READINGS: Tuple[Tuple[str, Dict[str, Any]], ...] = (("PLA", {}), ("PLA", {"noise_scale": "rate"}), ("FALA", {}))


def measure_rates(options: Options, laboratory: Laboratory) -> BenchmarkReport:
    """Train on the cistern at all of the source's rates, and in ways that differ."""
    rows = [(method, extra, row) for method, extra in _READINGS for row in RATE_RESULTS[method]]
    seeds, iterations = options.repetitions(_RUNS), options.iterations(_ITERATIONS)
    cases = [
        Case("cistern", method, {"rate": row.rate, "iterations": iterations, **extra}, seeds)
        for method, extra, row in rows
    ]
    ours = [
        (way, Case("cistern", method, {**settings, "iterations": iterations}, seeds))
        for way, by_method in WAYS.items()
        for method, settings in by_method.items()
    ]
    samples = trained(laboratory, [*cases, *(case for _, case in ours)])
    table = BenchmarkTable(
        f"Table 6: the cistern at learning rates, J 100, {seeds} runs of at most {iterations} iterations",
        (
            "method",
            "rate",
            "cost",
            "source's",
            "off by [%]",
            "hits",
            "source's [%]",
            "iterations",
            "source's iterations",
        ),
        tuple(_row(row, sample) for (_, _, row), sample in zip(rows, samples)),
        (
            "Cost: mean of the best diagrams' costs; a hit is the minimum of 32. "
            "Literal method: global credit, stop at a convergence of 0.95.",
            f"{_SCALED} is another reading than what is printed, sqrt(l1) s: the costs at small rates come out by it.",
            "The source's hit rates at medium and large rates are not reproduced; why is unknown.",
            MEANS,
            SHARES,
        ),
    )
    local = BenchmarkTable(
        f"The cistern in ways that differ from the source's, {seeds} runs of at most {iterations} iterations",
        ("method", "way", "rate", *SAMPLE_COLUMNS),
        tuple(
            (case.method, way, case.settings["rate"], *sample_row(sample))
            for (way, case), sample in zip(ours, samples[len(rows) :])
        ),
        (*WAY_NOTES, MEANS),
    )
    return BenchmarkReport((table, local), (_figure(samples[: len(rows)]),))


def _name(sample: Sample) -> str:
    return _SCALED if sample.case.settings.get("noise_scale") else sample.case.method


def _row(row: RateResult, sample: Sample) -> Tuple[Any, ...]:
    off = 100.0 * (sample.cost.value / row.cost - 1.0)
    return (
        *(_name(sample), row.rate, estimate_text(sample.cost, 2), row.cost, rounded(off, 1)),
        *(share_text(sample.hit_share), row.hits, estimate_text(sample.mean_iterations, 0), row.iterations),
    )


def _figure(samples: Sequence[Sample]) -> Figure:
    lines: List[Line] = []
    for name in dict.fromkeys(map(_name, samples)):
        found = [sample for sample in samples if _name(sample) == name]
        x = [math.log10(sample.case.settings["rate"]) for sample in found]
        lines.append(estimate_line(name, x, [sample.cost for sample in found]))
    for method, rows in RATE_RESULTS.items():
        x = [math.log10(row.rate) for row in rows]
        lines.append(Line(f"{method}, source", tuple(x), tuple(row.cost for row in rows), style=LineStyle.DASHED))
    chart = Chart(tuple(lines), "mean best cost [1]")
    return Figure("construction_rates", "The cistern at learning rates", "log10 of the rate", (chart,))
