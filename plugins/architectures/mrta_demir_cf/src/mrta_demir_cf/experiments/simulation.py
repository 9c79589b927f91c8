"""Part ``simulation``: teams of several sizes and a robot that fails, simulated (Figs 7 and 10 of the paper)."""

from __future__ import annotations

from dataclasses import replace
from typing import Any, Dict, List, Tuple

from team_measures.statistics.tables import MEANS, estimate_line

from mrta_demir_cf.experiments.part import Options
from mrta_demir_cf.experiments.simulated import COLUMNS, SimulatedMission, estimates, row, summed_up
from rqt_mrta_py.hooks import BenchmarkReport, BenchmarkTable, Chart, Experiment, Figure, Laboratory
from rqt_mrta_py.model import ScenarioEvent, ScenarioEventKind, TaskState

__all__ = ["measure_simulation", "reachable_targets"]

_SIZES = (1, 2, 3, 5)
_ARCHITECTURE = "mrta_demir_cf"


def measure_simulation(options: Options, laboratory: Laboratory) -> BenchmarkReport:
    """Let teams visit all targets that can be reached; of the largest lose a robot half-way."""
    targets = reachable_targets(options, laboratory)
    sizes = _SIZES[1:2] if options.quick else _SIZES
    missions = {
        size: [
            Experiment(
                options.application,
                seed,
                architecture=_ARCHITECTURE,
                duration=options.duration,
                world=options.world,
                robots=size,
                events=(),
                tasks=targets,
            )
            for seed in options.seed_numbers
        ]
        for size in sizes
    }
    whole: Dict[int, List[SimulatedMission]] = {size: [] for size in sizes}
    broken: List[Experiment] = []
    for size in sizes:
        for trial in laboratory.trials(missions[size]):
            mission = summed_up(trial, len(targets))
            whole[size].append(mission)
            if size == sizes[-1]:
                robots = [robot.id for robot in trial.record.robots]
                victim = robots[trial.experiment.seed % len(robots)]
                stop = ScenarioEvent(round(mission.time / 2.0, 3), ScenarioEventKind.ROBOT_STOPS, victim)
                broken.append(replace(trial.experiment, events=(stop,)))
    lost = [summed_up(trial, len(targets)) for trial in laboratory.trials(broken)]
    rows: List[Tuple[Any, ...]] = [(str(size), *row(whole[size])) for size in sizes]
    rows.append((f"{sizes[-1]}, one lost half-way", *row(lost)))
    table = BenchmarkTable(
        f"DEMiR-CF on {options.application}: {len(targets)} targets, simulated in the world {options.world}",
        ("robots", *COLUMNS),
        tuple(rows),
        ("Starts are those of the application; seeds differ in the noise of sensors.", MEANS),
    )
    charts = tuple(
        Chart((estimate_line("", sizes, [estimates(whole[size])[name] for size in sizes]),), label, bottom=0.0)
        for name, label in (("path", "path of all [m]"), ("time", "time [s]"))
    )
    return BenchmarkReport(
        (table,), (Figure("demir_cf_simulation", f"{options.application}, simulated", "robots", charts),)
    )


def reachable_targets(options: Options, laboratory: Laboratory) -> Tuple[str, ...]:
    """List the targets that a team with a known map visits in one mission; all others are out of reach."""
    first = Experiment(
        options.application, 0, architecture=_ARCHITECTURE, duration=options.duration, world=options.world, events=()
    )
    record = next(iter(laboratory.trials([first]))).record
    return tuple(task.id for task in record.tasks if task.state is TaskState.DONE)
