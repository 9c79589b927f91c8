"""The benchmark ``incidents``: what it takes, and its tables."""

from __future__ import annotations

import argparse
import tempfile
import time
from collections import Counter
from pathlib import Path
from typing import Callable, Dict, List, Sequence, Tuple

from rqt_mrta_py.app.bench.incidents.campaign import Campaign, Judged, carried_out
from rqt_mrta_py.app.bench.incidents.fault import Fault
from rqt_mrta_py.app.bench.incidents.faults import FAULTS, RULES
from rqt_mrta_py.app.bench.incidents.judging import Tally
from rqt_mrta_py.app.compose import compose
from rqt_mrta_py.hooks import BenchmarkReport, BenchmarkTable, Laboratory
from rqt_mrta_py.wording import accepted

__all__ = ["PROOF_SEED", "TUNING_SEED", "add_arguments", "measure"]

PROOF_SEED = 30_001
"""The first seed of the missions that prove the rules; these were never looked at while rules were tuned."""

TUNING_SEED = 101
"""The first seed of the missions that rules may be tuned by."""

_MOST = 1_000
"""Missions of a rule at most, so that seeds of the proof and of tuning stay apart."""


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Say what the benchmark takes."""
    parser.add_argument(
        "--seeds",
        metavar="N",
        type=_count,
        help="missions with a fault for each rule, and missions with harmless trouble (default: 30; quick: 1)",
    )
    parser.add_argument("--rules", metavar="RULE,...", type=_rules, default=RULES, help="only these (default: all)")
    parser.add_argument(
        "--tuning", action="store_true", help="on seeds by which rules may be tuned; those of the proof are others"
    )
    parser.add_argument("--quick", action="store_true", help="few missions, to see that it works")


def measure(
    options: argparse.Namespace, laboratory: Laboratory, clock: Callable[[], float] = time.monotonic
) -> BenchmarkReport:
    """Carry out missions with and without faults, and count what was found of them.

    Args:
        options: as ``add_arguments`` says.
        laboratory: carries them out.
        clock: tells what it took [s].
    """
    began = clock()
    seed = TUNING_SEED if options.tuning else PROOF_SEED
    missions = options.seeds or (1 if options.quick else 30)
    campaign = Campaign(options.rules, seed, missions, harmless=not options.quick)
    with tempfile.TemporaryDirectory(prefix="mrta-bench-") as folder:
        judged = list(carried_out(campaign, compose(), laboratory, Path(folder)))
    took = clock() - began
    tables = [_of_rules(judged, campaign, took), _of_faults(judged, campaign)]
    wrong = _of_errors(judged)
    return BenchmarkReport((*tables, wrong) if wrong.rows else tuple(tables))


def _of_rules(judged: Sequence[Judged], campaign: Campaign, took: float) -> BenchmarkTable:
    tally = Tally()
    for each in judged:
        tally.take_in(each.verdict)
    rows = [
        (
            rule,
            tally.faulty(rule),
            tally.clean,
            tally.found(rule),
            tally.missed(rule),
            tally.false(rule),
            tally.followed(rule),
            tally.recall(rule),
            tally.precision(rule),
        )
        for rule in campaign.rules
    ]
    return BenchmarkTable(
        title=f"Incidents found in {len(judged)} missions, seeds from {campaign.first_seed}",
        columns=("rule", "faulty", "clean", "found", "missed", "false alarms", "followed", "recall", "precision"),
        rows=tuple(rows),
        notes=(
            "Faulty: missions in which the rule had to find something. Clean: missions in which nothing went wrong, "
            "with harmless trouble or none; the same for all rules.",
            "Found and missed: what had to be found, by rule, robots, tasks and time. False alarms: incidents that "
            "nothing explains, in any mission. Followed: incidents that rightly follow from the fault; they count on "
            "neither side.",
            f"It took {took:.0f} s.",
        ),
    )


def _of_faults(judged: Sequence[Judged], campaign: Campaign) -> BenchmarkTable:
    by_fault: Dict[Fault, List[Judged]] = {fault: [] for fault in FAULTS if fault in campaign.counts}
    for each in judged:
        if each.fault is not None:
            by_fault[each.fault].append(each)
    rows: List[Tuple[object, ...]] = []
    for fault, missions in by_fault.items():
        verdicts = [each.verdict for each in missions]
        followed = Counter(incident.rule for verdict in verdicts for incident in verdict.followed)
        rows.append(
            (
                fault.place.value,
                fault.text,
                ", ".join(fault.rules),
                len(missions),
                sum(len(verdict.found) for verdict in verdicts),
                sum(len(verdict.missed) for verdict in verdicts),
                sum(len(verdict.false) for verdict in verdicts),
                ", ".join(f"{rule} ({number})" for rule, number in sorted(followed.items())),
            )
        )
    return BenchmarkTable(
        title="The faults",
        columns=(
            "where",
            "what happens",
            "what must be found",
            "missions",
            "found",
            "missed",
            "false alarms",
            "followed",
        ),
        rows=tuple(rows),  # type: ignore[arg-type]  # cells are text and whole numbers
    )


def _of_errors(judged: Sequence[Judged]) -> BenchmarkTable:
    rows: List[Tuple[str, str, str, str]] = []
    for each in judged:
        rows += [
            (
                each.name,
                "missed",
                label.rule,
                f"{label.start:.1f} to {label.end:.1f} s: {', '.join(sorted((*label.robots, *label.tasks)))}",
            )
            for label in each.verdict.missed
        ]
        rows += [
            (each.name, "false alarm", incident.rule, f"{incident.start:.1f} to {incident.end:.1f} s: {incident.text}")
            for incident in each.verdict.false
        ]
    return BenchmarkTable(
        "What was missed, and what was told wrongly", ("mission", "error", "rule", "when and what"), tuple(rows)
    )


def _rules(text: str) -> Tuple[str, ...]:
    asked = tuple(dict.fromkeys(text.split(",")))
    for rule in asked:
        if rule not in RULES:
            raise argparse.ArgumentTypeError(f"{rule!r}: no fault is for such a rule; {accepted(rule, RULES)}")
    return asked


def _count(text: str) -> int:
    if not text.isascii() or not text.isdigit() or not 1 <= int(text[:9]) <= _MOST:
        raise argparse.ArgumentTypeError(f"{text!r}: a whole number from 1 to {_MOST} is expected")
    return int(text)
