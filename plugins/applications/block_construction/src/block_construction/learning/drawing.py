"""Drawing one diagram: automata choose actions until every cell is covered."""

from __future__ import annotations

from typing import Any, Tuple

from block_construction.learning.credit import is_fault
from block_construction.learning.network import Network
from block_construction.learning.state import RUN, State

__all__ = ["draw_action", "draw_diagram", "is_open"]


def is_open(network: Network, state: State, action: int) -> bool:
    """Tell whether no block of this run lies where an action's block would, but for its first cell."""
    for position in range(network.begin[action] + 1, network.begin[action + 1]):
        if state.covered[network.cells[position]] == state.tally[RUN]:
            return False
    return True


def draw_action(network: Network, state: State, automaton: int, random: Any) -> int:
    """Draw an automaton's action among those that are still open, by their probabilities.

    Differs from the paper: it draws from all, though cells may be covered already by a block along y of a lower row;
    here such actions are left out, as its execution plan does (equation 5.8). Where all open ones have probability 0,
    each is as likely.

    Args:
        network: all automata.
        state: of this run.
        automaton: which, and its own cell is not covered.
        random: a NumPy generator; not asked where one action only is open.
    """
    first: int = network.first[automaton]
    end: int = network.first[automaton + 1]
    total, count, last = 0.0, 0, first
    for action in range(first, end):
        if is_open(network, state, action):
            total += state.probabilities[action]
            count += 1
            last = action
    if count == 1:
        return last
    aim = random.random() * (total if total > 0.0 else count)
    reached = 0.0
    for action in range(first, last):
        if is_open(network, state, action):
            reached += state.probabilities[action] if total > 0.0 else 1.0
            if aim < reached:
                return action
    return last


def draw_diagram(network: Network, state: State, random: Any) -> Tuple[int, int]:
    """Draw a diagram: the lowest automaton whose cell nothing covers chooses, again and again.

    Args:
        network: all automata.
        state: the diagram is written to it.
        random: a NumPy generator.

    Returns:
        How many automata chose, which is the number of blocks; how many connection faults there are.

    Dantas (2017), algorithm 1, and equation 5.4 for the faults.
    """
    codes, run = state.codes, state.tally[RUN]
    count, faults = 0, 0
    for automaton in range(codes.size):
        if state.covered[automaton] == run:
            continue
        action = draw_action(network, state, automaton, random)
        for position in range(network.begin[action], network.begin[action + 1]):
            cell = network.cells[position]
            state.covered[cell] = run
            codes[cell] = network.codes[position]
            # Levels are numbered upwards, so that the one below is complete.
            below = network.below[cell]
            if below >= 0 and is_fault(codes[below], codes[cell]):
                faults += 1
        state.selected[count] = automaton
        state.chosen[count] = action
        count += 1
    return count, faults
