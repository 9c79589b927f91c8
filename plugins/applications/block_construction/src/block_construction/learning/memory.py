"""What each automaton remembers: the costs of the last runs in which it was selected."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np

if TYPE_CHECKING:
    from numpy.typing import NDArray

__all__ = ["HELD", "LEAST_HELD", "TOTAL", "Memory", "empty_memory", "remember"]

HELD, TOTAL, LEAST_HELD, _TIMES, _NEXT = range(5)
"""Columns of a memory's sums: how many costs, their sum, the least, how often it is among them, where the next goes."""


class Memory(NamedTuple):
    """The memories J of n automata for R costs each, first in, first out.

    Attributes:
        costs: (n, R), those remembered in the order of coming, round and round.
        sums: of each automaton, (n, 5), see above.
    """

    costs: NDArray[np.int32]
    sums: NDArray[np.int64]


def empty_memory(automata: int, size: int) -> Memory:
    """Make memories without anything in them.

    Args:
        automata: n.
        size: R, from 1.
    """
    return Memory(np.zeros((automata, size), dtype=np.int32), np.zeros((automata, 5), dtype=np.int64))


def remember(costs: Any, sums: Any, cost: int) -> None:
    """Let an automaton remember a cost, and forget the oldest where its memory is full.

    Args:
        costs: the automaton's row of the memory; written to.
        sums: the automaton's; written to.
        cost: of this run.

    Dantas (2017), section 5.2.
    """
    size = costs.size
    place, held = sums[_NEXT], sums[HELD]
    if held == size:
        gone = costs[place]
        sums[TOTAL] -= gone
        if gone == sums[LEAST_HELD]:
            sums[_TIMES] -= 1
    else:
        held += 1
        sums[HELD] = held
    costs[place] = cost
    sums[TOTAL] += cost
    sums[_NEXT] = place + 1 if place + 1 < size else 0
    if sums[_TIMES] == 0:
        least, times = costs[0], 0
        for index in range(held):
            if costs[index] < least:
                least, times = costs[index], 1
            elif costs[index] == least:
                times += 1
        sums[LEAST_HELD] = least
        sums[_TIMES] = times
    elif cost < sums[LEAST_HELD]:
        sums[LEAST_HELD] = cost
        sums[_TIMES] = 1
    elif cost == sums[LEAST_HELD]:
        sums[_TIMES] += 1
