"""Part ``extensions``: the long ring and the high one (table 7), and with the cistern in ways that differ."""

from __future__ import annotations

from typing import Any, Dict, List, NamedTuple, Tuple

from team_measures.statistics.tables import MEANS

from block_construction.experiments.part import Options
from block_construction.experiments.published import EXTENSION_RESULTS
from block_construction.experiments.trainings import Case, Sample, trained
from block_construction.experiments.ways import SAMPLE_COLUMNS, WAY_NOTES, WAYS, sample_row
from rqt_mrta_py.hooks import BenchmarkReport, BenchmarkTable, Laboratory

__all__ = ["measure_extensions"]


class _Size(NamedTuple):
    """How often the source trains on a structure, and how long at most."""

    runs: int
    iterations: int


_EXTENSIONS, _CISTERN = _Size(10, 75_000), _Size(100, 10_000)
_SIZES: Dict[str, _Size] = {
    "cistern": _CISTERN,
    "horizontal_extension": _EXTENSIONS,
    "vertical_extension": _EXTENSIONS,
}


def measure_extensions(options: Options, laboratory: Laboratory) -> BenchmarkReport:
    """Train on both extensions by the source's settings, and with the cistern in ways that differ."""
    published = [
        _case(options, row.structure, row.method, {"rate": row.rate, "memory": row.memory}) for row in EXTENSION_RESULTS
    ]
    ways = [
        (way, _case(options, structure, method, settings))
        for structure in _SIZES
        for way, by_method in WAYS.items()
        for method, settings in by_method.items()
    ]
    # What the source calls safe is in both.
    fast = [case for row, case in zip(EXTENSION_RESULTS, published) if row.pace != "safe"]
    found: List[Sample] = trained(laboratory, [*fast, *(case for _, case in ways)])
    sample_of = {_key(sample.case): sample for sample in found}
    seeds, iterations = options.repetitions(_EXTENSIONS.runs), options.iterations(_EXTENSIONS.iterations)
    first = BenchmarkTable(
        f"Table 7: the extensions by the source's method, {seeds} runs of at most {iterations} iterations",
        (
            *("structure", "method", "settings", *SAMPLE_COLUMNS),
            *("source's cost", "its least", "its hits of 10", "its iterations"),
        ),
        tuple(
            (
                *(row.structure, row.method, row.pace, *sample_row(sample_of[_key(case)])),
                *(row.cost, row.least, row.hits, row.iterations),
            )
            for row, case in zip(EXTENSION_RESULTS, published)
        ),
        ("Optima: 160 for the horizontal, 112 for the vertical extension.", MEANS),
    )
    few = options.iterations(_CISTERN.iterations)
    second = BenchmarkTable(
        f"The cistern in runs of at most {few} iterations, the extensions of at most {iterations}, in three ways",
        ("structure", "method", "way", "rate", *SAMPLE_COLUMNS),
        tuple(
            (case.structure, case.method, way, case.settings["rate"], *sample_row(sample_of[_key(case)]))
            for way, case in ways
        ),
        (*WAY_NOTES, MEANS),
    )
    return BenchmarkReport((first, second))


def _case(options: Options, structure: str, method: str, settings: Dict[str, Any]) -> Case:
    runs, iterations = _SIZES[structure]
    complete = {**settings, "iterations": options.iterations(iterations)}
    return Case(structure, method, complete, options.repetitions(runs))


def _key(case: Case) -> Tuple[Any, ...]:
    """Tell cases apart by what they do: the default of a setting is as good as leaving it out."""
    settings = {"memory": 100, **case.settings}
    return case.structure, case.method, tuple(sorted((name, repr(value)) for name, value in settings.items()))
