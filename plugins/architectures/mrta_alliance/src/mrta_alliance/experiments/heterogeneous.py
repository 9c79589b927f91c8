"""Part ``heterogeneous``: teams of which some robots are slower than anybody expects."""

from __future__ import annotations

import random
from dataclasses import replace
from typing import Any, Dict, List, Sequence, Tuple

from team_measures.statistics.estimates import Estimate, estimated_mean, estimated_share
from team_measures.statistics.tables import MEANS, SHARES, estimate_line, estimate_text, share_text

from mrta_alliance.experiments.measures import done_at
from mrta_alliance.experiments.part import Options
from rqt_mrta_py.hooks import BenchmarkReport, BenchmarkTable, Chart, Experiment, Figure, Laboratory
from rqt_mrta_py.model import ScenarioEvent, ScenarioEventKind

__all__ = ["measure_heterogeneous", "slowed"]

_DEGREES = (0.0, 0.25, 0.5, 0.75)
_RIVALS = (("ALLIANCE", "mrta_alliance", ()), ("fixed allocation", "mrta_baselines", ("rule=fixed",)))


def slowed(robots: Sequence[str], degree: float, seed: int) -> Tuple[ScenarioEvent, ...]:
    """Let each robot drive at a share of its speed from the start, evenly distributed from 1 - degree to 1.

    Args:
        robots: ids of the team.
        degree: of heterogeneity, from 0 to less than 1.
        seed: of the choice; for another degree the same robots are the slower ones.
    """
    chance = random.Random(f"slowed {seed}")
    return tuple(
        ScenarioEvent(0.0, ScenarioEventKind.ROBOT_SLOWS, robot, parameters={"factor": 1.0 - degree * chance.random()})
        for robot in robots
    )


def measure_heterogeneous(options: Options, laboratory: Laboratory) -> BenchmarkReport:
    """Slow robots down by different shares, under ALLIANCE and under an allocation that never changes."""
    degrees = _DEGREES[2:3] if options.quick else _DEGREES
    first = next(iter(laboratory.trials([options.mission(options.first_seed)])))
    robots = [robot.id for robot in first.record.robots]
    keys: List[Tuple[str, float]] = []
    experiments: List[Experiment] = []
    for label, architecture, settings in _RIVALS:
        for degree in degrees:
            for seed in options.seed_numbers:
                keys.append((label, degree))
                experiments.append(
                    replace(
                        options.mission(seed),
                        architecture=architecture,
                        settings=settings,
                        events=slowed(robots, degree, seed),
                    )
                )
    times: Dict[Tuple[str, float], List[float]] = {key: [] for key in keys}
    for key, trial in zip(keys, laboratory.trials(experiments)):
        done = done_at(trial.record)
        if done and len(done) == len(trial.record.tasks):
            times[key].append(max(done.values()))
    rows: List[Tuple[Any, ...]] = []
    lines = []
    for label, _, _ in _RIVALS:
        means: List[Any] = []
        for degree in degrees:
            found = times[label, degree]
            mean = estimated_mean(found)
            share = estimated_share(len(found), options.seeds)
            rows.append((label, round(100 * degree), options.seeds, share_text(share), estimate_text(mean)))
            means.append(mean)
        lines.append(estimate_line(label, [100 * degree for degree in degrees], _known(means)))
    table = BenchmarkTable(
        f"{options.application} with robots slower than expected",
        ("allocation", "slowed by up to [%]", "missions", "all tasks done", "time until done [s]"),
        tuple(rows),
        (
            "Each robot's speed is cut from the start by a share evenly distributed from 0 to the one given.",
            MEANS,
            SHARES,
        ),
    )
    chart = Chart(tuple(lines), "time until done [s]", bottom=0.0)
    figure = Figure("alliance_heterogeneous", "Teams of unequal robots", "slowed by up to [%]", (chart,))
    return BenchmarkReport((table,), (figure,))


def _known(means: Sequence[Any]) -> List[Any]:
    return [mean if isinstance(mean, Estimate) else None for mean in means]
