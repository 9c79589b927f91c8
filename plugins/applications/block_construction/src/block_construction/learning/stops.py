"""When training ends before its iterations are used up."""

from __future__ import annotations

from typing import Any

__all__ = ["RECENT", "greatest_probability", "hits_among_recent"]

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


def greatest_probability(probabilities: Any, first: int, end: int) -> float:
    """Give the greatest probability of an automaton's actions.

    Training ends when its mean over the automata that were selected is high enough: Dantas (2017), section 5.2.
    """
    greatest: float = probabilities[first]
    for action in range(first + 1, end):
        greatest = max(greatest, probabilities[action])
    return greatest
