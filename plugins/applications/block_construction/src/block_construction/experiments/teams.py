"""Part ``teams``: a tower put up by one to four robots, with one of them lost, and under ALLIANCE."""

from __future__ import annotations

import math
from typing import Any, List, Mapping, NamedTuple, Optional, Sequence, Tuple

import numpy as np
from team_measures.statistics.estimates import estimated_mean
from team_measures.statistics.tables import MEANS, estimate_text, rounded

from block_construction.building.procedures import TRAVEL_SPEED
from block_construction.experiments.builds import APPLICATION, build_of
from block_construction.experiments.part import Options
from block_construction.experiments.undisturbed import undisturbed
from block_construction.team.speed_up import Handling
from rqt_mrta_py.hooks import BenchmarkReport, BenchmarkTable, Experiment, Laboratory, Trial
from rqt_mrta_py.model import ScenarioEvent, ScenarioEventKind, TaskState

__all__ = ["measure_teams"]

_SEEDS = 20
_SIZES, _FEW_SIZES = (1, 2, 3, 4), (1, 2)
_LOST_OF = 3
_EARLIEST, _LATEST = 100.0, 600.0
"""Between which moments a robot is lost [s]."""
_REMOVED_AFTER = 60.0
_ARCHITECTURE, _OTHER = "mrta_demir_cf", "mrta_alliance"
_NOISE = 0.002


class _Measure(NamedTuple):
    """What teams are held against.

    Attributes:
        time: of one robot [s]; None if it never built it whole.
        without: times of teams without interference [s], by how many robots.
        ways: without interference, with what one robot drives beyond its schedule [m/block], likewise; not a number
            if it never built it whole.
        handling: of each block beside ways [s].
    """

    time: Optional[float]
    without: Mapping[int, float]
    ways: Mapping[int, float]
    handling: Handling


class _Row(NamedTuple):
    """What one mission came to.

    Attributes:
        time: until the last block was placed [s]; None if it was not.
        build: what the measure says.
        blocks: how many there are to be.
        robots: how many built.
    """

    time: Optional[float]
    build: Any
    blocks: int
    robots: int

    @property
    def metres(self) -> float:
        """Way of all robots [m]."""
        return float(self.build["fetching"]["metres"] + self.build["placing"]["metres"])

    @property
    def idle(self) -> float:
        """Time in which robots had no block to care for, of each [s]."""
        busy = self.build["fetching"]["seconds"] + self.build["placing"]["seconds"]
        return max(0.0, (self.time or 0.0) - float(busy) / self.robots)


def measure_teams(options: Options, laboratory: Laboratory) -> BenchmarkReport:
    """Let teams build a tower; lose one of three robots; do the same under ALLIANCE."""
    structure, sizes = ("wall", _FEW_SIZES) if options.quick else ("tower", _SIZES)
    seeds = range(options.repetitions(_SEEDS))
    cases = [(_ARCHITECTURE, size) for size in sizes] + [(_OTHER, size) for size in sizes[1:]]
    experiments = [_experiment(structure, size, seed, architecture=name) for name, size in cases for seed in seeds]
    trials = laboratory.trials(experiments)
    found = {case: [_row(next(trials)) for _ in seeds] for case in cases}
    measure = _measure(structure, sizes, found[cases[0]])
    whole = BenchmarkTable(
        f"Teams that build the {structure}, all lengths in all corners, {len(seeds)} seeds, pose noise {_NOISE:g} m",
        (
            *("architecture", "robots", "whole builds", "blocks not in slots", "time [s]", "speed-up"),
            *("without interference", "of it [%]", "waiting [s/block]", "way [m/block]"),
            *("detour [m/block]", "detour [s/block]", "idle [s/robot]", "nearest [m]", "collisions"),
        ),
        tuple(_cells(case, found[case], measure) for case in cases),
        (
            "Without interference: speed-up of greedy schedules; no proved bound. Each block takes "
            f"{measure.handling.fetching:.0f} s at its supply place and {measure.handling.placing:.0f} s elsewhere, "
            "beside ways: fitted to the time of one robot.",
            f"Detour: way beyond that of such a schedule, in whole builds; seconds at {TRAVEL_SPEED:g} m/s. What one "
            "robot drives beyond its own schedule does not count.",
            "Nearest: least distance of two robots' middles, as they believe. Collisions: what their bumpers felt.",
            "Idle: without a block to care for, of each robot. Waiting: for a way.",
            MEANS,
        ),
    )
    lost = _lost(structure, min(_LOST_OF, sizes[-1]), seeds, laboratory)
    return BenchmarkReport((whole, lost))


def _experiment(
    structure: str,
    robots: int,
    seed: int,
    architecture: str = _ARCHITECTURE,
    events: Optional[Tuple[ScenarioEvent, ...]] = None,
) -> Experiment:
    settings = (f"structure={structure}", "supply=corners_all", "order=free", f"pose_noise={_NOISE}")
    return Experiment(APPLICATION, seed, architecture, robots=robots, settings=settings, events=events)


