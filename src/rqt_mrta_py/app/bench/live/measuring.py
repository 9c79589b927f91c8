"""The benchmark ``live``: its parts, and what they take."""

from __future__ import annotations

import argparse
import math
from pathlib import Path
from typing import Any, Callable, Dict, List, Sequence, Tuple

from rqt_mrta_py.app.bench.live.crash import measure_crash
from rqt_mrta_py.app.bench.live.endurance import measure_endurance
from rqt_mrta_py.app.bench.live.latency import measure_latency
from rqt_mrta_py.app.bench.live.likeness import highest_sustained, measure_likeness
from rqt_mrta_py.app.bench.live.processor import measure_processor
from rqt_mrta_py.app.bench.live.session import LiveSession
from rqt_mrta_py.hooks import BenchmarkReport, BenchmarkTable
from rqt_mrta_py.wording import accepted

__all__ = ["PARTS", "add_arguments", "measure"]

_TOLERANCE = 2.0
"""How far begins and ends of allocations may differ [s]."""
_FACTORS = (1.0, 2.0, 4.0, 6.0, 8.0, 10.0, 12.0, 16.0, 20.0)
_MISSIONS = ("border_patrol", "target_visiting")
_QUICK = 20.0


def _likeness(session: LiveSession, options: argparse.Namespace) -> BenchmarkTable:
    rows: List[Tuple[Any, ...]] = []
    runs = 2 if options.quick else options.runs
    for application in options.missions:
        plan = _plan(application, options)
        for factor in options.factors or dict.fromkeys((1.0, _factor_of(session, plan) or 1.0)):
            folder = _made(session.folder / f"{application}-{factor:g}")
            # The highest factor leaves no processor for another mission.
            at_once = options.at_once if factor <= 1.0 else 1
            found = measure_likeness(
                session, folder, plan, factor=factor, runs=runs, tolerance=_TOLERANCE, at_once=at_once
            )
            worst = None if found.worst is None else round(found.worst, 2)
            rows.append((application, factor, found.runs, found.like, worst, found.sustained))
    return BenchmarkTable(
        title="Free-running nodes beside a run in one process: the same allocations in order",
        columns=("application", "factor", "runs", "alike", "largest deviation [s]", "clock kept up"),
        rows=tuple(rows),
        notes=(
            "Alike: each task went to the same robots in the same order with the same outcomes, and began and ended "
            f"within {_TOLERANCE:g} s; allocations shorter than 0.5 s are left out.",
        ),
    )


def _factor(session: LiveSession, options: argparse.Namespace) -> BenchmarkTable:
    found = [(each, _factor_of(session, _plan(each, options)) or None) for each in options.missions]
    return BenchmarkTable(
        title="The highest real-time factor that the clock of free-running nodes sustains",
        columns=("application", "factor"),
        rows=tuple(found),
    )


def _plan(application: str, options: argparse.Namespace) -> Sequence[str]:
    """Give what is run: whole missions, in the world that costs less."""
    return (application, "--world", "planar", *(("--duration", f"{_QUICK:g}") if options.quick else ()))


def _factor_of(session: LiveSession, plan: Sequence[str]) -> float:
    found: Dict[str, float] = session.__dict__.setdefault("factors", {})
    key = " ".join(plan)
    if key not in found:
        folder = _made(session.folder / f"{plan[0]}-factors")
        found[key] = highest_sustained(session, folder, plan, _FACTORS)[0]
    return found[key]


def _made(folder: Path) -> Path:
    folder.mkdir()
    return folder


PARTS: Dict[str, Callable[[LiveSession, argparse.Namespace], BenchmarkTable]] = {
    "cpu": lambda session, options: measure_processor(session, _seconds(options, 60.0)),
    "latency": lambda session, options: measure_latency(session, _seconds(options, 60.0)),
    "endurance": lambda session, options: measure_endurance(session, _seconds(options, 600.0)),
    "crash": lambda session, options: measure_crash(session, _seconds(options, 600.0)),
    "factor": _factor,
    "tolerance": _likeness,
}
"""What can be measured, by name."""


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Say what the benchmark takes."""
    names = ",".join(PARTS)
    parser.add_argument(
        "--parts", metavar="P,...", type=_parts, default=tuple(PARTS), help=f"what to measure (default: {names})"
    )
    parser.add_argument("--seconds", metavar="S", type=float, help="how long each part listens (default: its own)")
    parser.add_argument("--runs", metavar="N", type=int, default=20, help="free runs of a mission (default: 20)")
    parser.add_argument(
        "--missions",
        metavar="A,...",
        type=_missions,
        default=_MISSIONS,
        help=f"what tolerance and factor run (default: {','.join(_MISSIONS)})",
    )
    parser.add_argument(
        "--factors", metavar="F,...", type=_factors, help="of tolerance (default: 1 and the highest that is sustained)"
    )
    parser.add_argument(
        "--at-once", metavar="N", type=int, choices=(1, 2, 3, 4), default=1, help="free runs at a time at factor 1 (1)"
    )
    parser.add_argument("--quick", action="store_true", help=f"{_QUICK:g} s for each part, two runs")


def measure(options: argparse.Namespace) -> BenchmarkReport:
    """Measure each part on a graph of its own."""
    tables = []
    for name in options.parts:
        with LiveSession() as session:
            tables.append(PARTS[name](session, options))
    return BenchmarkReport(tuple(tables))


def _seconds(options: argparse.Namespace, default: float) -> float:
    if options.seconds is not None:
        return float(options.seconds)
    return _QUICK if options.quick else default


def _missions(text: str) -> Tuple[str, ...]:
    return tuple(part for part in text.split(",") if part)


def _factors(text: str) -> Tuple[float, ...]:
    try:
        factors = tuple(float(part) for part in text.split(","))
    except ValueError:
        factors = ()
    if not factors or not all(0.0 < each < math.inf for each in factors):
        raise argparse.ArgumentTypeError(f"{text!r}: finite numbers above 0 are expected, as in 1,8")
    return factors


def _parts(text: str) -> Tuple[str, ...]:
    names = tuple(part for part in text.split(",") if part)
    for name in names:
        if name not in PARTS:
            raise argparse.ArgumentTypeError(f"{name!r}: there is no such part; {accepted(name, PARTS)}")
    return names
