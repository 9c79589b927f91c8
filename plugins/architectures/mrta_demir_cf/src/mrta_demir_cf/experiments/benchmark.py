"""The benchmark ``demir_cf``: its parts, what it takes, and the report that parts make together."""

from __future__ import annotations

import logging
from argparse import ArgumentParser, Namespace
from typing import Dict, Iterator, Sequence

from team_measures.benchmark_parts import add_parts_argument, count, joined, seconds

from mrta_demir_cf.experiments.contingency import measure_contingencies
from mrta_demir_cf.experiments.failure import measure_failures
from mrta_demir_cf.experiments.maps import measure_maps
from mrta_demir_cf.experiments.online import measure_online_tasks
from mrta_demir_cf.experiments.part import Options, Part
from mrta_demir_cf.experiments.simulation import measure_simulation
from mrta_demir_cf.experiments.team_size import measure_team_sizes
from rqt_mrta_py.hooks import BenchmarkReport, Laboratory

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
    add_parts_argument(parser, PARTS)
    parser.add_argument("--seeds", metavar="N", type=count, help="missions of each kind (default: 20; quick: 2)")
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
        type=seconds,
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
    return joined(_reports(told.parts, options, laboratory))


def _reports(parts: Sequence[str], options: Options, laboratory: Laboratory) -> Iterator[BenchmarkReport]:
    for name in parts:
        _log.info("part=%s seeds=%d: %s", name, options.seeds, PARTS[name].help)
        yield PARTS[name].measure(options, laboratory)
