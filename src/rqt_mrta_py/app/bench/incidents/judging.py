"""Holds what was found against what had to be, mission by mission and rule by rule."""

from __future__ import annotations

from collections import Counter
from typing import Iterable, NamedTuple, Optional, Sequence, Tuple

from rqt_mrta_py.app.bench.incidents.label import Allowance, Label
from rqt_mrta_py.model import Incident

__all__ = ["Tally", "Verdict", "judge"]


class Verdict(NamedTuple):
    """What was found of one mission.

    Attributes:
        found: labels that an incident fits.
        missed: labels that none does.
        followed: incidents that no label asks for, but that rightly follow.
        false: incidents that nothing explains.
    """

    found: Tuple[Label, ...]
    missed: Tuple[Label, ...]
    followed: Tuple[Incident, ...]
    false: Tuple[Incident, ...]


def judge(incidents: Sequence[Incident], labels: Sequence[Label], allowances: Sequence[Allowance]) -> Verdict:
    """Judge one mission.

    Args:
        incidents: that were found.
        labels: what had to be found; empty for a mission in which nothing went wrong.
        allowances: what could be found besides.
    """
    found = tuple(label for label in labels if any(map(label.fits, incidents)))
    unasked = [incident for incident in incidents if not any(label.fits(incident) for label in labels)]
    followed = tuple(incident for incident in unasked if any(each.fits(incident) for each in allowances))
    return Verdict(
        found,
        tuple(label for label in labels if label not in found),
        followed,
        tuple(incident for incident in unasked if incident not in followed),
    )


class Tally:
    """Counts verdicts of many missions, by rule."""

    def __init__(self) -> None:
        self._faulty: Counter[str] = Counter()
        self._found: Counter[str] = Counter()
        self._missed: Counter[str] = Counter()
        self._followed: Counter[str] = Counter()
        self._false: Counter[str] = Counter()
        self.clean = 0
        """How many missions there were in which nothing had to be found."""

    def take_in(self, verdict: Verdict) -> None:
        """Count one mission."""
        rules = {label.rule for label in (*verdict.found, *verdict.missed)}
        self._faulty.update(rules)
        if not rules:
            self.clean += 1
        self._found.update(label.rule for label in verdict.found)
        self._missed.update(label.rule for label in verdict.missed)
        self._followed.update(_rules(verdict.followed))
        self._false.update(_rules(verdict.false))

    def faulty(self, rule: str) -> int:
        """Give in how many missions a rule had to find something."""
        return self._faulty[rule]

    def found(self, rule: str) -> int:
        """Give how many labels of a rule an incident fits."""
        return self._found[rule]

    def missed(self, rule: str) -> int:
        """Give how many labels of a rule no incident fits."""
        return self._missed[rule]

    def followed(self, rule: str) -> int:
        """Give how many incidents of a rule rightly followed from what was done."""
        return self._followed[rule]

    def false(self, rule: str) -> int:
        """Give how many incidents of a rule nothing explains."""
        return self._false[rule]

    def recall(self, rule: str) -> Optional[float]:
        """Give the share of labels that were found; None if there were none."""
        return _share(self._found[rule], self._missed[rule])

    def precision(self, rule: str) -> Optional[float]:
        """Give the share of labels found among these and false alarms; None if there were neither.

        What rightly followed counts on neither side.
        """
        return _share(self._found[rule], self._false[rule])


def _rules(incidents: Iterable[Incident]) -> Iterable[str]:
    return (incident.rule for incident in incidents)


def _share(good: int, bad: int) -> Optional[float]:
    return good / (good + bad) if good + bad else None
