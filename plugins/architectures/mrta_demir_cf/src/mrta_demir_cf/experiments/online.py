"""Part ``online``: targets that turn up while robots are at work."""

from __future__ import annotations

from typing import Any, List

import numpy as np

from mrta_demir_cf.experiments.part import Options
from mrta_demir_cf.experiments.point_team import Mission
from mrta_demir_cf.experiments.points import LONGEST, random_team, row, table
from rqt_mrta_py.hooks import BenchmarkReport, Laboratory

__all__ = ["measure_online_tasks"]

_ROBOTS, _TARGETS = 3, 10
_LATER = (0, 2, 5)
"""How many of the targets turn up on the way."""
_LATEST = 60.0
"""When the last of them turns up [s]."""


def measure_online_tasks(options: Options, laboratory: Laboratory) -> BenchmarkReport:
    """Let three robots visit ten targets of which some turn up at random moments of the first minute."""
    numbers = _LATER[1:2] if options.quick else _LATER
    rows: List[List[Any]] = []
    for number in numbers:
        missions = [_mission(seed, number) for seed in options.seed_numbers]
        rows.append([number, *row(missions)])
    notes = (f"They turn up at moments evenly distributed over the first {_LATEST:g} s.",)
    title = "DEMiR-CF: three robots, ten targets of which some turn up on the way, on message level"
    return BenchmarkReport((table(title, ("on line",), rows, notes),))


def _mission(seed: int, number: int) -> Mission:
    team = random_team(_ROBOTS, seed, _TARGETS, later=range(_TARGETS - number, _TARGETS))
    moments = sorted(np.random.default_rng([number, seed]).uniform(0.0, _LATEST, number).tolist())
    begin = team.now
    for target, moment in zip(range(_TARGETS - number, _TARGETS), moments):
        while team.now - begin < moment:
            team.step()
        team.appear(f"t{target:02d}")
    return team.run(LONGEST)
