"""Proved optima: what they cost, and how long it takes to prove them."""

from __future__ import annotations

from typing import Any, List, NamedTuple, Tuple

import numpy as np

from block_construction.diagram.block_set import DEFAULT_LENGTHS
from block_construction.diagram.planning import plan_diagram
from block_construction.exact.planner import EXACT
from block_construction.experiments.part import Options
from block_construction.experiments.published import MINIMA
from block_construction.structure.library import library_structure, structure_names
from rqt_mrta_py.hooks import BenchmarkTable, Laboratory, Structure

__all__ = ["measure_optima"]

_SIDE, _LEVELS, _RANDOM = 12, 6, 10


class _Kind(NamedTuple):
    """Structures of one kind, and what the source says of their cost."""

    name: str
    structures: Tuple[Structure, ...]
    published: Any = None


class _Outcome(NamedTuple):
    """What came of one structure: wall time in seconds."""

    cost: int
    faults: int
    proved: bool
    seconds: float


def measure_optima(options: Options, laboratory: Laboratory) -> BenchmarkTable:
    """Prove the optima of all structures that come with the package, and of some as large as shall be planned."""
    kinds = _kinds(options.repetitions(_RANDOM))
    outcomes = laboratory.outcomes(_prove, [each for kind in kinds for each in kind.structures])
    rows: List[Tuple[Any, ...]] = []
    for kind in kinds:
        found = [next(outcomes) for _ in kind.structures]
        rows.append(
            (
                *(kind.name, _span([each.size for each in kind.structures]), _span([each.cost for each in found])),
                *(kind.published, _span([each.faults for each in found])),
                f"{sum(each.proved for each in found)} of {len(found)}",
                round(max(each.seconds for each in found), 3),
            )
        )
    return BenchmarkTable(
        "Proved optima, by integer programming",
        ("structure", "cells", "cost", "source's minimum", "of it faults", "proved", "seconds at most"),
        tuple(rows),
        ("Seconds of wall time on one core, without importing the solver.",),
    )


def _kinds(number: int) -> List[_Kind]:
    kinds = [_Kind(name, (library_structure(name),), MINIMA.get(name)) for name in structure_names()]
    size = f"{_SIDE} x {_SIDE} x {_LEVELS}"
    kinds.append(_Kind(f"{size}, solid", (_heights("solid", np.full((_SIDE, _SIDE), _LEVELS)),)))
    for kind, lowest in (("any heights", 0), ("heights from 4", 4)):
        # One generator a structure, so that the first ones are the same however many there are.
        drawn = tuple(
            _heights(f"{kind} {seed}", np.random.default_rng(seed).integers(lowest, _LEVELS + 1, size=(_SIDE, _SIDE)))
            for seed in range(number)
        )
        kinds.append(_Kind(f"{size}, {kind}, {number} drawn", drawn))
    return kinds


def _heights(name: str, heights: Any) -> Structure:
    return Structure(name, tuple(map(tuple, heights.tolist())))


def _prove(structure: Structure) -> _Outcome:
    planned = plan_diagram(EXACT, structure, DEFAULT_LENGTHS)
    return _Outcome(planned.diagram.cost, len(planned.diagram.faults), planned.proved, planned.seconds)


def _span(values: List[int]) -> Any:
    return values[0] if len(set(values)) == 1 else f"{min(values)} to {max(values)}"
