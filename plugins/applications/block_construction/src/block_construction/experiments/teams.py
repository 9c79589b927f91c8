"""Part ``teams``: a tower put up by one to four robots, with one of them lost, and under ALLIANCE."""

from __future__ import annotations

import math
from functools import lru_cache
from typing import Any, Dict, List, NamedTuple, Optional, Sequence, Tuple

import numpy as np
from team_measures.statistics.estimates import estimated_mean
from team_measures.statistics.tables import MEANS, estimate_text, rounded

from block_construction.building.place_block import PLANNED_SPEED, posts_of
from block_construction.building.procedures import STAND_OFF
from block_construction.diagram.block_set import PITCH
from block_construction.exact.planner import EXACT
from block_construction.experiments.builds import APPLICATION, build_of
from block_construction.experiments.part import Options
from block_construction.mission.drawing import draw
from block_construction.mission.fetching import ready_blocks
from block_construction.mission.precedence import precedence
from block_construction.mission.settings import SETTINGS, read_build_settings
from block_construction.mission.starts import start_poses
from block_construction.team.speed_up import Handling, Job, list_schedule
from block_construction.team.traffic import Traffic
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


class _Bounds(NamedTuple):
    """What a build could take without interference.

    Attributes:
        jobs: blocks by number.
        starts: where robots begin [m].
        traffic: measures ways.
    """

    jobs: Dict[int, Job]
    starts: Tuple[Tuple[float, float], ...]
    traffic: Traffic

    def time(self, robots: int, handling: float) -> float:
        """Give the time of a team whose robots handle each block for so long, half of it at the supply place [s]."""
        told = Handling(handling / 2.0, handling / 2.0, PLANNED_SPEED)
        return list_schedule(self.jobs, self.starts[:robots], told, self.traffic.length).time


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
    alone = _mean_time(found[cases[0]])
    bounds = _bounds(structure, sizes[-1])
    spent = bounds.time(1, 0.0)
    handling = 0.0 if alone is None else max(0.0, (alone - spent) / len(bounds.jobs))
    whole = BenchmarkTable(
        f"Teams that build the {structure}, all lengths in all corners, {len(seeds)} seeds, pose noise {_NOISE:g} m",
        (
            *("architecture", "robots", "whole builds", "blocks not in slots", "time [s]", "speed-up"),
            *("bound", "of the bound [%]", "waiting [s/block]", "way [m/block]"),
            *("idle [s/robot]", "nearest [m]", "collisions"),
        ),
        tuple(_cells(case, found[case], alone, bounds.time(case[1], handling)) for case in cases),
        (
            f"Bound: schedules without interference, {handling:.0f} s at each block beside ways, so that one robot "
            "takes as long as it took.",
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


def _mean_time(rows: Sequence[_Row]) -> Optional[float]:
    times = [row.time for row in rows if row.time is not None]
    return math.fsum(times) / len(times) if times else None


def _whole(rows: Sequence[_Row]) -> str:
    return f"{sum(row.time is not None for row in rows)} of {len(rows)}"


def _time_text(rows: Sequence[_Row]) -> Optional[str]:
    return estimate_text(estimated_mean([row.time for row in rows if row.time is not None]), 0)


def _cells(case: Tuple[str, int], rows: Sequence[_Row], alone: Optional[float], bound: float) -> Tuple[Any, ...]:
    architecture, robots = case
    times = [row.time for row in rows if row.time is not None]
    faster = None if alone is None else estimated_mean([alone / time for time in times])
    most = None if alone is None else alone / bound
    share = None if faster is None or most is None else 100.0 * faster.value / most
    waiting = estimated_mean([row.build["waiting"] / row.blocks for row in rows])
    way = estimated_mean([row.metres / row.blocks for row in rows])
    idle = estimated_mean([row.idle for row in rows if row.time is not None])
    near = [row.build["nearest"] for row in rows if row.build["nearest"] is not None]
    return (
        *(architecture, robots, _whole(rows), sum(row.blocks - row.build["placed"] for row in rows)),
        *(_time_text(rows), estimate_text(faster, 2), rounded(most), rounded(share, 0)),
        *(estimate_text(waiting), estimate_text(way, 2), estimate_text(idle, 0), rounded(min(near, default=None), 3)),
        sum(row.build["collisions"] for row in rows),
    )


@lru_cache(maxsize=None)
def _bounds(structure: str, robots: int) -> _Bounds:
    given = {"structure": structure, "supply": "corners_all", "order": "free"}
    values = {setting.name: given.get(setting.name, setting.default) for setting in SETTINGS}
    drawn = draw(read_build_settings(values, frozenset(given), robots), {"exact": EXACT}, lambda _: None)
    problem, ready = drawn.problem, ready_blocks(drawn.problem)
    before = precedence(problem)
    jobs = {
        block.number: Job(
            tuple(sorted(before[block.number])),
            problem.approaches[block.number - 1].point,
            tuple((each.place, each.stand(STAND_OFF)) for each in ready if each.units == block.units),
            frozenset((cell.x, cell.y) for cell in block.placement.cells()),
        )
        for block in problem.diagram.blocks
    }
    starts = tuple((pose.x, pose.y) for pose in start_poses(problem, ready, robots))
    arena = problem.arena
    posts = posts_of([(each.x, each.y) for each in ready])
    traffic = Traffic(arena.side, problem.site, arena.robot_radius, PLANNED_SPEED, PITCH, posts=posts)
    return _Bounds(jobs, starts, traffic)
