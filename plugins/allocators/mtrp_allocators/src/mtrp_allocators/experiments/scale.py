"""Part ``scale``: whole event-driven missions of large teams, and what they cost as their size doubles."""

from __future__ import annotations

import logging
from typing import Any, List, Optional, Tuple

from mrta_demir_cf.planning.compiled import has_compiler
from mrta_demir_cf.planning.costs import CostFunction, eyh_cost, uem_cost
from mrta_demir_cf.planning.large_missions import event_driven
from mrta_demir_cf.planning.missions import commit_until_arrival
from mrta_demir_cf.planning.selection import selects_by
from team_measures.statistics.tables import rounded

from mtrp_allocators.experiments.instances import random_instance
from mtrp_allocators.experiments.part import Options
from rqt_mrta_py.hooks import BenchmarkReport, BenchmarkTable

__all__ = ["measure_scale"]

_log = logging.getLogger("mtrp_allocators.experiments")

_COMPILED = ((125, 1250), (250, 2500), (500, 5000), (1000, 10_000), (1000, 20_000), (1000, 50_000), (1000, 100_000))
_PLAIN = ((125, 1250), (250, 2500), (500, 5000), (1000, 10_000))
_READABLE = ((125, 1250),)
"""Team sizes and numbers of targets, by the form of the decision."""
_SMALL = ((20, 200), (40, 400))


def measure_scale(options: Options) -> BenchmarkReport:
    """Let teams visit everything, each robot deciding when it has arrived; time it in all forms of the decision."""
    rows: List[Tuple[Any, ...]] = []
    if has_compiler():
        begin = options.clock()
        event_driven(*random_instance(*_SMALL[0], 0), eyh_cost, compiled=True)
        rows.append(("any", "compiling", None, None, rounded(options.clock() - begin), None, None, None, None))
    for name, cost in (("UEM", uem_cost(options.alpha)), ("EYH", eyh_cost)):
        rows += _rows(name, cost, options)
    table = BenchmarkTable(
        "Processor time of whole missions, each robot deciding as it arrives",
        (
            "cost",
            "form",
            "robots",
            "targets",
            "time [s]",
            "times that of the row above",
            "a target [us]",
            "decisions a target",
            "path [m]",
        ),
        tuple(rows),
        (
            "Compiled: numba, whose compilation in each process is timed apart. NumPy: without it. "
            "Readable: the form that the others are tested against.",
            "All forms visit the same targets in the same order. "
            "Decisions: those of robots that wait too, many of which are ruled out at once.",
        ),
    )
    return BenchmarkReport((table,))


def _rows(name: str, cost: CostFunction, options: Options) -> List[Tuple[Any, ...]]:
    rows: List[Tuple[Any, ...]] = []
    for form, sizes in (("compiled", _COMPILED), ("NumPy", _PLAIN), ("readable", _READABLE)):
        if form == "compiled" and not has_compiler():
            continue
        before: Optional[float] = None
        for robots, targets in _SMALL if options.quick else sizes:
            instance = random_instance(robots, targets, 0)
            begin = options.clock()
            if form == "readable":
                mission = commit_until_arrival(*instance, selects_by(cost))
            else:
                mission = event_driven(*instance, cost, compiled=form == "compiled")
            took = options.clock() - begin
            times = None if not before else rounded(took / before, 2)
            each = (
                rounded(1e6 * took / targets, 1),
                rounded(mission.decisions / targets, 1),
                rounded(mission.total, 1),
            )
            rows.append((name, form, robots, targets, rounded(took, 3), times, *each))
            _log.info("part=scale cost=%s form=%s robots=%d targets=%d", name, form, robots, targets)
            before = took
    return rows
