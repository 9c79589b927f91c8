"""Part ``memory``: the cistern with memories of all sizes (tables 4 and 5)."""

from __future__ import annotations

from team_measures.statistics.tables import MEANS, SHARES, estimate_text, share_text

from block_construction.experiments.part import Options
from block_construction.experiments.published import MEMORY_RESULTS
from block_construction.experiments.trainings import Case, trained
from rqt_mrta_py.hooks import BenchmarkReport, BenchmarkTable, Laboratory

__all__ = ["measure_memory"]

_RUNS, _ITERATIONS, _RATE = 10, 10_000, 0.1


def measure_memory(options: Options, laboratory: Laboratory) -> BenchmarkReport:
    """Train on the cistern with all of the source's sizes of memory."""
    rows = [(method, row) for method, rows in MEMORY_RESULTS.items() for row in rows]
    seeds, iterations = options.repetitions(_RUNS), options.iterations(_ITERATIONS)
    settings = {"rate": _RATE, "iterations": iterations}
    samples = trained(
        laboratory, [Case("cistern", method, {**settings, "memory": row.memory}, seeds) for method, row in rows]
    )
    table = BenchmarkTable(
        f"Tables 4 and 5: the cistern by size of memory, l1 {_RATE:g}, {seeds} runs of at most {iterations} iterations",
        ("method", "J", "cost", "hits", "source's [%]", "iterations", "source's iterations"),
        tuple(
            (
                *(method, row.memory, estimate_text(sample.cost, 2), share_text(sample.hit_share), row.hits),
                *(estimate_text(sample.mean_iterations, 0), row.iterations),
            )
            for (method, row), sample in zip(rows, samples)
        ),
        ("Cost: mean of the best diagrams' costs; the source does not give it.", MEANS, SHARES),
    )
    return BenchmarkReport((table,))
