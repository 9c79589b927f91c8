"""Part ``shares``: which share of its time each perpetual task is carried out."""

from __future__ import annotations

from dataclasses import replace
from typing import Any, Dict, List, Tuple

from team_measures.statistics.estimates import Estimate, estimated_mean
from team_measures.statistics.tables import MEANS, estimate_line, estimate_text

from mrta_alliance.experiments.part import Options
from mrta_alliance.experiments.settings import every_set
from rqt_mrta_py.hooks import BenchmarkReport, BenchmarkTable, Chart, Figure, Laboratory, LineStyle

__all__ = ["measure_shares"]

_DURATION, _QUICK_DURATION = 240.0, 120.0
_GIVING_UP_DELAY = 20.0
_TEAMS = (1, 2, 5)
_FAIRNESSES = (0.0, 2.0)


def measure_shares(options: Options, laboratory: Laboratory) -> BenchmarkReport:
    """Give teams, smaller and larger than the number of tasks, perpetual tasks only, with and without fairness."""
    teams = _TEAMS[:1] if options.quick else _TEAMS
    duration = _QUICK_DURATION if options.quick else _DURATION
    keys: List[Tuple[int, float]] = []
    experiments = []
    for team in teams:
        for fairness in _FAIRNESSES:
            for seed in options.seed_numbers:
                settings = every_set(giving_up_delay=_GIVING_UP_DELAY, fairness=fairness)
                keys.append((team, fairness))
                experiments.append(replace(options.patrol_mission(seed, duration), robots=team, settings=settings))
    found: Dict[Tuple[int, float], Dict[str, List[float]]] = {key: {} for key in keys}
    for key, trial in zip(keys, laboratory.trials(experiments)):
        for task, share in trial.record.statistics["coverage"].items():
            found[key].setdefault(task, []).append(100.0 * (share or 0.0))
    tasks = list(next(iter(found.values())))
    means = {key: {task: estimated_mean(values) for task, values in shares.items()} for key, shares in found.items()}
    rows: List[Tuple[Any, ...]] = [
        (team, fairness, options.seeds, *(estimate_text(means[team, fairness].get(task)) for task in tasks))
        for team, fairness in means
    ]
    table = BenchmarkTable(
        f"ALLIANCE on {options.patrol}: share of the time that each perpetual task is held",
        ("robots", "fairness", "missions", *(f"{task} [%]" for task in tasks)),
        tuple(rows),
        (
            f"{duration:g} s, lambda {_GIVING_UP_DELAY:g} s for all; all else as in the application's file.",
            "Fairness 0 follows the equations: of the tasks of a free robot the one with the greatest fast rate wins "
            "again and again.",
            MEANS,
        ),
    )
    return BenchmarkReport((table,), (_figure(tasks, means),))


def _figure(tasks: List[str], means: Dict[Tuple[int, float], Dict[str, Any]]) -> Figure:
    keys = list(means)
    lines = []
    for task in tasks:
        estimates = [each if isinstance(each, Estimate) else None for each in (means[key].get(task) for key in keys)]
        lines.append(estimate_line(task, list(range(len(keys))), estimates, LineStyle.BARS))
    ticks = tuple(f"robots: {team}, fairness {fairness:g}" for team, fairness in keys)
    chart = Chart(tuple(lines), "share of the time [%]", x_ticks=ticks, bottom=0.0, top=105.0)
    return Figure("alliance_shares", "Perpetual tasks' shares of the time", "", (chart,))
