"""Part ``memory``: the cistern with memories of all sizes (tables 4 and 5)."""

from __future__ import annotations

from team_measures.statistics.tables import MEANS, SHARES, estimate_text, share_text

from block_construction.experiments.part import Options
from block_construction.experiments.published import MEMORY_RESULTS
from block_construction.experiments.readings import READING_NOTE, READINGS, reading_of
from block_construction.experiments.trainings import Case, trained
from rqt_mrta_py.hooks import BenchmarkReport, BenchmarkTable, Laboratory

__all__ = ["measure_memory"]

_RUNS, _ITERATIONS, _RATE = 10, 10_000, 0.1


def measure_memory(options: Options, laboratory: Laboratory) -> BenchmarkReport:
    """Train on the cistern with all of the source's sizes of memory."""
    rows = [(method, extra, row) for method, extra in READINGS for row in MEMORY_RESULTS[method]]
    seeds, iterations = options.repetitions(_RUNS), options.iterations(_ITERATIONS)
    settings = {"rate": _RATE, "iterations": iterations}
    samples = trained(
        laboratory,
        [Case("cistern", method, {**settings, "memory": row.memory, **extra}, seeds) for method, extra, row in rows],
    )
    table = BenchmarkTable(
        f"Tables 4 and 5: the cistern by size of memory, l1 {_RATE:g}, {seeds} runs of at most {iterations} iterations",
        ("method", "J", "cost", "hits", "source's [%]", "iterations", "source's iterations"),
        tuple(
            (
                *(
                    reading_of(sample.case),
                    row.memory,
                    estimate_text(sample.cost, 2),
                    share_text(sample.hit_share),
                    row.hits,
                ),
                *(estimate_text(sample.mean_iterations, 0), row.iterations),
            )
            for (_, _, row), sample in zip(rows, samples)
        ),
        ("Cost: mean of the best diagrams' costs; the source does not give it.", READING_NOTE, MEANS, SHARES),
    )
    return BenchmarkReport((table,))
