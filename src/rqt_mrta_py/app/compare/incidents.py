"""Which incidents are in one mission, in the other, in both."""

from __future__ import annotations

from typing import Dict, List, NamedTuple, Optional, Sequence, Tuple

from rqt_mrta_py.app.compare.side import HeldIncident

__all__ = ["IncidentPair", "pair_incidents"]


class IncidentPair(NamedTuple):
    """What one rule found on the same robots and tasks, for the same time in number, in one mission or both."""

    first: Optional[HeldIncident]
    second: Optional[HeldIncident]

    @property
    def shown(self) -> HeldIncident:
        """Give the one of the second mission, else of the first."""
        found = self.second if self.second is not None else self.first
        if found is None:
            raise ValueError("a pair holds at least one incident")
        return found


def pair_incidents(first: Sequence[HeldIncident], second: Sequence[HeldIncident]) -> Tuple[IncidentPair, ...]:
    """Pair the incidents of two missions.

    Args:
        first: of a mission, by start.
        second: of another, likewise.

    Returns:
        By start, in the second mission where it is there.
    """
    open_ones: Dict[Tuple[str, Tuple[str, ...], Tuple[str, ...]], List[HeldIncident]] = {}
    for incident in reversed(first):
        open_ones.setdefault(_identity(incident), []).append(incident)
    pairs = []
    for incident in second:
        waiting = open_ones.get(_identity(incident))
        pairs.append(IncidentPair(waiting.pop() if waiting else None, incident))
    pairs += [IncidentPair(incident, None) for waiting in open_ones.values() for incident in waiting]
    return tuple(sorted(pairs, key=lambda pair: (pair.shown.start, _identity(pair.shown), pair.second is None)))


def _identity(incident: HeldIncident) -> Tuple[str, Tuple[str, ...], Tuple[str, ...]]:
    return incident.rule, incident.robots, incident.tasks
