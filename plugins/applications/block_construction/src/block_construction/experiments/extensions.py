"""Part ``extensions``: the long ring and the high one (table 7), by the source's method and by ours."""

from __future__ import annotations

from typing import Any, Dict, List, Sequence, Tuple

from team_measures.statistics.tables import MEANS, estimate_text

from block_construction.experiments.part import Options
from block_construction.experiments.published import EXTENSION_RESULTS
from block_construction.experiments.rates import LOCAL_SETTINGS
from block_construction.experiments.trainings import Case, Sample, trained
from rqt_mrta_py.hooks import BenchmarkReport, BenchmarkTable, Laboratory

__all__ = ["REOPENED_SETTINGS", "SAMPLE_COLUMNS", "measure_extensions", "sample_row"]

_RUNS, _ITERATIONS = 10, 75_000

REOPENED_SETTINGS: Dict[str, Dict[str, Any]] = {
    "FALA": {"rate": 0.05, "credit": "local", "reopen": "yes"},
    "PLA": {"rate": 0.1, "credit": "local", "converged": 0.97, "reopen": "yes"},
}
"""Of trainings under local credit in which automata beside faults begin anew, by method."""

_WAYS = (("local credit", LOCAL_SETTINGS), ("local credit, begun anew", REOPENED_SETTINGS))
SAMPLE_COLUMNS = ("cost", "least", "hits", "iterations")
"""What ``sample_row`` gives."""


def measure_extensions(options: Options, laboratory: Laboratory) -> BenchmarkReport:
    """Train on both extensions by the source's settings, under local credit, and with automata that begin anew."""
    seeds, iterations = options.repetitions(_RUNS), options.iterations(_ITERATIONS)
    literal = [
        Case(row.structure, row.method, {"rate": row.rate, "memory": row.memory, "iterations": iterations}, seeds)
        for row in EXTENSION_RESULTS
    ]
    ours = [
        (way, Case(structure, method, {**settings, "iterations": iterations}, seeds))
        for structure in sorted({row.structure for row in EXTENSION_RESULTS})
        for way, by_method in _WAYS
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
        f"The extensions under local credit, {seeds} runs of at most {iterations} iterations",
        ("structure", "method", "way", "rate", *SAMPLE_COLUMNS),
        _our_rows(ours, samples[len(literal) :]),
        (
            "Differs from the source: each automaton is told the cost of its own block.",
            "Begun anew: whenever training has come to rest, levels beside a row of faults forget what they learned; "
            "what they come to is taken unless it costs more. Training ends at a cost that no diagram is below.",
            MEANS,
        ),
    )
    return BenchmarkReport((first, second))


def sample_row(sample: Sample) -> Tuple[Any, ...]:
    """Give the cells of a sample: cost, least cost, hits, iterations."""
    hits = f"{sample.hits} of {len(sample.costs)}"
    return estimate_text(sample.cost, 1), min(sample.costs), hits, estimate_text(sample.mean_iterations, 0)


def _our_rows(ours: Sequence[Tuple[str, Case]], samples: Sequence[Sample]) -> Tuple[Tuple[Any, ...], ...]:
    rows: List[Tuple[Any, ...]] = []
    for (way, case), sample in zip(ours, samples):
        rows.append((case.structure, case.method, way, case.settings["rate"], *sample_row(sample)))
    return tuple(rows)
