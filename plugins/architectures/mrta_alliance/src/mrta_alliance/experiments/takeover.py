"""Part ``takeover``: how soon another robot takes up the task of one that is lost."""

from __future__ import annotations

import math
import random
from dataclasses import replace
from typing import Any, List, NamedTuple, Optional, Sequence, Tuple

from team_measures.statistics.estimates import estimated_mean
from team_measures.statistics.quantiles import quantile
from team_measures.statistics.tables import MEANS, estimate_line, estimate_text, rounded

from mrta_alliance.experiments.measures import holder_at, length, takeover_time
from mrta_alliance.experiments.part import Options
from mrta_alliance.experiments.settings import every_set
from mrta_alliance.parameters import AllianceParameters, BehaviourSetParameters
from rqt_mrta_py.hooks import BenchmarkReport, BenchmarkTable, Chart, Experiment, Figure, Laboratory, Line, LineStyle
from rqt_mrta_py.model import RadioSetup, ScenarioEvent, ScenarioEventKind

__all__ = ["Takeover", "bound_on_takeover", "measure_takeover", "takeovers"]

_SPIN_RATE = AllianceParameters.spin_rate
_BROADCAST_RATE = AllianceParameters.broadcast_rate
_THRESHOLD = BehaviourSetParameters.threshold
_FAST_RATE = BehaviourSetParameters.fast_rate
_TAUS = (2.0, 3.0, 5.0, 8.0)
_PHIS = (300.0, 600.0, 1200.0, 2400.0)
_TAU, _PHI = 3.0, 1200.0
_SETTLED, _LATEST = 20.0, 35.0
"""Between these moments a robot is lost; by the first every task is held [s]."""
_SLACK = 10.0
_LONG_YIELDING = 600.0
_COLUMNS = ("losses", "taken over", "mean [s]", "least [s]", "median [s]", "greatest [s]", "bound [s]", "within")


class Takeover(NamedTuple):
    """One loss: of whom, of what, when, and what came of it.

    Attributes:
        seed: of the mission.
        robot, task: who was lost while it held what.
        time: until another robot announced the task; None if none did [s].
    """

    seed: int
    robot: str
    task: str
    time: Optional[float]


class _Sweep(NamedTuple):
    """Losses under several values of one parameter.

    Attributes:
        name: of the parameter.
        rest: what the other one is, in words.
        values: of the parameter [s].
        found: losses, for each of them.
        bounds: on the time of take-over, for each of them [s].
    """

    name: str
    rest: str
    values: Sequence[float]
    found: Sequence[Sequence[Takeover]]
    bounds: Sequence[float]


def bound_on_takeover(tau: float, threshold: float, fast_rate: float, spin_rate: float, broadcast_rate: float) -> float:
    """Give the longest time from the loss of a robot to the announcement of another, without loss of messages.

    tau + theta / (delta_fast rho) + 1 / rho bounds the time from its last announcement to the activation of another
    robot's behaviour set that is applicable and not inhibited. What is announced is heard at most a period of
    broadcasts and a cycle later.

    Args:
        tau: silence after which a robot counts as stopped [s].
        threshold: theta [1].
        fast_rate: delta_fast, of the slowest of the robots that are free [1].
        spin_rate: rho [Hz].
        broadcast_rate: [Hz].
    """
    return tau + threshold / (fast_rate * spin_rate) + 2.0 / spin_rate + 1.0 / broadcast_rate


def measure_takeover(options: Options, laboratory: Laboratory) -> BenchmarkReport:
    """Stop a robot while it holds a task, under several tau and several phi."""
    taus, phis = (_TAUS[1:2], _PHIS[:1]) if options.quick else (_TAUS, _PHIS)
    sweeps = (
        _Sweep(
            "tau",
            f"phi = {_PHI:g} s",
            taus,
            [takeovers(options, laboratory, tau, _PHI) for tau in taus],
            [_bound(tau) for tau in taus],
        ),
        _Sweep(
            "phi",
            f"tau = {_TAU:g} s",
            phis,
            [takeovers(options, laboratory, _TAU, phi) for phi in phis],
            [_bound(_TAU)] * len(phis),
        ),
    )
    return BenchmarkReport(tuple(_table(options, sweep) for sweep in sweeps), tuple(_figure(sweep) for sweep in sweeps))


