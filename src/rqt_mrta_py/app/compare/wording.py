"""Numbers and sentences of a comparison as people read them."""

from __future__ import annotations

from pathlib import Path
from typing import List, Optional

from rqt_mrta_py.app.compare.allocations import TaskComparison
from rqt_mrta_py.app.compare.comparison import Comparison, FigureComparison
from rqt_mrta_py.app.compare.figures import Figure
from rqt_mrta_py.app.compare.side import Holding, Side
from rqt_mrta_py.model import Worse

__all__ = [
    "NOTHING",
    "allowed",
    "change",
    "headline",
    "holding",
    "number",
    "side_line",
    "side_name",
    "task_line",
    "verdict_line",
]

NOTHING = "-"
"""Stands where there is nothing."""


def number(value: Figure) -> str:
    """Write a figure: whole numbers whole, others to six significant digits."""
    if value is None:
        return NOTHING
    if isinstance(value, bool):
        return "true" if value else "false"
    return f"{value:.6g}" if isinstance(value, float) else str(value)


def change(figure: FigureComparison) -> str:
    """Write by how much a figure changed, with its sign."""
    return NOTHING if figure.change is None else f"{figure.change:+.6g}"


def allowed(figure: FigureComparison) -> str:
    """Say which change is allowed."""
    way = figure.tolerance.worse
    if way is Worse.NEVER or figure.allowance is None:
        return "any" if way is Worse.NEVER else NOTHING
    sign = {Worse.HIGHER: "+", Worse.LOWER: "-"}.get(way, "+/-")
    return f"{sign}{figure.allowance:.6g}" if figure.allowance else "0"


def side_line(side: Side) -> str:
    """Say in a line which mission this is."""
    parts = [
        f"{side.application or 'unknown application'} under {side.architecture or 'unknown architecture'}",
        "no messages" if side.duration is None else f"{side.duration:.1f} s",
    ]
    if side.seed is not None:
        parts.insert(1, f"seed {side.seed}")
    return f"{', '.join(parts)} ({_folder(side)})"


def side_name(side: Side) -> str:
    """Name a mission in a word: its application, else the folder that it is in."""
    return side.application or _folder(side).name or "unknown application"


def _folder(side: Side) -> Path:
    return side.path.parent if side.path.name == "summary.json" else side.path


def holding(held: Optional[Holding]) -> str:
    """Write from when to when a robot held a task, and how that ended."""
    return NOTHING if held is None else f"{held.start:.1f} to {held.end:.1f} s, {held.outcome.replace('_', ' ')}"


def task_line(task: TaskComparison) -> str:
    """Say how a task ended, and for how long it was in other hands."""
    one, other = (state or "not known" for state in task.states)
    ended = f"{one} in both" if one == other else f"{one} in A, {other} in B"
    return f"{ended}; in other hands or none for {task.otherwise:.1f} of {task.held:.1f} s"


def headline(comparison: Comparison, shift: float) -> str:
    """Say in a line how differently tasks were given out."""
    differing = [task for task in comparison.tasks if any(pair.differs(shift) for pair in task.pairs)]
    otherwise = sum(task.otherwise for task in comparison.tasks)
    held = sum(task.held for task in comparison.tasks)
    share = f" ({100.0 * otherwise / held:.1f} %)" if held else ""
    return (
        f"{len(differing)} of {len(comparison.tasks)} tasks were given out differently; "
        f"in other hands or none for {otherwise:.1f} of {held:.1f} s{share}"
    )


def verdict_line(comparison: Comparison) -> str:
    """Say in a line whether the second mission is worse."""
    names: List[str] = [figure.name for figure in comparison.worse]
    if not names:
        return "B is not worse than the tolerances allow"
    return f"B is worse than the tolerances allow: {', '.join(names)}"
