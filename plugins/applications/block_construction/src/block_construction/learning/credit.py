"""Which cost an automaton is told: that of the whole diagram, or that of its own block."""

from __future__ import annotations

from typing import Any

from block_construction.learning.network import Network

__all__ = ["is_fault", "local_cost"]

_MIDDLE, _SINGLE = 1, 4


def is_fault(lower: int, upper: int) -> bool:
    """Tell whether the codes of a cell and of the one above are a connection fault.

    Dantas (2017), equation 5.4: ends that coincide, where a single is both ends of all blocks; 13 pairs.
    """
    return _MIDDLE not in (lower, upper) and (lower == upper or _SINGLE in (lower, upper))


def local_cost(network: Network, codes: Any, action: int) -> int:
    """Give the cost of one block: its faults with the levels directly above and below, less its units.

    The longer blocks are, the fewer there are: less the units does for one block what F_b does for all.
    Differs from the paper: it knows the cost of the whole diagram only, F_rb, for all automata.

    Args:
        network: all automata.
        codes: of all cells of the diagram.
        action: that lays the block.
    """
    cells, lower, upper = network.cells, network.below, network.above
    begin, end = network.begin[action], network.begin[action + 1]
    cost = 0
    for position in range(begin, end):
        cell = cells[position]
        below, above = lower[cell], upper[cell]
        if below >= 0 and is_fault(codes[below], codes[cell]):
            cost += 1
        if above >= 0 and is_fault(codes[cell], codes[above]):
            cost += 1
    units: int = end - begin
    return cost - units
