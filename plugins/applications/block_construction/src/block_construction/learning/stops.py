"""When training ends before its iterations are used up."""

from __future__ import annotations

from typing import Any

__all__ = ["RECENT", "greatest", "hits_among_recent"]

RECENT = 100
"""Runs of which it is asked how many had the least cost."""


def hits_among_recent(hits: int, costs: Any, run: int, begun: int, least: int) -> int:
    """Count how many of the last runs had the least cost known, one run later.

    Dantas (2017), section 5.2: training ends when w of the last 100 costs are the known minimum.
    Differs from the paper: the minimum is the least cost that this training has seen; what else would be known is not
    said.

    Args:
        hits: the count one run earlier.
        costs: of all runs, the one with number 1 first.
        run: number of this run.
        begun: how many runs there were before those that count.
        least: cost of those that count, before this run.
    """
    cost = costs[run - 1]
    if cost < least:
        return 1
    if cost == least:
        hits += 1
    if run - begun > RECENT and costs[run - 1 - RECENT] == least:
        hits -= 1
    return hits


def greatest(values: Any) -> float:
    """Give the greatest of an automaton's probabilities or parameters.

    Training ends when the mean of the greatest probabilities of the automata that were selected is high enough: Dantas
    (2017), section 5.2.
    """
    highest: float = values[0]
    for index in range(1, values.size):
        highest = max(highest, values[index])
    return highest
