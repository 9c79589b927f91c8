"""Drawing one diagram: automata choose actions until every cell is covered."""

from __future__ import annotations

from typing import Any, NamedTuple, Tuple

from block_construction.learning.credit import is_fault
from block_construction.learning.network import Network
from block_construction.learning.state import RUN, State

__all__ = ["Reach", "draw_action", "draw_diagram", "is_open"]


class Reach(NamedTuple):
    """Where actions reach, and what is covered.

    Attributes:
        begin, cells: as in the network.
        covered: the last run in which each cell was covered.
    """

    begin: Any
    cells: Any
    covered: Any


def is_open(reach: Reach, run: int, action: int) -> bool:
    """Tell whether no block of this run lies where an action's block would, but for its first cell."""
    begin, cells, covered = reach
    for position in range(begin[action] + 1, begin[action + 1]):  # noqa: SIM110 - numba compiles no generators
        if covered[cells[position]] == run:
            return False
    return True


def draw_action(  # noqa: PLR0917 - numba knows no keyword-only arguments
    reach: Reach, run: int, first: int, end: int, probabilities: Any, random: Any
) -> int:
    """Draw an automaton's action among those that are still open, by their probabilities.

    Differs from the paper: it draws from all, though cells may be covered already by a block along y of a lower row;
    here such actions are left out, as its execution plan does (equation 5.8). Where all open ones have probability 0,
    each is as likely.

    Args:
        reach: of all actions.
        run: this one.
        first: the automaton's first action, which is to lay one unit and always open.
        end: where its actions end.
        probabilities: of all actions.
        random: a NumPy generator; not asked where one action only is open.
    """
    total, count, last = 0.0, 0, first
    for action in range(first, end):
        if is_open(reach, run, action):
            total += probabilities[action]
            count += 1
            last = action
    if count == 1:
        return last
    aim = random.random() * (total if total > 0.0 else count)
    reached = 0.0
    for action in range(first, last):
        if is_open(reach, run, action):
            reached += probabilities[action] if total > 0.0 else 1.0
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
    # Looked up once: in the loop each would be counted in and out.
    first, begin, cells, ends, lower = network.first, network.begin, network.cells, network.codes, network.below
    covered, codes, selected, chosen = state.covered, state.codes, state.selected, state.chosen
    probabilities, run = state.probabilities, state.tally[RUN]
    reach = Reach(begin, cells, covered)
    count, faults = 0, 0
    for automaton in range(codes.size):
        if covered[automaton] == run:
            continue
        action = draw_action(reach, run, first[automaton], first[automaton + 1], probabilities, random)
        for position in range(begin[action], begin[action + 1]):
            cell = cells[position]
            covered[cell] = run
            codes[cell] = ends[position]
            # Levels are numbered upwards, so that the one below is complete.
            below = lower[cell]
            if below >= 0 and is_fault(codes[below], codes[cell]):
                faults += 1
        selected[count] = automaton
        chosen[count] = action
        count += 1
    return count, faults
