"""Part ``structures``: tower, dam, pyramid and station (tables 9, 11, 13 and 15), and all optima."""

from __future__ import annotations

from typing import Any, Dict, List, Tuple

from team_measures.statistics.estimates import estimated_mean
from team_measures.statistics.tables import MEANS, estimate_text

from block_construction.experiments.optima import measure_optima
from block_construction.experiments.part import Options
from block_construction.experiments.published import STRUCTURE_RESULTS
from block_construction.experiments.trainings import Case, trained
from block_construction.experiments.ways import (
    LITERAL,
    LOCAL,
    SAMPLE_COLUMNS,
    TUNED,
    WAY_NOTES,
    WAYS,
    sample_row,
)
from rqt_mrta_py.hooks import BenchmarkReport, BenchmarkTable, Laboratory

__all__ = ["measure_structures"]

_RUNS, _ITERATIONS, _OTHER_ITERATIONS = 10, 5000, 10_000
_LITERAL: Dict[str, Any] = {"rate": 0.2}


def measure_structures(options: Options, laboratory: Laboratory) -> BenchmarkReport:
    """Train on the structures by the source's settings and in ways that differ; prove the optima of all."""
    seeds = options.repetitions(_RUNS)
    few, many = options.iterations(_ITERATIONS), options.iterations(_OTHER_ITERATIONS)
    named: List[Tuple[str, Case]] = []
    for row in STRUCTURE_RESULTS:
        ways = [(LITERAL, {**_LITERAL, "iterations": few})]
        ways += [(way, {**WAYS[way][row.method], "iterations": many}) for way in (LOCAL, TUNED)]
        named += [(way, Case(row.structure, row.method, settings, seeds)) for way, settings in ways]
    published = {(row.structure, row.method): row for row in STRUCTURE_RESULTS}
    rows: List[Tuple[Any, ...]] = []
    for (way, case), sample in zip(named, trained(laboratory, [case for _, case in named])):
        convergence = estimate_text(estimated_mean(sample.convergence), 4)
        row = published[case.structure, case.method]
        source = (row.cost, row.least, row.convergence) if way == LITERAL else (None,) * 3
        rows.append((case.structure, case.method, way, *sample_row(sample), convergence, *source))
    table = BenchmarkTable(
        f"Tables 9, 11, 13 and 15: {seeds} runs of at most {few} iterations, or {many} in other ways",
        (
            *("structure", "method", "way", *SAMPLE_COLUMNS, "convergence"),
            *("source's cost", "its least", "its convergence"),
        ),
        tuple(rows),
        (
            "Convergence: mean of the last 100 values. The station is a stand-in: as many cells, layers and levels.",
            "Here l1 is 0.2 in the literal way.",
            *WAY_NOTES,
            MEANS,
        ),
    )
    return BenchmarkReport((table, measure_optima(options, laboratory)))
