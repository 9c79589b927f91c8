"""The benchmark ``mtrp``: its parts, what it takes, and the report that parts make together."""

from __future__ import annotations

import logging
import time
from argparse import ArgumentParser, ArgumentTypeError, Namespace
from pathlib import Path
from typing import Dict, Iterator, Sequence, Tuple

from team_measures.benchmark_parts import add_parts_argument, count, joined

from mtrp_allocators.experiments.budgets import measure_budgets
from mtrp_allocators.experiments.decisions import measure_decisions
from mtrp_allocators.experiments.makespans import measure_makespans
from mtrp_allocators.experiments.part import Options, Part
from mtrp_allocators.experiments.published import measure_published
from mtrp_allocators.experiments.ratios import measure_ratios
from mtrp_allocators.experiments.scale import measure_scale
from rqt_mrta_py.hooks import BenchmarkReport, Laboratory

__all__ = ["PARTS", "add_arguments", "measure"]

_log = logging.getLogger("mtrp_allocators.experiments")

PARTS: Dict[str, Part] = {
    "ratios": Part("total length over the proved optimum", measure_ratios),
    "decision": Part("time of one robot's decision", measure_decisions),
    "makespan": Part("longest route over the best known", measure_makespans),
    "scale": Part("whole missions of large teams", measure_scale),
    "budget": Part("against solvers with a given time", measure_budgets),
}
"""All parts, by name, in the order of measuring."""

_QUICK_SIZES: Dict[str, Tuple[int, ...]] = {"robots": (2, 5), "targets": (10, 20)}
_DEFAULTS = Options(time.process_time)


def add_arguments(parser: ArgumentParser) -> None:
    """Say what the benchmark takes."""
    add_parts_argument(parser, PARTS)
    parser.add_argument("--seeds", metavar="N", type=count, help="instances of each size (default: 30; quick: 2)")
    parser.add_argument("--robots", metavar="M,...", type=_counts, help="team sizes (default: 1,2,3,5,10,20,30,50)")
    parser.add_argument("--targets", metavar="N,...", type=_counts, help="numbers of targets (default: 10,20,30,40,50)")
    parser.add_argument(
        "--alpha", metavar="A", type=_weight, default=_DEFAULTS.alpha, help="of UEM (default: %(default)s)"
    )
    parser.add_argument("--quick", action="store_true", help="measure little of everything, to see that it works")
    parser.add_argument(
        "--tsplib", metavar="FILE", type=Path, nargs="+", help="measure these instances of TSPLIB and nothing else"
    )
    parser.add_argument("--no-optima", action="store_true", help="of TSPLIB's instances do not prove the optima")


def measure(told: Namespace, laboratory: Laboratory) -> BenchmarkReport:
    """Measure part after part, or published instances."""
    if told.tsplib:
        return measure_published(told.tsplib, told.alpha, not (told.no_optima or told.json))
    options = Options(
        _DEFAULTS.clock,
        seeds=told.seeds or (2 if told.quick else _DEFAULTS.seeds),
        robots=told.robots or (_QUICK_SIZES["robots"] if told.quick else _DEFAULTS.robots),
        targets=told.targets or (_QUICK_SIZES["targets"] if told.quick else _DEFAULTS.targets),
        alpha=told.alpha,
        quick=told.quick,
    )
    return joined(_reports(told.parts, options))


def _reports(parts: Sequence[str], options: Options) -> Iterator[BenchmarkReport]:
    for name in parts:
        _log.info("part=%s: %s", name, PARTS[name].help)
        yield PARTS[name].measure(options)


def _counts(text: str) -> Tuple[int, ...]:
    return tuple(sorted({count(each.strip()) for each in text.split(",")}))


def _weight(text: str) -> float:
    try:
        weight = float(text)
    except ValueError:
        weight = -1.0
    if not 0.0 <= weight <= 1.0:
        raise ArgumentTypeError(f"{text!r}: a weight from 0 to 1 is expected")
    return weight
