"""Part ``team_size``: how path, messages and time change with the number of robots (Fig. 7 of the paper)."""

from __future__ import annotations

from typing import Dict, List

from team_measures.statistics.tables import estimate_line

from mrta_demir_cf.experiments.part import Options
from mrta_demir_cf.experiments.point_team import Mission
from mrta_demir_cf.experiments.points import carry_out, estimates, random_team, row, table
from rqt_mrta_py.hooks import BenchmarkReport, Chart, Figure, Laboratory

__all__ = ["measure_team_sizes"]

_SIZES = (1, 2, 3, 5, 8)


def measure_team_sizes(options: Options, laboratory: Laboratory) -> BenchmarkReport:
    """Let teams of one to eight robots visit ten targets; no message is lost."""
    sizes = _SIZES[1:3] if options.quick else _SIZES
    missions: Dict[int, List[Mission]] = {
        size: [carry_out(random_team(size, seed)) for seed in options.seed_numbers] for size in sizes
    }
    rows = [[size, *row(missions[size])] for size in sizes]
    known = [estimates(missions[size]) for size in sizes]
    charts = tuple(
        Chart((estimate_line("", sizes, [each[name] for each in known]),), label, bottom=0.0)
        for name, label in (("path", "path of all [m]"), ("time", "time [s]"), ("messages", "messages"))
    )
    return BenchmarkReport(
        (table("DEMiR-CF: ten targets and teams of several sizes, on message level", ("robots",), rows),),
        (Figure("demir_cf_team_size", "Ten targets, on message level", "robots", charts),),
    )
