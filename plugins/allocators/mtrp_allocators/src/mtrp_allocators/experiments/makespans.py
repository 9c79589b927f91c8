"""Part ``makespan``: the longest route against the best that is known."""

from __future__ import annotations

import logging
from typing import Any, Dict, List, Sequence, Tuple

from team_measures.statistics.estimates import estimated_mean
from team_measures.statistics.tables import MEANS, estimate_text

from mtrp_allocators.experiments.instances import random_instance
from mtrp_allocators.experiments.methods import time_methods
from mtrp_allocators.experiments.part import Options
from mtrp_allocators.references.least_makespan import least_makespan
from mtrp_allocators.references.vehicle_routing import route_with_ortools
from mtrp_allocators.routes import Distances, distances, makespan
from rqt_mrta_py.hooks import BenchmarkReport, BenchmarkTable

__all__ = ["measure_makespans"]

_log = logging.getLogger("mtrp_allocators.experiments")

_SIZES = ((2, 10), (3, 10), (5, 20), (5, 50), (10, 50), (20, 50))
_PROVED = 10
"""Up to so many targets the optimum is proved."""
_SEEDS = 10
_SEARCH = 3.0
"""Of OR-tools [s]."""
_TO_BEAT = "SSI, by path"

_Size = Tuple[int, int]
_Ratios = Dict[Tuple[str, _Size], List[float]]


def measure_makespans(options: Options) -> BenchmarkReport:
    """Let all methods find routes, and divide the longest by the shortest longest route that is known."""
    methods = time_methods(options.alpha)
    sizes = _SIZES[:1] if options.quick else _SIZES
    ratios: _Ratios = {}
    for size in sizes:
        for seed in range(min(options.seeds, _SEEDS)):
            instance = random_instance(*size, seed)
            found = {name: find(instance) for name, find in methods.items()}
            best = _best_known(distances(*instance), list(found.values()))
            for name, longest in found.items():
                ratios.setdefault((name, size), []).append(longest / best)
        _log.info("part=makespan robots=%d targets=%d", *size)
    rows: List[Tuple[Any, ...]] = []
    to_beat = _every(ratios, _TO_BEAT, sizes)
    for name in methods:
        every = _every(ratios, name, sizes)
        cells = [estimate_text(estimated_mean(ratios[name, size]), 3) for size in sizes]
        compared = [value / other for value, other in zip(every, to_beat)]
        rows.append((name, *cells, *(estimate_text(estimated_mean(values), 3) for values in (every, compared))))
    heads = [f"{robots} robots, {targets} targets" for robots, targets in sizes]
    table = BenchmarkTable(
        "Longest route over the best known",
        ("method", *heads, "all", f"all, over {_TO_BEAT}"),
        tuple(rows),
        (
            "EYH, UEM, rollout and balanced plan are DEMiR-CF: each robot decides for itself, target by target.",
            f"Best known: proved up to {_PROVED} targets, else what OR-tools finds in {_SEARCH:g} s or a method does.",
            MEANS,
        ),
    )
    return BenchmarkReport((table,))


def _every(ratios: _Ratios, name: str, sizes: Sequence[_Size]) -> List[float]:
    return [value for size in sizes for value in ratios[name, size]]


def _best_known(ways: Distances, found: List[float]) -> float:
    if ways.starts.shape[1] <= _PROVED:
        return makespan(ways, least_makespan(ways))
    return min(makespan(ways, route_with_ortools(ways, _SEARCH, makespan=True)), *found)
