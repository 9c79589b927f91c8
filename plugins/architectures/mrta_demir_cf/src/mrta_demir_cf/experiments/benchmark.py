"""The benchmark ``demir_cf``: its parts, what it takes, and the report that parts make together."""

from __future__ import annotations

import logging
import math
from argparse import ArgumentParser, ArgumentTypeError, Namespace
from typing import Dict, List, Tuple

from mrta_demir_cf.experiments.contingency import measure_contingencies
from mrta_demir_cf.experiments.failure import measure_failures
from mrta_demir_cf.experiments.maps import measure_maps
from mrta_demir_cf.experiments.online import measure_online_tasks
from mrta_demir_cf.experiments.part import Options, Part
from mrta_demir_cf.experiments.simulation import measure_simulation
from mrta_demir_cf.experiments.team_size import measure_team_sizes
from rqt_mrta_py.hooks import BenchmarkReport, BenchmarkTable, Figure, Laboratory

__all__ = ["PARTS", "add_arguments", "measure"]

_log = logging.getLogger("mrta_demir_cf.experiments")

PARTS: Dict[str, Part] = {
    "team_size": Part("one to eight robots, on message level", measure_team_sizes),
    "contingency": Part("messages and robots lost, handling on and off, on message level", measure_contingencies),
    "failure": Part("six targets, one robot, three, one of them lost, on message level", measure_failures),
    "online": Part("targets that turn up on the way, on message level", measure_online_tasks),
    "simulation": Part("teams of several sizes and a robot that fails, simulated", measure_simulation),
    "map": Part("with a map and without, simulated", measure_maps),
}
"""All parts, by name, in the order of measuring."""

_DEFAULTS = Options()
_QUICK_SEEDS = 2


def add_arguments(parser: ArgumentParser) -> None:
    """Say what the benchmark takes."""
    names = ",".join(PARTS)
    parser.add_argument(
        "--parts", metavar="P,...", type=_parts, default=tuple(PARTS), help=f"what to measure (default: {names})"
    )
    parser.add_argument("--seeds", metavar="N", type=_count, help="missions of each kind (default: 20; quick: 2)")
    parser.add_argument(
        "--application",
        metavar="A",
        default=_DEFAULTS.application,
        help="whose targets robots visit in simulation (default: %(default)s)",
    )
    parser.add_argument(
        "--world", metavar="W", default=_DEFAULTS.world, help="where that is simulated (default: %(default)s)"
    )
    parser.add_argument(
        "--duration",
        metavar="S",
        type=_seconds,
        default=_DEFAULTS.duration,
        help="of a simulated mission, at most (default: %(default)g)",
    )
    parser.add_argument("--quick", action="store_true", help="measure little of everything, to see that it works")


def measure(told: Namespace, laboratory: Laboratory) -> BenchmarkReport:
    """Measure part after part."""
    options = Options(
        seeds=told.seeds or (_QUICK_SEEDS if told.quick else _DEFAULTS.seeds),
        application=told.application,
        world=told.world,
        duration=told.duration,
        quick=told.quick,
    )
    tables: List[BenchmarkTable] = []
    figures: List[Figure] = []
    for name in told.parts:
        _log.info("part=%s seeds=%d: %s", name, options.seeds, PARTS[name].help)
        report = PARTS[name].measure(options, laboratory)
        tables += report.tables
        figures += report.figures
    return BenchmarkReport(tuple(tables), tuple(figures))


def _parts(text: str) -> Tuple[str, ...]:
    names = tuple(name.strip() for name in text.split(","))
    for name in names:
        if name not in PARTS:
            raise ArgumentTypeError(f"{name!r}: there is no such part; there are: {', '.join(PARTS)}")
    return tuple(name for name in PARTS if name in names)


def _count(text: str) -> int:
    if not (text.isascii() and text.isdigit() and int(text)):
        raise ArgumentTypeError(f"{text!r}: a whole number from 1 is expected")
    return int(text)


def _seconds(text: str) -> float:
    try:
        seconds = float(text)
    except ValueError:
        seconds = math.nan
    if not 0.0 < seconds < math.inf:
        raise ArgumentTypeError(f"{text!r}: a number of seconds above 0 is expected")
    return seconds
