"""Cuts a robot's time into spells with one task or none."""

from __future__ import annotations

from typing import List, Optional, Sequence, Tuple

from rqt_mrta_py.model import Allocation, Outcome

__all__ = ["spells"]


def spells(held: Sequence[Allocation], start: float, end: float) -> List[Tuple[float, float, Optional[str]]]:
    """Say what a robot held over a stretch of time.

    Args:
        held: allocations of one robot, by start.
        start: of the stretch [s].
        end: of the stretch [s].

    Returns:
        Start [s], end [s] and task of each spell, in order, without gaps; None for no task, and of several tasks the
        one begun last.
    """
    cuts = {start, end}
    for allocation in held:
        cuts.update(time for time in (allocation.start, allocation.end) if start < time < end)
    edges = sorted(cuts)
    found = []
    for since, until in zip(edges, edges[1:]):
        tasks = [a.task for a in held if a.start <= since and (until <= a.end or a.outcome is Outcome.OPEN)]
        found.append((since, until, tasks[-1] if tasks else None))
    return found
