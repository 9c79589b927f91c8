"""The benchmark ``alliance``: its parts, what it takes, and the report that parts make together."""

from __future__ import annotations

import logging
from argparse import ArgumentParser, Namespace
from typing import Dict, Iterator, Sequence

from team_measures.benchmark_parts import add_parts_argument, count, joined, seconds

from mrta_alliance.experiments.completion import measure_completion
from mrta_alliance.experiments.cost import measure_cost
from mrta_alliance.experiments.heterogeneous import measure_heterogeneous
from mrta_alliance.experiments.learning import measure_learning
from mrta_alliance.experiments.loss import measure_loss
from mrta_alliance.experiments.part import Options, Part
from mrta_alliance.experiments.shares import measure_shares
from mrta_alliance.experiments.takeover import measure_takeover
from rqt_mrta_py.hooks import BenchmarkReport, Laboratory

__all__ = ["PARTS", "add_arguments", "measure", "options_of"]

_log = logging.getLogger("mrta_alliance.experiments")

PARTS: Dict[str, Part] = {
    "completion": Part("missions with 0 to n-1 robots lost", measure_completion),
    "takeover": Part("take-over of a lost robot's task, against tau and phi", measure_takeover),
    "loss": Part("missions with 0 to 50 % of messages lost", measure_loss),
    "heterogeneous": Part("teams of which some robots are slow", measure_heterogeneous),
    "learning": Part("against L-ALLIANCE and simple ways to share tasks out", measure_learning),
    "shares": Part("perpetual tasks' shares of the time", measure_shares),
    "cost": Part("messages and processor time, by robots and behaviour sets", measure_cost),
}
"""All parts, by name, in the order of measuring."""

_QUICK_NUMBER = 1
_QUICK_DURATION = 250.0
_DEFAULTS = Options()


def add_arguments(parser: ArgumentParser) -> None:
    """Say what the benchmark takes."""
    add_parts_argument(parser, PARTS)
    parser.add_argument("--seeds", metavar="N", type=count, help="missions of each kind (default: 50; quick: 1)")
    parser.add_argument(
        "--application", metavar="A", default=_DEFAULTS.application, help="whose tasks end (default: %(default)s)"
    )
    parser.add_argument(
        "--patrol", metavar="A", default=_DEFAULTS.patrol, help="whose tasks are perpetual (default: %(default)s)"
    )
    parser.add_argument("--world", metavar="W", default=_DEFAULTS.world, help="where (default: %(default)s)")
    parser.add_argument(
        "--duration", metavar="S", type=seconds, help="of missions whose tasks end, at most (default: 900; quick: 250)"
    )
    parser.add_argument(
        "--courses", metavar="N", type=count, default=_DEFAULTS.courses, help="teams trained (default: %(default)s)"
    )
    parser.add_argument(
        "--lessons", metavar="N", type=count, help="missions each is trained in (default: 10; quick: 1)"
    )
    parser.add_argument("--quick", action="store_true", help="measure little of everything, to see that it works")


def options_of(told: Namespace) -> Options:
    """Read what the user asks for."""
    few = _QUICK_NUMBER if told.quick else None
    return Options(
        seeds=told.seeds or few or _DEFAULTS.seeds,
        application=told.application,
        patrol=told.patrol,
        world=told.world,
        duration=told.duration or (_QUICK_DURATION if told.quick else _DEFAULTS.duration),
        courses=1 if told.quick else told.courses,
        lessons=told.lessons or few or _DEFAULTS.lessons,
        quick=told.quick,
    )


def measure(told: Namespace, laboratory: Laboratory) -> BenchmarkReport:
    """Measure part after part."""
    options = options_of(told)
    return joined(_reports(told.parts, options, laboratory))


def _reports(parts: Sequence[str], options: Options, laboratory: Laboratory) -> Iterator[BenchmarkReport]:
    for name in parts:
        _log.info("part=%s seeds=%d: %s", name, options.seeds, PARTS[name].help)
        yield PARTS[name].measure(options, laboratory)
