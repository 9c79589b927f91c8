"""What each automaton remembers: the costs of the last runs in which it was selected."""

from __future__ import annotations

from typing import TYPE_CHECKING, NamedTuple

import numpy as np

if TYPE_CHECKING:
    from numpy.typing import NDArray

__all__ = ["Memory", "empty_memory", "forget", "remember"]


class Memory(NamedTuple):
    """The memories J of n automata for R costs each, first in, first out.

    Attributes:
        costs: (n, R), those remembered in the order of coming, round and round.
        held: how many each remembers, (n,).
        next: where the next is put, (n,).
        total: their sum, (n,).
        least: the least of them, (n,).
        times: how often the least is among them, (n,).
    """

    costs: NDArray[np.int32]
    held: NDArray[np.int64]
    next: NDArray[np.int64]
    total: NDArray[np.int64]
    least: NDArray[np.int64]
    times: NDArray[np.int64]


def empty_memory(automata: int, size: int) -> Memory:
    """Make memories without anything in them.

    Args:
        automata: n.
        size: R, from 1.
    """
    counts = [np.zeros(automata, dtype=np.int64) for _ in range(5)]
    return Memory(np.zeros((automata, size), dtype=np.int32), *counts)


def remember(memory: Memory, automaton: int, cost: int) -> None:
    """Let an automaton remember a cost, and forget the oldest where its memory is full.

    Dantas (2017), section 5.2.
    """
    size = memory.costs.shape[1]
    place = memory.next[automaton]
    held = memory.held[automaton]
    row = memory.costs[automaton]
    if held == size:
        gone = row[place]
        memory.total[automaton] -= gone
        if gone == memory.least[automaton]:
            memory.times[automaton] -= 1
    else:
        held += 1
        memory.held[automaton] = held
    row[place] = cost
    memory.total[automaton] += cost
    memory.next[automaton] = (place + 1) % size
    if memory.times[automaton] == 0:
        least, times = row[0], 0
        for index in range(held):
            if row[index] < least:
                least, times = row[index], 1
            elif row[index] == least:
                times += 1
        memory.least[automaton] = least
        memory.times[automaton] = times
    elif cost < memory.least[automaton]:
        memory.least[automaton] = cost
        memory.times[automaton] = 1
    elif cost == memory.least[automaton]:
        memory.times[automaton] += 1


def forget(memory: Memory, automaton: int) -> None:
    """Let an automaton forget everything."""
    memory.held[automaton] = 0
    memory.next[automaton] = 0
    memory.total[automaton] = 0
    memory.times[automaton] = 0
