"""Do free-running nodes share out tasks as a run in one process does, and how fast may the clock go?"""

from __future__ import annotations

import json
import subprocess
import sys
from pathlib import Path
from typing import Any, Dict, List, Mapping, NamedTuple, Optional, Sequence, Tuple

from rqt_mrta_py.errors import UsageError

__all__ = ["Likeness", "deviation", "highest_sustained", "measure_likeness"]

_SUSTAINED = "the clock could not keep up"
"""With this the simulation begins to tell that it was too slow."""


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


def deviation(
    expected: Sequence[Mapping[str, Any]], found: Sequence[Mapping[str, Any]], tolerance: float
) -> Optional[float]:
    """Compare the allocations of two summaries.

    They are alike if to each of one belongs one of the other, of the same robot, task and outcome, that begins and ends
    no more than the tolerance earlier or later. So they are in the same order, save for those that begin within twice
    the tolerance of one another.

    Args:
        expected: allocations of one summary.
        found: of the other.
        tolerance: [s].

    Returns:
        The largest difference between their times [s]; None if they are not alike.
    """
    left = list(found)
    worst = 0.0
    for one in expected:
        fitting = [(_distance(one, other), index) for index, other in enumerate(left) if _same(one, other)]
        best = min(fitting, default=(tolerance, -1))
        if best[1] < 0 or best[0] > tolerance:
            return None
        worst = max(worst, best[0])
        left.pop(best[1])
    return None if left else worst


def measure_likeness(
    environment: Mapping[str, str],
    folder: Path,
    plan: Sequence[str],
    *,
    factor: float,
    runs: int,
    tolerance: float,
) -> Likeness:
    """Run a mission in one process once and as nodes many times, and compare.

    Args:
        environment: points at a master.
        folder: for outputs; it is empty.
        plan: application and further arguments of ``mrta run``.
        factor: of the free runs.
        runs: how many of them.
        tolerance: see ``deviation`` [s].

    Raises:
        UsageError: a run fails.
    """
    expected, _ = _allocations(environment, folder / "embedded", plan)
    deviations: List[float] = []
    sustained = 0
    for number in range(runs):
        found, said = _allocations(environment, folder / f"live{number}", [*plan, "--ros", "--factor", f"{factor:g}"])
        sustained += _SUSTAINED not in said
        how_far = deviation(expected, found, tolerance)
        if how_far is not None:
            deviations.append(how_far)
    return Likeness(plan[0], factor, runs, len(deviations), max(deviations, default=None), sustained)


def highest_sustained(
    environment: Mapping[str, str], folder: Path, plan: Sequence[str], factors: Sequence[float]
) -> Tuple[float, Dict[float, bool]]:
    """Find the highest factor at which the clock keeps up.

    Args:
        environment: points at a master.
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
        _, said = _allocations(environment, folder / f"factor{factor:g}", way)
        tried[factor] = _SUSTAINED not in said
        if not tried[factor]:
            break
        best = factor
    return best, tried


def _same(one: Mapping[str, Any], other: Mapping[str, Any]) -> bool:
    return all(one[key] == other[key] for key in ("robot", "task", "outcome"))


def _distance(one: Mapping[str, Any], other: Mapping[str, Any]) -> float:
    return max(abs(float(one[key]) - float(other[key])) for key in ("from", "to"))


def _allocations(
    environment: Mapping[str, str], out: Path, arguments: Sequence[str]
) -> Tuple[Sequence[Mapping[str, Any]], str]:
    """Run a mission; give its allocations, and what was said on stderr."""
    command = [sys.executable, "-m", "rqt_mrta_py", "run", *arguments, "--pictures", "0", "-q", "--out", str(out)]
    done = subprocess.run(command, env=dict(environment), capture_output=True, text=True, check=False)
    if done.returncode != 0:
        raise UsageError(f"mrta run {' '.join(arguments)}: ended with status {done.returncode}: {done.stderr.strip()}")
    summary = json.loads((out / "summary.json").read_text(encoding="utf-8"))
    allocations: Sequence[Mapping[str, Any]] = summary["allocations"]
    return allocations, done.stderr
