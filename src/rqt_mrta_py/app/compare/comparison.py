"""Two missions compared, and whether the second is worse than tolerances allow."""

from __future__ import annotations

from dataclasses import dataclass
from enum import Enum
from fnmatch import fnmatchcase
from typing import Dict, Optional, Sequence, Tuple

from rqt_mrta_py.app.compare.allocations import TaskComparison, compare_allocations
from rqt_mrta_py.app.compare.figures import DEFAULT_TOLERANCES, RULES, Figure, figures_of
from rqt_mrta_py.app.compare.incidents import IncidentPair, pair_incidents
from rqt_mrta_py.app.compare.side import Side
from rqt_mrta_py.model import Severity, Tolerance, Worse

__all__ = ["Comparison", "FigureComparison", "Verdict", "compare"]

# What is left of a number after it was written in nine decimals and read again.
_NOISE = 1e-9


class Verdict(Enum):
    """What became of a figure."""

    EQUAL = "equal"
    SHOWN = "shown"
    ALLOWED = "allowed"
    WORSE = "worse"


@dataclass(frozen=True)
class FigureComparison:
    """One figure in both missions.

    Attributes:
        name: as tolerances name it.
        first: in the first mission.
        second: in the second.
        known: whether the first and the second mission know this figure at all.
        tolerance: by which it was judged.
        change: second minus first; None where either is no number.
        allowance: how large a change for the worse may be; None where the first is no number.
        verdict: ``SHOWN`` where it differs and nobody minds, ``ALLOWED`` where it differs as tolerances allow.
    """

    name: str
    first: Figure
    second: Figure
    known: Tuple[bool, bool]
    tolerance: Tolerance
    change: Optional[float]
    allowance: Optional[float]
    verdict: Verdict


@dataclass(frozen=True)
class Comparison:
    """Two missions side by side.

    Attributes:
        first, second: the missions.
        figures: all that either has, in a fixed order.
        tasks: their allocations.
        incidents: in pairs.
        unused: tolerances of the user that match no figure.
    """

    first: Side
    second: Side
    figures: Tuple[FigureComparison, ...]
    tasks: Tuple[TaskComparison, ...]
    incidents: Tuple[IncidentPair, ...]
    unused: Tuple[Tolerance, ...]

    @property
    def worse(self) -> Tuple[FigureComparison, ...]:
        """Give the figures that are worse than their tolerances allow."""
        return tuple(figure for figure in self.figures if figure.verdict is Verdict.WORSE)


def compare(first: Side, second: Side, tolerances: Sequence[Tolerance] = ()) -> Comparison:
    """Compare a mission with another one.

    Args:
        first: the mission to be held against.
        second: the one that is judged.
        tolerances: of the user; the first that matches a figure counts, after the last one those of the house.

    Returns:
        The same for the same missions and tolerances.
    """
    tasks = compare_allocations(first, second)
    incidents = pair_incidents(first.incidents, second.incidents)
    figures = (figures_of(first), {**figures_of(second), **_differences(tasks, incidents)})
    figures[0].update(dict.fromkeys(_differences((), ()), 0))
    for name in [name for found in figures for name in found if name.startswith(RULES)]:
        for found in figures:
            found.setdefault(name, 0)
    rules = (*tolerances, *DEFAULT_TOLERANCES)
    # By name, for either may have what the other has not; statistics last, for they are many.
    names = sorted({**figures[0], **figures[1]}, key=lambda name: (name.startswith("statistics."), name))
    compared = tuple(_judged(name, *figures, _rule_for(name, rules)) for name in names)
    unused = tuple(rule for rule in tolerances if not any(fnmatchcase(name, rule.figure) for name in names))
    return Comparison(first, second, compared, tasks, incidents, unused)


def _differences(tasks: Sequence[TaskComparison], incidents: Sequence[IncidentPair]) -> Dict[str, Figure]:
    """Tell as figures by how much a mission is not like the other, in which they are 0."""
    held = sum(task.held for task in tasks)
    share = sum(task.otherwise for task in tasks) / held if held else 0.0
    found: Dict[str, Figure] = {"differences.share_of_time_held_otherwise": round(share, 9)}
    for severity in Severity:
        new = [pair for pair in incidents if pair.first is None and pair.shown.severity == severity.value]
        found[f"differences.new_incidents.{severity.value}"] = len(new)
    return found


def _rule_for(name: str, rules: Sequence[Tolerance]) -> Tolerance:
    return next(rule for rule in rules if fnmatchcase(name, rule.figure))


def _judged(name: str, firsts: Dict[str, Figure], seconds: Dict[str, Figure], tolerance: Tolerance) -> FigureComparison:
    first, second = firsts.get(name), seconds.get(name)
    known = (name in firsts, name in seconds)
    one, other = _as_number(first), _as_number(second)
    change = None if one is None or other is None else round(other - one, 9)
    allowance = None if one is None else tolerance.allowance(one)
    is_same = all(known) and type(first) is type(second) and first == second
    if is_same or (change is not None and abs(change) <= _NOISE):
        verdict = Verdict.EQUAL
    elif tolerance.worse is Worse.NEVER or not all(known):
        # What one of them does not know at all, such as another team's robot, cannot be better or worse.
        verdict = Verdict.SHOWN
    elif one is None or other is None:
        # A number that got lost is worse; one that was found is not.
        lost = other is None and one is not None
        verdict = Verdict.WORSE if lost or tolerance.worse is Worse.EITHER else Verdict.ALLOWED
    else:
        amount = {Worse.HIGHER: other - one, Worse.LOWER: one - other}.get(tolerance.worse, abs(other - one))
        noise = _NOISE * max(1.0, abs(one), abs(other))
        verdict = Verdict.WORSE if amount > tolerance.allowance(one) + noise else Verdict.ALLOWED
    return FigureComparison(name, first, second, known, tolerance, change, allowance, verdict)


def _as_number(value: Figure) -> Optional[float]:
    return None if value is None or isinstance(value, (str, bool)) else float(value)
