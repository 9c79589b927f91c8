"""Do free-running nodes share out tasks as a run in one process does, and how fast may the clock go?"""

from __future__ import annotations

import json
import math
import subprocess
import sys
from concurrent.futures import ThreadPoolExecutor
from contextlib import ExitStack
from pathlib import Path
from queue import SimpleQueue
from typing import Any, Dict, List, Mapping, NamedTuple, Optional, Sequence, Tuple

from rqt_mrta_py.app.bench.live.session import LiveSession
from rqt_mrta_py.errors import UsageError

__all__ = ["Likeness", "deviation", "highest_sustained", "measure_likeness"]

_SUSTAINED = "the clock could not keep up"
"""With this the simulation begins to tell that it was too slow."""

_BRIEF = 0.5
"""What lasted less is not compared: what begins and ends in one tick is no allocation, in two ticks it is [s]."""

_START_UP = 8.0
"""What a mission takes besides its own time, for what is foretold [s]."""


class Likeness(NamedTuple):
    """How alike free runs are to one in one process.

    Attributes:
        application: that was run.
        factor: how many times as fast as the wall clock.
        runs: how many.
        like: of how many the allocations are the same in order, within the tolerance.
        worst: the largest deviation among those [s]; None if there are none.
        sustained: in how many runs the clock kept up.
    """

    application: str
    factor: float
    runs: int
    like: int
    worst: Optional[float]
    sustained: int


def deviation(expected: Mapping[str, Any], found: Mapping[str, Any], tolerance: float) -> Optional[float]:
    """Compare the allocations of two summaries.

    They are alike if each task was carried out by the same robots in the same order, with the same outcomes, and all
    of it began and ended no more than the tolerance earlier or later. Left out are allocations shorter than half a
    second, and what happened within the tolerance before the end of the mission: the other run may not have come to it.

    Args:
        expected: a summary.
        found: the other one.
        tolerance: [s].

    Returns:
        The largest difference between times [s]; None if they are not alike.
    """
    end = min(float(summary["time"]["end"] or 0.0) for summary in (expected, found)) - tolerance
    one, other = _by_task(expected, end), _by_task(found, end)
    if one.keys() != other.keys() or any(len(holds) != len(other[task]) for task, holds in one.items()):
        return None
    worst = 0.0
    for task, holds in one.items():
        for here, there in zip(holds, other[task]):
            ended = min(float(here["to"]), float(there["to"])) < end
            if here["robot"] != there["robot"] or (ended and here["outcome"] != there["outcome"]):
                return None
            worst = max(worst, *(abs(float(here[key]) - float(there[key])) for key in ("from", "to")))
    return worst if worst <= tolerance else None


def measure_likeness(
    session: LiveSession,
    folder: Path,
    plan: Sequence[str],
    *,
    factor: float,
    runs: int,
    tolerance: float,
    at_once: int = 1,
) -> Likeness:
    """Run a mission in one process once and as nodes many times, and compare.

    Args:
        session: with a master.
        folder: for outputs; it is empty.
        plan: application and further arguments of ``mrta run``.
        factor: of the free runs.
        runs: how many of them.
        tolerance: see ``deviation`` [s].
        at_once: how many run at the same time, each with a master of its own.

    Raises:
        UsageError: a run fails.
    """
    expected, _ = _summary(session.environment, folder / "embedded", plan)
    mission_time = float(expected["time"]["end"]) - float(expected["time"]["start"])
    wall = (mission_time / factor + _START_UP) * -(-runs // at_once)
    sys.stderr.write(f"mrta: {runs} runs of {plan[0]} at factor {factor:g} take about {math.ceil(wall / 60.0)} min\n")
    with ExitStack() as stack:
        sessions: SimpleQueue[LiveSession] = SimpleQueue()
        for each in (session, *(stack.enter_context(LiveSession()) for _ in range(at_once - 1))):
            sessions.put(each)

        def run(number: int) -> Tuple[Mapping[str, Any], str]:
            own = sessions.get()
            try:
                way = [*plan, "--ros", "--factor", f"{factor:g}"]
                return _summary(own.environment, folder / f"live{number}", way)
            finally:
                sessions.put(own)

        with ThreadPoolExecutor(at_once) as pool:
            outcomes = list(pool.map(run, range(runs)))
    deviations = [deviation(expected, found, tolerance) for found, _ in outcomes]
    like = [each for each in deviations if each is not None]
    sustained = sum(_SUSTAINED not in said for _, said in outcomes)
    return Likeness(plan[0], factor, runs, len(like), max(like, default=None), sustained)


def highest_sustained(
    session: LiveSession, folder: Path, plan: Sequence[str], factors: Sequence[float]
) -> Tuple[float, Dict[float, bool]]:
    """Find the highest factor at which the clock keeps up.

    Args:
        session: with a master.
        folder: for outputs; it is empty.
        plan: application and further arguments of ``mrta run``.
        factors: to try, growing; the first that is too fast ends the search.

    Returns:
        The highest that was sustained (0 if none), and what was tried.

    Raises:
        UsageError: a run fails.
    """
    best, tried = 0.0, {}
    for factor in factors:
        way = [*plan, "--ros", "--factor", f"{factor:g}"]
        _, said = _summary(session.environment, folder / f"factor{factor:g}", way)
        tried[factor] = _SUSTAINED not in said
        if not tried[factor]:
            break
        best = factor
    return best, tried


def _by_task(summary: Mapping[str, Any], end: float) -> Dict[str, List[Mapping[str, Any]]]:
    """Sort the allocations of a summary that count by their tasks, in the order in which they began."""
    found: Dict[str, List[Mapping[str, Any]]] = {}
    for each in summary["allocations"]:
        if float(each["to"]) - float(each["from"]) >= _BRIEF and float(each["from"]) < end:
            found.setdefault(each["task"], []).append(each)
    return found


def _summary(environment: Mapping[str, str], out: Path, arguments: Sequence[str]) -> Tuple[Mapping[str, Any], str]:
    """Run a mission; give its summary, and what was said on stderr."""
    command = [sys.executable, "-m", "rqt_mrta_py", "run", *arguments, "--pictures", "0", "-q", "--out", str(out)]
    done = subprocess.run(command, env=dict(environment), capture_output=True, text=True, check=False)
    if done.returncode != 0:
        raise UsageError(f"mrta run {' '.join(arguments)}: ended with status {done.returncode}: {done.stderr.strip()}")
    summary: Mapping[str, Any] = json.loads((out / "summary.json").read_text(encoding="utf-8"))
    return summary, done.stderr