def takeovers(
    options: Options, laboratory: Laboratory, tau: float, phi: float, radio: Optional[RadioSetup] = None
) -> List[Takeover]:
    """Lose one robot in each mission while it holds a task, both chosen by the mission's seed.

    Who holds what is seen in a mission to which nothing happens; up to the loss both are the same, byte for byte.

    Args:
        options: how many, where.
        laboratory: carries the missions out.
        tau: silence after which a robot counts as stopped [s].
        phi: expected duration that all announce [s].
        radio: between robots; None for the scenario's.
    """
    settings = (
        f"timeout_duration={tau!r}",
        f"buffer_horizon={max(10.0, tau)!r}",
        f"spin_rate={_SPIN_RATE!r}",
        f"broadcast_rate={_BROADCAST_RATE!r}",
        *every_set(
            task_expected_duration=phi,
            threshold=_THRESHOLD,
            fast_rate=_FAST_RATE,
            head_start=0.5,
            yielding_delay=_LONG_YIELDING,
            giving_up_delay=_LONG_YIELDING,
        ),
    )
    base = [
        replace(options.patrol_mission(seed, _LATEST + 1.0), settings=settings, radio=radio)
        for seed in options.seed_numbers
    ]
    chosen: List[Tuple[int, float, str, str]] = []
    lost: List[Experiment] = []
    for trial in laboratory.trials(base):
        seed = trial.experiment.seed
        chance = random.Random(f"takeover {seed}")
        moment = round(chance.uniform(_SETTLED, min(_LATEST, length(trial.record))), 3)
        start = trial.record.start or 0.0
        holders = [holder_at(trial.record.allocations, task.id, start + moment) for task in trial.record.tasks]
        held = [each for each in holders if each is not None]
        if not held:
            continue
        one = chance.choice(held)
        chosen.append((seed, moment, one.robot, one.task))
        stop = ScenarioEvent(moment, ScenarioEventKind.ROBOT_STOPS, one.robot)
        duration = moment + _bound(tau) + (_SLACK if radio is None else 3 * _SLACK)
        lost.append(replace(trial.experiment, events=(stop,), duration=duration))
    return [
        Takeover(seed, robot, task, takeover_time(trial.record, task, robot, moment))
        for (seed, moment, robot, task), trial in zip(chosen, laboratory.trials(lost))
    ]


def _bound(tau: float) -> float:
    return bound_on_takeover(tau, _THRESHOLD, _FAST_RATE, _SPIN_RATE, _BROADCAST_RATE)


def _table(options: Options, sweep: _Sweep) -> BenchmarkTable:
    rows: List[Tuple[Any, ...]] = []
    for value, losses, bound in zip(sweep.values, sweep.found, sweep.bounds):
        times = _times(losses)
        within = sum(time <= bound for time in times)
        spread = [rounded(quantile(times, share)) for share in (0.0, 0.5, 1.0)]
        mean = estimate_text(estimated_mean(times), 2)
        rows.append((value, len(losses), len(times), mean, *spread, rounded(bound), f"{within} of {len(losses)}"))
    return BenchmarkTable(
        f"ALLIANCE on {options.patrol}: from the loss of a robot to the take-over of its task, against {sweep.name}, "
        f"at {sweep.rest}",
        (f"{sweep.name} [s]", *_COLUMNS),
        tuple(rows),
        (
            f"All robots: theta {_THRESHOLD:g}, fast rate {_FAST_RATE:g}, head start 0.5, spin rate {_SPIN_RATE:g} Hz, "
            f"broadcast rate {_BROADCAST_RATE:g} Hz, psi and lambda {_LONG_YIELDING:g} s.",
            "The bound is tau + theta / (fast rate x spin rate) + one cycle, and one cycle and one period of "
            "broadcasts more, until the take-over is heard.",
            "Motivation grows slowly, at theta / phi a cycle, while the robot is at work: the smaller phi, the less is "
            "left to grow.",
            MEANS,
        ),
    )


def _figure(sweep: _Sweep) -> Figure:
    x = tuple(sweep.values)
    times = [_times(losses) for losses in sweep.found]
    lines = (
        estimate_line("mean", x, [estimated_mean(each) for each in times]),
        Line("greatest", x, tuple(max(each, default=math.nan) for each in times), style=LineStyle.POINTS),
        Line("bound", x, tuple(sweep.bounds), colour=Line.REFERENCE),
    )
    return Figure(
        f"alliance_takeover_{sweep.name}",
        f"Take-over against {sweep.name}, at {sweep.rest}",
        f"{sweep.name} [s]",
        (Chart(lines, "take-over [s]", bottom=0.0),),
    )


def _times(losses: Sequence[Takeover]) -> List[float]:
    return [each.time for each in losses if each.time is not None]
