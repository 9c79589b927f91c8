"""Part ``failure``: six targets, one robot, three, and three of which one is lost (Fig. 10 of the paper)."""

from __future__ import annotations

from typing import Dict, List, Optional, Tuple

from team_measures.statistics.tables import estimate_line

from mrta_demir_cf.experiments.part import Options
from mrta_demir_cf.experiments.point_team import Mission
from mrta_demir_cf.experiments.points import carry_out, estimates, random_team, row, table
from rqt_mrta_py.hooks import BenchmarkReport, Chart, Figure, Laboratory, LineStyle

__all__ = ["measure_failures"]

_TARGETS = 6
_CASES: Tuple[Tuple[str, int, bool], ...] = (("one robot", 1, False), ("three", 3, False), ("three, one lost", 3, True))


def measure_failures(options: Options, laboratory: Laboratory) -> BenchmarkReport:
    """Let one robot and three visit six targets; of three lose one when half of the targets have been visited."""
    missions: Dict[str, List[Mission]] = {}
    for label, robots, fails in _CASES:
        missions[label] = [
            carry_out(random_team(robots, seed, _TARGETS), _victim(seed, robots) if fails else None)
            for seed in options.seed_numbers
        ]
    rows = [[label, *row(missions[label])] for label, _, _ in _CASES]
    numbers = [float(number) for number in range(len(_CASES))]
    names = tuple(label for label, _, _ in _CASES)
    charts = tuple(
        Chart(
            (estimate_line("", numbers, [estimates(missions[label])[name] for label in names], LineStyle.BARS),),
            text,
            x_ticks=names,
            bottom=0.0,
        )
        for name, text in (("time", "time [s]"), ("path", "path of all [m]"))
    )
    return BenchmarkReport(
        (table("DEMiR-CF: six targets, on message level", ("team",), rows),),
        (Figure("demir_cf_failure", "Six targets, on message level", "team", charts),),
    )


def _victim(seed: int, robots: int) -> Optional[str]:
    """Let each seed lose another robot in turn."""
    return f"r{seed % robots}"
