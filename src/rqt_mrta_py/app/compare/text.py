"""A comparison for a terminal: whatever differs, a line each."""

from __future__ import annotations

from typing import List, NamedTuple, Sequence, Tuple

from rqt_mrta_py.app.compare.comparison import Comparison, Verdict
from rqt_mrta_py.app.compare.wording import allowed, change, headline, holding, number, task_line

__all__ = ["TextTable", "allocation_table", "figure_table", "incident_lines", "task_lines"]


class TextTable(NamedTuple):
    """Titles of columns, and rows with a cell for each."""

    head: Tuple[str, ...]
    rows: Sequence[Tuple[str, ...]]


def figure_table(comparison: Comparison) -> TextTable:
    """List the figures that differ, those that are worse first."""
    differing = [figure for figure in comparison.figures if figure.verdict is not Verdict.EQUAL]
    differing.sort(key=lambda figure: figure.verdict is not Verdict.WORSE)
    rows = [
        (
            figure.name,
            number(figure.first) if figure.known[0] else "none",
            number(figure.second) if figure.known[1] else "none",
            change(figure),
            allowed(figure),
            "worse" if figure.verdict is Verdict.WORSE else "",
        )
        for figure in differing
    ]
    return TextTable(("FIGURE", "A", "B", "CHANGE", "ALLOWED", ""), rows)


def task_lines(comparison: Comparison, shift: float) -> List[str]:
    """Say how differently tasks were given out, then of each that was, how it ended."""
    told = [
        f"  {task.task}: {task_line(task)}"
        for task in comparison.tasks
        if any(pair.differs(shift) for pair in task.pairs) or task.states[0] != task.states[1]
    ]
    return [headline(comparison, shift), *told]


def allocation_table(comparison: Comparison, shift: float) -> TextTable:
    """List the allocations that differ."""
    rows = [
        (task.task, pair.robot, str(pair.number), holding(pair.first), holding(pair.second))
        for task in comparison.tasks
        for pair in task.pairs
        if pair.differs(shift)
    ]
    return TextTable(("TASK", "ROBOT", "NO.", "A", "B"), rows)


def incident_lines(comparison: Comparison) -> List[str]:
    """List incidents that only one of the missions has: ``+`` those of B, ``-`` those of A."""
    lines = []
    for pair in comparison.incidents:
        if pair.first is None or pair.second is None:
            sign, shown = "+" if pair.first is None else "-", pair.shown
            lines.append(f"{sign} {shown.start:8.1f} s  {shown.severity}: {shown.text}")
    return lines
