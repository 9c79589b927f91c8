"""Labels: what must be found of a fault, and what else may rightly follow from it."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import FrozenSet

from rqt_mrta_py.model import Incident

__all__ = ["Allowance", "Label", "names"]


def names(*ids: str) -> FrozenSet[str]:
    """Make a set of ids."""
    return frozenset(ids)


@dataclass(frozen=True)
class Label:
    """An incident that must be found.

    Attributes:
        rule: that must find it.
        start, end: its interval must meet this one, both ends included; stamps [s].
        robots: that it must name, perhaps among others; empty: any.
        tasks: likewise.
    """

    rule: str
    start: float
    end: float
    robots: FrozenSet[str] = frozenset()
    tasks: FrozenSet[str] = frozenset()

    def fits(self, incident: Incident) -> bool:
        """Tell whether an incident is the one that must be found."""
        return (
            incident.rule == self.rule
            and incident.start <= self.end
            and incident.end >= self.start
            and self.robots.issubset(incident.robots)
            and self.tasks.issubset(incident.tasks)
        )


@dataclass(frozen=True)
class Allowance:
    """Incidents that may be found, for they would be right.

    Attributes:
        rule: that may find them.
        because: why they would be right.
        start: they begin then at the earliest; a stamp [s].
        robots: of which they must name one; empty: any or none.
        tasks: likewise.
    """

    rule: str
    because: str
    start: float = -math.inf
    robots: FrozenSet[str] = frozenset()
    tasks: FrozenSet[str] = frozenset()

    def fits(self, incident: Incident) -> bool:
        """Tell whether an incident is one of them."""
        return (
            incident.rule == self.rule
            and incident.start >= self.start
            and not (self.robots and self.robots.isdisjoint(incident.robots))
            and not (self.tasks and self.tasks.isdisjoint(incident.tasks))
        )
