"""The numbers of a finished mission by name, and how those are judged about which a user says nothing."""

from __future__ import annotations

import math
from collections import Counter
from typing import Any, Dict, List, Mapping, Optional, Tuple, Union

from rqt_mrta_py.app.compare.side import Side
from rqt_mrta_py.model import Severity, TaskState, Tolerance, Worse

__all__ = ["DEFAULT_TOLERANCES", "RULES", "Figure", "figures_of"]

Figure = Union[int, float, str, bool, None]
"""What a figure is in one mission; None where the mission has none, as of a task that never was allocated."""

RULES = "incidents.rule."
"""Begins the names of figures that count what one rule found; a rule that found nothing is not among them."""

DEFAULT_TOLERANCES: Tuple[Tolerance, ...] = (
    Tolerance("tasks.done", Worse.LOWER),
    Tolerance("tasks.failed", Worse.HIGHER),
    Tolerance("incidents.error", Worse.HIGHER),
    Tolerance("incidents.warning", Worse.HIGHER),
    Tolerance("statistics.allocations_by_outcome.failed", Worse.HIGHER),
    Tolerance("statistics.allocations_by_outcome.lost", Worse.HIGHER),
    Tolerance("statistics.arena_coverage.team", Worse.LOWER, absolute=0.05),
    Tolerance("statistics.availability.*", Worse.LOWER, absolute=0.05),
    Tolerance("statistics.makespan", Worse.HIGHER, relative=0.1, absolute=1.0),
    Tolerance("statistics.reallocations", Worse.HIGHER, relative=0.1, absolute=1.0),
    Tolerance("statistics.time_to_first_allocation.*", Worse.HIGHER, relative=0.1, absolute=1.0),
    Tolerance("*", Worse.NEVER),
)
"""What counts after a user's own: losing a robot, a task or time is worse.

What may be good or bad is only shown: a task's coverage falls when nobody holds it, and when it is done sooner.
"""


def figures_of(side: Side) -> Dict[str, Figure]:
    """List the numbers of a mission.

    Args:
        side: the mission.

    Returns:
        By name, in a fixed order: counts of robots, tasks by state, allocations, incidents by severity and by rule,
        the duration [s]; then everything in the statistics that is a scalar, its keys joined by dots.
    """
    states = Counter(state for _, state in side.tasks)
    severities = Counter(incident.severity for incident in side.incidents)
    rules = Counter(incident.rule for incident in side.incidents)
    figures: Dict[str, Figure] = {"duration": side.duration, "robots": len(side.robots), "tasks": len(side.tasks)}
    figures.update({f"tasks.{state.value}": states[state.value] for state in TaskState})
    figures["allocations"] = len(side.holdings)
    figures["incidents"] = len(side.incidents)
    figures.update({f"incidents.{severity.value}": severities[severity.value] for severity in Severity})
    figures.update({f"{RULES}{rule}": rules[rule] for rule in sorted(rules)})
    for name, value in _scalars(side.statistics):
        figures.setdefault(name, value)
    return figures


def _scalars(statistics: Mapping[str, Any]) -> List[Tuple[str, Figure]]:
    found: List[Tuple[str, Figure]] = []
    pending: List[Tuple[str, Any]] = [("statistics", statistics)]
    while pending:
        name, value = pending.pop()
        if isinstance(value, Mapping):
            pending.extend((f"{name}.{key}", inner) for key, inner in value.items())
        elif isinstance(value, (list, tuple)):
            pending.extend((f"{name}.{index}", inner) for index, inner in enumerate(value))
        elif _is_plain(value):
            found.append((name, value))
    return sorted(found, key=lambda each: each[0])


def _is_plain(value: Any) -> bool:
    """Tell whether a value can be compared: JSON holds whole numbers of any length, and 1e999."""
    return value is None or isinstance(value, (bool, str)) or _number(value) is not None


def _number(value: Any) -> Optional[float]:
    if isinstance(value, bool) or not isinstance(value, (int, float)):
        return None
    try:
        number = float(value)
    except OverflowError:
        return None
    return number if math.isfinite(number) else None
