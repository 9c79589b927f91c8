"""The benchmark ``construction``: its parts, what it takes, and the report that parts make together."""

from __future__ import annotations

import logging
import time
from argparse import ArgumentParser, Namespace
from typing import Dict, Iterator, Sequence

from team_measures.benchmark_parts import add_parts_argument, count, joined

from block_construction.experiments.builds import measure_builds
from block_construction.experiments.extensions import measure_extensions
from block_construction.experiments.memory import measure_memory
from block_construction.experiments.noise import measure_noise
from block_construction.experiments.parameters import measure_parameters
from block_construction.experiments.part import Options, Part
from block_construction.experiments.plans import measure_plan_rates, measure_plans
from block_construction.experiments.rates import measure_rates
from block_construction.experiments.structures import measure_structures
from block_construction.experiments.teams import measure_teams
from block_construction.experiments.throughput import measure_throughput
from rqt_mrta_py.hooks import BenchmarkReport, Laboratory

__all__ = ["PARTS", "add_arguments", "measure"]

_log = logging.getLogger("block_construction.experiments")

PARTS: Dict[str, Part] = {
    "parameters": Part("the cistern by PLA's K, n and L (table 3)", measure_parameters),
    "memory": Part("the cistern by size of memory (tables 4 and 5)", measure_memory),
    "rates": Part("the cistern by learning rate (table 6)", measure_rates),
    "extensions": Part("the extensions (table 7), and with the cistern in three ways", measure_extensions),
    "structures": Part("tower, dam, pyramid, station (tables 9, 11, 13, 15), and all optima", measure_structures),
    "plans": Part("execution plans by method", measure_plans),
    "plan-rates": Part("execution plans by PLA's rate and memory (table 8)", measure_plan_rates),
    "builds": Part("structures put up by one robot (tables 10, 12, 14, 16)", measure_builds),
    "noise": Part("builds under errors of poses (figure 48)", measure_noise),
    "teams": Part("a tower put up by teams, with a robot lost, and under ALLIANCE", measure_teams),
    "throughput": Part("iterations a second", measure_throughput),
}
"""All parts, by name, in the order of measuring."""


def add_arguments(parser: ArgumentParser) -> None:
    """Say what the benchmark takes."""
    add_parts_argument(parser, PARTS)
    parser.add_argument(
        "--seeds", metavar="N", type=count, help="repetitions of everything (default: as many as the source; quick: 1)"
    )
    parser.add_argument("--quick", action="store_true", help="measure little of everything, to see that it works")


def measure(told: Namespace, laboratory: Laboratory) -> BenchmarkReport:
    """Measure part after part."""
    return joined(_reports(told.parts, Options(time.process_time, told.seeds, told.quick), laboratory))


def _reports(parts: Sequence[str], options: Options, laboratory: Laboratory) -> Iterator[BenchmarkReport]:
    for name in parts:
        _log.info("part=%s: %s", name, PARTS[name].help)
        yield PARTS[name].measure(options, laboratory)
