"""Part ``map``: robots that know the map, and robots that map what they see (Fig. 9 of the paper)."""

from __future__ import annotations

from typing import Any, Dict, List, Tuple

from team_measures.statistics.tables import MEANS, estimate_line

from mrta_demir_cf.experiments.part import Options
from mrta_demir_cf.experiments.simulated import COLUMNS, SimulatedMission, estimates, row, summed_up
from mrta_demir_cf.experiments.simulation import reachable_targets
from rqt_mrta_py.hooks import BenchmarkReport, BenchmarkTable, Chart, Experiment, Figure, Laboratory, LineStyle
from rqt_mrta_py.model import MapKnowledge

__all__ = ["measure_maps"]

_ROBOTS = 3


def measure_maps(options: Options, laboratory: Laboratory) -> BenchmarkReport:
    """Let three robots visit all targets, those out of reach among them, with a known map and with an unknown one."""
    wanted = len(reachable_targets(options, laboratory))
    found: Dict[MapKnowledge, List[SimulatedMission]] = {}
    for knowledge in (MapKnowledge.KNOWN, MapKnowledge.UNKNOWN):
        missions = [
            Experiment(
                options.application,
                seed,
                architecture="mrta_demir_cf",
                duration=options.duration,
                world=options.world,
                robots=_ROBOTS,
                events=(),
                map=knowledge,
            )
            for seed in options.seed_numbers
        ]
        found[knowledge] = [summed_up(trial, wanted) for trial in laboratory.trials(missions)]
    rows: List[Tuple[Any, ...]] = [(knowledge.value, *row(missions)) for knowledge, missions in found.items()]
    table = BenchmarkTable(
        f"DEMiR-CF on {options.application}: {_ROBOTS} robots, with a map and without, simulated in {options.world}",
        ("map", *COLUMNS),
        tuple(rows),
        (
            f"{wanted} targets can be reached; of the others it is counted how often robots announce that.",
            "The path is that of the whole mission, which ends when nothing is left to be done or after "
            f"{options.duration:g} s.",
            MEANS,
        ),
    )
    numbers = [float(number) for number in range(len(found))]
    names = tuple(knowledge.value for knowledge in found)
    charts = tuple(
        Chart(
            (estimate_line("", numbers, [estimates(missions)[name] for missions in found.values()], LineStyle.BARS),),
            label,
            x_ticks=names,
            bottom=0.0,
        )
        for name, label in (
            ("path", "path of all [m]"),
            ("time", "time [s]"),
            ("reallocations", "reallocations"),
            ("unreachable", "found unreachable"),
        )
    )
    return BenchmarkReport(
        (table,), (Figure("demir_cf_map", f"{options.application}, with a map and without", "map", charts),)
    )
