"""Part ``contingency``: messages lost, with contingency handling and without (Fig. 8 of the paper)."""

from __future__ import annotations

from typing import Any, Dict, List, Tuple

from team_measures.statistics.tables import estimate_line

from mrta_demir_cf.experiments.part import Options
from mrta_demir_cf.experiments.point_team import Mission
from mrta_demir_cf.experiments.points import carry_out, estimates, random_team, row, table
from rqt_mrta_py.hooks import BenchmarkReport, Chart, Figure, Laboratory

__all__ = ["measure_contingencies"]

_LOSSES = (0.0, 0.1, 0.2, 0.3, 0.4, 0.5)
_ROBOTS = 3
_LABELS = {True: "handling on", False: "handling off"}


def measure_contingencies(options: Options, laboratory: Laboratory) -> BenchmarkReport:
    """Let three robots visit ten targets while up to half of the messages are lost; then lose a robot too."""
    losses = _LOSSES[::5] if options.quick else _LOSSES
    whole: Dict[Tuple[bool, float], List[Mission]] = {}
    broken: Dict[float, List[Mission]] = {}
    for loss in losses:
        for handling in (True, False):
            told = {"handling": handling}
            whole[handling, loss] = [
                carry_out(random_team(_ROBOTS, seed, loss=loss, parameters=told)) for seed in options.seed_numbers
            ]
        # Each seed loses another robot in turn.
        broken[loss] = [
            carry_out(random_team(_ROBOTS, seed, loss=loss), lost=f"r{seed % _ROBOTS}") for seed in options.seed_numbers
        ]
    heads = ("messages lost [%]", "handling")
    rows: List[List[Any]] = [
        [round(100 * loss), "on" if handling else "off", *row(whole[handling, loss])]
        for loss in losses
        for handling in (True, False)
    ]
    lost_rows = [[round(100 * loss), "on", *row(broken[loss])] for loss in losses]
    off = "Off: no warning, no answer to a request for what a robot carries out, nobody yields; timeouts stay on."
    return BenchmarkReport(
        (
            table("DEMiR-CF: three robots, ten targets, messages lost, on message level", heads, rows, (off,)),
            table("The same with one of three robots lost for good half-way", heads, lost_rows),
        ),
        (_figure(losses, whole),),
    )


def _figure(losses: Tuple[float, ...], missions: Dict[Tuple[bool, float], List[Mission]]) -> Figure:
    percent = [100.0 * loss for loss in losses]
    charts = []
    for name, label in (("path", "path of all [m]"), ("messages", "messages"), ("duplicates", "duplicates")):
        lines = []
        for handling in (True, False):
            known = [estimates(missions[handling, loss])[name] for loss in losses]
            lines.append(estimate_line(_LABELS[handling], percent, known))
        charts.append(Chart(tuple(lines), label, bottom=0.0))
    return Figure("demir_cf_contingency", "Messages lost, on message level", "messages lost [%]", tuple(charts))
