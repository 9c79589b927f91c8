"""Part ``learning``: ALLIANCE against L-ALLIANCE, and both against simple ways to share tasks out."""

from __future__ import annotations

from dataclasses import replace
from typing import Any, Dict, List, NamedTuple, Optional, Sequence, Tuple

from team_measures.statistics.estimates import Estimate, estimated_mean, estimated_share
from team_measures.statistics.tables import MEANS, SHARES, estimate_line, estimate_text, share_text

from mrta_alliance.experiments.measures import done_at, length
from mrta_alliance.experiments.part import Options
from mrta_alliance.experiments.settings import UNTUNED
from rqt_mrta_py.hooks import BenchmarkReport, BenchmarkTable, Chart, Experiment, Figure, Laboratory, LineStyle
from rqt_mrta_py.model import MissionRecord

__all__ = ["measure_learning"]

_TUNED, _UNTUNED, _LEARNED = "ALLIANCE, hand-tuned", "ALLIANCE, untuned", "L-ALLIANCE, trained"
_TRAINING_SEEDS = 100_000
"""Missions of training have seeds from here on, which no measured mission has."""


class _Rival(NamedTuple):
    """A way to share tasks out: its label, architecture, and settings."""

    label: str
    architecture: str
    settings: Tuple[str, ...] = ()


_RIVALS = (
    _Rival(_TUNED, "mrta_alliance"),
    _Rival(_UNTUNED, "mrta_alliance", UNTUNED),
    _Rival("L-ALLIANCE, untrained", "mrta_l_alliance"),
    _Rival("nearest robot", "nearest_robot"),
    _Rival("fixed allocation", "mrta_baselines", ("rule=fixed",)),
    _Rival("random allocation", "mrta_baselines", ("rule=random",)),
)


def measure_learning(options: Options, laboratory: Laboratory) -> BenchmarkReport:
    """Train teams under L-ALLIANCE, then let all rivals do the same missions."""
    first = next(iter(laboratory.trials([options.mission(options.first_seed)])))
    robots = [robot.id for robot in first.record.robots]
    courses = max(1, min(options.courses, options.seeds))
    memories = _lessons(options, laboratory, robots, courses)
    experiments: List[Experiment] = []
    labels: List[str] = []
    others = _RIVALS[2:4] if options.quick else _RIVALS[2:]
    for number, seed in enumerate(options.seed_numbers):
        trained = _Rival(_LEARNED, "mrta_l_alliance", memories[number % courses])
        for rival in (*_RIVALS[:2], trained, *others):
            mission = options.mission(seed)
            labels.append(rival.label)
            experiments.append(replace(mission, architecture=rival.architecture, settings=rival.settings))
    times: Dict[str, List[float]] = {label: [] for label in labels}
    done: Dict[str, int] = dict.fromkeys(labels, 0)
    for label, trial in zip(labels, laboratory.trials(experiments)):
        time = _time(trial.record)
        done[label] += time is not None
        times[label].append(length(trial.record) if time is None else time)
    return _report(options, courses, times, done)


def _lessons(options: Options, laboratory: Laboratory, robots: Sequence[str], courses: int) -> List[Tuple[str, ...]]:
    """Train teams; gives the settings by which each goes on with what it learned."""
    # L-ALLIANCE builds on this package, so that it is not loaded with it.
    from mrta_l_alliance.lessons import settings, train

    starts = [_TRAINING_SEEDS + 1000 * course for course in range(courses)]
    lessons = [options.mission(start) for start in starts]
    return [settings(memory, robots) for memory in train(laboratory, lessons, robots, options.lessons)]


def _time(record: MissionRecord) -> Optional[float]:
    """Give when the last task was done [s]; None if not all were."""
    times = done_at(record)
    return max(times.values()) if times and len(times) == len(record.tasks) else None


def _ratio(times: Sequence[float], others: Sequence[float]) -> Optional[Estimate]:
    """Estimate the mean over missions of how long one takes in shares of another's time."""
    return estimated_mean([time / other for time, other in zip(times, others) if other > 0.0])


def _report(options: Options, courses: int, times: Dict[str, List[float]], done: Dict[str, int]) -> BenchmarkReport:
    rows: List[Tuple[Any, ...]] = []
    means: List[Optional[Estimate]] = []
    for label, found in times.items():
        mean = estimated_mean(found)
        means.append(mean)
        rows.append(
            (
                label,
                len(found),
                share_text(estimated_share(done[label], len(found))),
                estimate_text(mean),
                estimate_text(_ratio(found, times[_UNTUNED]), 3),
                estimate_text(_ratio(found, times[_TUNED]), 3),
            )
        )
    table = BenchmarkTable(
        f"{options.application} under different ways to share tasks out",
        (
            "allocation",
            "missions",
            "all tasks done",
            "time until done [s]",
            "of untuned ALLIANCE's time",
            "of hand-tuned ALLIANCE's time",
        ),
        tuple(rows),
        (
            f"L-ALLIANCE: {courses} teams, each trained in {options.lessons} missions that are measured by nobody.",
            "Untuned: every robot and task has the parameters of ALLIANCE's template.",
            "Ratios are means over missions of one seed each. A mission that is not completed counts with its length.",
            MEANS,
            SHARES,
        ),
    )
    chart = Chart(
        (estimate_line("", list(range(len(times))), means, LineStyle.BARS),),
        "time until done [s]",
        x_ticks=tuple(times),
        bottom=0.0,
    )
    figure = Figure("alliance_learning", "Ways to share tasks out", "", (chart,))
    return BenchmarkReport((table,), (figure,))
