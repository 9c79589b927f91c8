"""Part ``extensions``: the long ring and the high one (table 7), by the source's method and by ours."""

from __future__ import annotations

from typing import Any, List, Sequence, Tuple

from team_measures.statistics.tables import MEANS

from block_construction.experiments.part import Options
from block_construction.experiments.published import EXTENSION_RESULTS
from block_construction.experiments.trainings import Case, Sample, trained
from block_construction.experiments.ways import SAMPLE_COLUMNS, WAY_NOTES, WAYS, sample_row
from rqt_mrta_py.hooks import BenchmarkReport, BenchmarkTable, Laboratory

__all__ = ["measure_extensions"]

_RUNS, _ITERATIONS = 10, 75_000


def measure_extensions(options: Options, laboratory: Laboratory) -> BenchmarkReport:
    """Train on both extensions by the source's settings and in ways that differ."""
    seeds, iterations = options.repetitions(_RUNS), options.iterations(_ITERATIONS)
    literal = [
        Case(row.structure, row.method, {"rate": row.rate, "memory": row.memory, "iterations": iterations}, seeds)
        for row in EXTENSION_RESULTS
    ]
    ours = [
        (way, Case(structure, method, {**settings, "iterations": iterations}, seeds))
        for structure in sorted({row.structure for row in EXTENSION_RESULTS})
        for way, by_method in WAYS.items()
        for method, settings in by_method.items()
    ]
    samples = trained(laboratory, [*literal, *(case for _, case in ours)])
    first = BenchmarkTable(
        f"Table 7: the extensions by the source's method, {seeds} runs of at most {iterations} iterations",
        (
            *("structure", "method", "settings", *SAMPLE_COLUMNS),
            *("source's cost", "its least", "its hits of 10", "its iterations"),
        ),
        tuple(
            (
                *(row.structure, row.method, row.pace, *sample_row(sample)),
                *(row.cost, row.least, row.hits, row.iterations),
            )
            for row, sample in zip(EXTENSION_RESULTS, samples)
        ),
        ("Optima: 160 for the horizontal, 112 for the vertical extension.", MEANS),
    )
    second = BenchmarkTable(
        f"The extensions in ways that differ from the source's, {seeds} runs of at most {iterations} iterations",
        ("structure", "method", "way", "rate", *SAMPLE_COLUMNS),
        _our_rows(ours, samples[len(literal) :]),
        (
            *WAY_NOTES,
            MEANS,
        ),
    )
    return BenchmarkReport((first, second))


def _our_rows(ours: Sequence[Tuple[str, Case]], samples: Sequence[Sample]) -> Tuple[Tuple[Any, ...], ...]:
    rows: List[Tuple[Any, ...]] = []
    for (way, case), sample in zip(ours, samples):
        rows.append((case.structure, case.method, way, case.settings["rate"], *sample_row(sample)))
    return tuple(rows)
