"""Part ``parameters``: the cistern with the parameters that bound PLA (table 3)."""

from __future__ import annotations

from team_measures.statistics.tables import MEANS, SHARES, estimate_text, share_text

from block_construction.experiments.part import Options
from block_construction.experiments.published import PARAMETER_RESULTS
from block_construction.experiments.trainings import Case, trained
from rqt_mrta_py.hooks import BenchmarkReport, BenchmarkTable, Laboratory

__all__ = ["measure_parameters"]

_RUNS, _ITERATIONS, _RATE = 10, 10_000, 0.1
_SCALES = {"rate": "l1 s", "root": "sqrt(l1) s"}


def measure_parameters(options: Options, laboratory: Laboratory) -> BenchmarkReport:
    """Train PLA on the cistern with all of the source's K, n and L."""
    seeds, iterations = options.repetitions(_RUNS), options.iterations(_ITERATIONS)
    settings = {"rate": _RATE, "iterations": iterations}
    rows = [(scale, row) for scale in _SCALES for row in PARAMETER_RESULTS]
    cases = []
    for scale, row in rows:
        own = {"stiffness": row.stiffness, "power": row.power, "bound": row.bound, "noise_scale": scale}
        cases.append(Case("cistern", "PLA", {**settings, **own}, seeds))
    table = BenchmarkTable(
        f"Table 3: PLA on the cistern by K, n and L, l1 {_RATE:g}, J 100, {seeds} runs of at most {iterations} "
        "iterations",
        ("noise", "K", "n", "L", "cost", "hits", "source's [%]", "iterations", "source's iterations"),
        tuple(
            (
                *(_SCALES[scale], row.stiffness, row.power, row.bound),
                *(estimate_text(sample.cost, 2), share_text(sample.hit_share), row.hits),
                *(estimate_text(sample.mean_iterations, 0), row.iterations),
            )
            for (scale, row), sample in zip(rows, trained(laboratory, cases))
        ),
        (
            "Rows of the same seeds are equal as long as no parameter comes to L, as the first four of the source are: "
            "so they are with noise l1 s, the default, not with sqrt(l1) s, which is what it prints.",
            "Cost: mean of the best diagrams' costs; the source does not give it.",
            MEANS,
            SHARES,
        ),
    )
    return BenchmarkReport((table,))
