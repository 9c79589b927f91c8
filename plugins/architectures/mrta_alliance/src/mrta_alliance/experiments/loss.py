"""Part ``loss``: missions while messages between robots are lost."""

from __future__ import annotations

from dataclasses import replace
from typing import Any, Dict, List, Sequence, Tuple

from team_measures.statistics.estimates import estimated_mean, estimated_share
from team_measures.statistics.quantiles import quantile
from team_measures.statistics.tables import MEANS, SHARES, estimate_line, estimate_text, rounded, share_text

from mrta_alliance.experiments.measures import done_at, double_holdings
from mrta_alliance.experiments.part import Options
from mrta_alliance.experiments.takeover import Takeover, takeovers
from rqt_mrta_py.hooks import BenchmarkReport, BenchmarkTable, Chart, Figure, Laboratory, Line, LineStyle
from rqt_mrta_py.model import MissionRecord, RadioSetup

__all__ = ["measure_loss"]

_LOSSES = (0.0, 0.1, 0.2, 0.3, 0.4, 0.5)
_TAU, _PHI = 3.0, 1200.0
_QUANTILES = (0.0, 0.1, 0.5, 0.9, 1.0)


def measure_loss(options: Options, laboratory: Laboratory) -> BenchmarkReport:
    """Lose 0 to 50 % of all messages between robots."""
    losses = _LOSSES[::5] if options.quick else _LOSSES
    experiments = [
        replace(options.mission(seed), radio=_radio(loss)) for loss in losses for seed in options.seed_numbers
    ]
    found: Dict[float, List[MissionRecord]] = {loss: [] for loss in losses}
    for number, trial in enumerate(laboratory.trials(experiments)):
        found[losses[number // options.seeds]].append(trial.record)
    by_loss = [takeovers(options, laboratory, _TAU, _PHI, _radio(loss)) for loss in losses]
    times = [[each.time for each in each_loss if each.time is not None] for each_loss in by_loss]
    tables = (
        _mission_table(options, losses, [found[loss] for loss in losses]),
        BenchmarkTable(
            f"ALLIANCE on {options.patrol}: from the loss of a robot to the take-over of its task, tau {_TAU:g} s",
            ("messages lost [%]", "losses", "taken over", *(f"quantile {share:g} [s]" for share in _QUANTILES)),
            tuple(
                (
                    round(100 * loss),
                    len(each_loss),
                    len(taken),
                    *(rounded(quantile(taken, share)) for share in _QUANTILES),
                )
                for loss, each_loss, taken in zip(losses, by_loss, times)
            ),
            ("All else as in the table of take-over against tau.",),
        ),
    )
    return BenchmarkReport(tables, _figures(losses, [found[loss] for loss in losses], by_loss))


def _radio(loss: float) -> RadioSetup:
    return RadioSetup("lossy", {"loss": loss})


def _time(record: MissionRecord) -> List[float]:
    """Give when the last task was done [s], if all were."""
    times = done_at(record)
    return [max(times.values())] if times and len(times) == len(record.tasks) else []


def _mission_table(options: Options, losses: Sequence[float], records: Sequence[List[MissionRecord]]) -> BenchmarkTable:
    rows: List[Tuple[Any, ...]] = []
    for loss, each_loss in zip(losses, records):
        times = [time for record in each_loss for time in _time(record)]
        doubles = [double_holdings(record) for record in each_loss]
        every = [overlap for overlaps in doubles for overlap in overlaps]
        rows.append(
            (
                round(100 * loss),
                len(each_loss),
                share_text(estimated_share(len(times), len(each_loss))),
                estimate_text(estimated_mean(times)),
                estimate_text(estimated_mean([float(len(overlaps)) for overlaps in doubles]), 2),
                estimate_text(estimated_mean([sum(overlaps) for overlaps in doubles])),
                rounded(max(every, default=0.0)),
            )
        )
    return BenchmarkTable(
        f"ALLIANCE on {options.application} while messages between robots are lost",
        (
            "messages lost [%]",
            "missions",
            "all tasks done",
            "time until done [s]",
            "double holdings a mission",
            "held doubly [s a mission]",
            "longest double holding [s]",
        ),
        tuple(rows),
        (
            "A task is held doubly while the supervisor, which hears everything, counts two robots on it; a robot that "
            "stops announcing counts for the timeout of the topic.",
            MEANS,
            SHARES,
        ),
    )


def _figures(
    losses: Sequence[float], records: Sequence[List[MissionRecord]], by_loss: Sequence[Sequence[Takeover]]
) -> Tuple[Figure, ...]:
    percent = [100 * loss for loss in losses]
    times = [estimated_mean([time for record in each for time in _time(record)]) for each in records]
    doubles = [estimated_mean([sum(double_holdings(record)) for record in each]) for each in records]
    missions = (
        Chart((estimate_line("", percent, times),), "time until done [s]", bottom=0.0),
        Chart((estimate_line("", percent, doubles),), "held doubly [s a mission]", bottom=0.0),
    )
    charts = []
    for loss, each_loss in zip(losses, by_loss):
        taken = sorted(each.time for each in each_loss if each.time is not None)
        shares = [100.0 * number / max(1, len(each_loss)) for number in range(len(taken) + 1)]
        charts.append(Line(f"{100 * loss:.0f} % lost", (0.0, *taken), tuple(shares), style=LineStyle.STEPS))
    return (
        Figure("alliance_loss", "Missions while messages are lost", "messages lost [%]", missions),
        Figure(
            "alliance_loss_takeover",
            "Take-over while messages are lost",
            "take-over [s]",
            (Chart(tuple(charts), "share of losses taken over [%]", bottom=0.0, top=105.0),),
        ),
    )
