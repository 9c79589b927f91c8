"""Part ``completion``: whether a mission is completed, and how late, while robots are lost."""

from __future__ import annotations

from dataclasses import replace
from typing import Any, FrozenSet, List, NamedTuple, Tuple

from team_measures.statistics.estimates import Estimate, estimated_mean, estimated_share
from team_measures.statistics.tables import MEANS, SHARES, estimate_line, estimate_text, rounded, share_text

from mrta_alliance.experiments.ability import abilities, within_reach
from mrta_alliance.experiments.measures import done_at, done_tasks
from mrta_alliance.experiments.part import Options
from mrta_alliance.experiments.stops import random_stops
from rqt_mrta_py.hooks import BenchmarkReport, BenchmarkTable, Chart, Experiment, Figure, Laboratory, LineStyle
from rqt_mrta_py.model import MissionRecord

__all__ = ["measure_completion"]

_COLUMNS = (
    "robots lost",
    "missions",
    "all within reach done",
    "all tasks done",
    "time until done [s]",
    "longest [s]",
)


class _Case(NamedTuple):
    """One mission, and what those left alive in it can carry out."""

    experiment: Experiment
    lost: int
    reach: FrozenSet[str]


class _Outcome(NamedTuple):
    """What came of one mission: whether all within reach was done, whether all was, and when the last of it [s]."""

    reached: bool
    complete: bool
    time: float


def measure_completion(options: Options, laboratory: Laboratory) -> BenchmarkReport:
    """Lose 0 to n-1 of n robots at random moments of the mission, and see what is carried out."""
    whole = list(laboratory.trials([options.mission(seed) for seed in options.seed_numbers]))
    robots = [robot.id for robot in whole[0].record.robots]
    able = abilities(laboratory, options.mission(options.first_seed), robots)
    everything = frozenset(task.id for task in whole[0].record.tasks)
    outcomes: List[List[_Outcome]] = [[_outcome(trial.record, within_reach(able, robots)) for trial in whole]]
    cases: List[_Case] = []
    for lost in _numbers_lost(len(robots), options.quick):
        for trial in whole:
            seed = trial.experiment.seed
            latest = max(done_at(trial.record).values(), default=0.0)
            events = random_stops(robots, lost, latest, seed)
            left = [robot for robot in robots if robot not in {event.robot for event in events}]
            cases.append(_Case(replace(options.mission(seed), events=events), lost, within_reach(able, left)))
        outcomes.append([])
    for case, trial in zip(cases, laboratory.trials([case.experiment for case in cases])):
        place = 1 + _numbers_lost(len(robots), options.quick).index(case.lost)
        outcomes[place].append(_outcome(trial.record, case.reach))
    lost_numbers = [0, *_numbers_lost(len(robots), options.quick)]
    rows: List[Tuple[Any, ...]] = []
    reached, times = [], []
    for lost, found in zip(lost_numbers, outcomes):
        share = estimated_share(sum(each.reached for each in found), len(found))
        time = estimated_mean([each.time for each in found if each.reached])
        longest = max((each.time for each in found if each.reached), default=None)
        complete = estimated_share(sum(each.complete for each in found), len(found))
        rows.append((lost, len(found), share_text(share), share_text(complete), estimate_text(time), rounded(longest)))
        reached.append(share)
        times.append(time)
    table = BenchmarkTable(
        f"ALLIANCE on {options.application}: {len(robots)} robots, {len(everything)} tasks, robots lost for good",
        _COLUMNS,
        tuple(rows),
        (
            "Robots stop at moments evenly distributed over the undisturbed mission of the same seed.",
            "Within reach is what at least one of the robots left alive carries out when it is alone from the start.",
            "The time is that at which the last task within reach was done, of missions in which all of them were.",
            MEANS,
            SHARES,
        ),
    )
    return BenchmarkReport((table,), (_figure(lost_numbers, reached, times),))


def _numbers_lost(robots: int, quick: bool) -> List[int]:
    numbers = list(range(1, robots))
    return numbers[-1:] if quick else numbers


def _outcome(record: MissionRecord, reach: FrozenSet[str]) -> _Outcome:
    times = done_at(record)
    last = max((times[task] for task in reach if task in times), default=0.0)
    return _Outcome(reach <= done_tasks(record), all(task.id in times for task in record.tasks), last)


def _figure(lost: List[int], reached: List[Any], times: List[Any]) -> Figure:
    shares = [
        None if each is None else Estimate(100 * each.value, 100 * each.low, 100 * each.high, each.number)
        for each in reached
    ]
    return Figure(
        "alliance_completion",
        "Missions while robots are lost",
        "robots lost",
        (
            Chart((estimate_line("", lost, times),), "time until done [s]", bottom=0.0),
            Chart(
                (estimate_line("", lost, shares, LineStyle.POINTS),),
                "missions with all within reach done [%]",
                bottom=0.0,
                top=105.0,
            ),
        ),
    )