def _lost(structure: str, robots: int, seeds: Sequence[int], laboratory: Laboratory) -> BenchmarkTable:
    """Stop one robot at a time drawn from the seed, with somebody who removes it, or nobody."""
    rows: List[Tuple[Any, ...]] = []
    for label, removed in (("removed after 60 s", True), ("stays where it is", False)):
        experiments = [_experiment(structure, robots, seed, events=_loss(robots, seed, removed)) for seed in seeds]
        found = [_row(trial) for trial in laboratory.trials(experiments)]
        placed = estimated_mean([100.0 * row.build["placed"] / row.blocks for row in found])
        felt = sum(row.build["collisions"] for row in found)
        rows.append((robots, label, _whole(found), estimate_text(placed), _time_text(found), felt))
    return BenchmarkTable(
        f"One robot lost while the {structure} is built",
        ("robots", "the lost one", "whole builds", "blocks in slots [%]", "time [s]", "collisions"),
        tuple(rows),
        (
            f"It stops at a moment drawn from {_EARLIEST:g} to {_LATEST:g} s, each robot in turn.",
            "Who stays may close docks for good: blocks that are placed from there cannot be placed then.",
            MEANS,
        ),
    )


def _loss(robots: int, seed: int, removed: bool) -> Tuple[ScenarioEvent, ...]:
    moment = round(float(np.random.default_rng([robots, seed]).uniform(_EARLIEST, _LATEST)), 1)
    victim = f"robot{seed % robots + 1}"
    stop = ScenarioEvent(moment, ScenarioEventKind.ROBOT_STOPS, victim)
    if not removed:
        return (stop,)
    return stop, ScenarioEvent(moment + _REMOVED_AFTER, ScenarioEventKind.ROBOT_REMOVED, victim)


def _row(trial: Trial) -> _Row:
    record, build = trial.record, build_of(trial)
    done = [task.history[-1].start for task in record.tasks if task.state is TaskState.DONE]
    whole = build["placed"] == build["blocks"] == len(done)
    time = max(done) - (record.start or 0.0) if whole else None
    return _Row(time, build, int(build["blocks"]), len(record.robots))


def _measure(structure: str, sizes: Sequence[int], alone: Sequence[_Row]) -> _Measure:
    """Reckon builds without interference, fitted to those of one robot."""
    build, time = undisturbed(structure, sizes[-1]), _mean_time(alone)
    whole = [row for row in alone if row.time is not None]
    fetching, driven = 0.0, math.nan
    if whole:
        fetching = math.fsum(row.build["fetching"]["seconds"] for row in whole) / len(whole)
        driven = math.fsum(row.metres / row.blocks for row in whole) / len(whole)
    handling = Handling(0.0, 0.0, build.speed) if time is None else build.handling(time, fetching)
    schedules = {robots: build.schedule(robots, handling) for robots in sizes}
    ways = {robots: (each.fetching + each.placing) / len(build.jobs) for robots, each in schedules.items()}
    return _Measure(
        time,
        {robots: each.time for robots, each in schedules.items()},
        {robots: way - ways[1] + driven for robots, way in ways.items()},
        handling,
    )


def _mean_time(rows: Sequence[_Row]) -> Optional[float]:
    times = [row.time for row in rows if row.time is not None]
    return math.fsum(times) / len(times) if times else None


def _whole(rows: Sequence[_Row]) -> str:
    return f"{sum(row.time is not None for row in rows)} of {len(rows)}"


def _time_text(rows: Sequence[_Row]) -> Optional[str]:
    return estimate_text(estimated_mean([row.time for row in rows if row.time is not None]), 0)


def _cells(case: Tuple[str, int], rows: Sequence[_Row], measure: _Measure) -> Tuple[Any, ...]:
    architecture, robots = case
    alone = measure.time
    times = [row.time for row in rows if row.time is not None]
    faster = None if alone is None else estimated_mean([alone / time for time in times])
    most = None if alone is None else alone / measure.without[robots]
    share = None if faster is None or most is None else 100.0 * faster.value / most
    waiting = estimated_mean([row.build["waiting"] / row.blocks for row in rows])
    way = estimated_mean([row.metres / row.blocks for row in rows])
    whole = [] if alone is None or robots == 1 else [row for row in rows if row.time is not None]
    detours = [row.metres / row.blocks - measure.ways[robots] for row in whole]
    detour = estimated_mean(detours), estimated_mean([each / TRAVEL_SPEED for each in detours])
    idle = estimated_mean([row.idle for row in rows if row.time is not None])
    near = [row.build["nearest"] for row in rows if row.build["nearest"] is not None]
    return (
        *(architecture, robots, _whole(rows), sum(row.blocks - row.build["placed"] for row in rows)),
        *(_time_text(rows), estimate_text(faster, 2), rounded(most), rounded(share, 0)),
        *(estimate_text(waiting), estimate_text(way, 2), estimate_text(detour[0], 2), estimate_text(detour[1])),
        *(estimate_text(idle, 0), rounded(min(near, default=None), 3)),
        sum(row.build["collisions"] for row in rows),
    )
