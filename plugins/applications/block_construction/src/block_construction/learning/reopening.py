"""An extension of the source's training: automata around a fault forget what they learned, and learn again.

Under local credit a level's automata come to agree with their neighbours: on a high wall, levels of two patterns that
must alternate may do so in domains of opposite phase, and where these meet is a row of faults that no automaton can
improve alone. This is iterated local search (Lourenço, Martin, Stützle 2003) with training as the local search: when
training has come to rest, what it found is taken if it costs no more than what stood before, a part of it is opened
again, and training goes on.

Differs from the paper: training there ends when it has come to rest.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, List, NamedTuple, Tuple

import numpy as np

from block_construction.learning.credit import is_fault
from block_construction.learning.network import Network
from block_construction.learning.state import BEGUN, HITS, LEAST, RUN, UNKNOWN, State

if TYPE_CHECKING:
    from numpy.typing import NDArray

__all__ = ["Standing", "fault_rows", "least_blocks", "reopen", "settle"]


class Standing(NamedTuple):
    """What stands: the best diagram so far, and the automata that came to it.

    Attributes:
        cost: of the diagram.
        best: action of each automaton in it, or -1.
        probabilities, parameters: of all actions.
    """

    cost: int
    best: NDArray[np.int64]
    probabilities: NDArray[np.float64]
    parameters: NDArray[np.float64]


def least_blocks(network: Network, longest: int) -> int:
    """Give a cost below which no diagram is: blocks that each level of each layer needs at the least.

    Args:
        network: of the structure.
        longest: units of the longest block.
    """
    parts = np.stack([network.layer, network.level])
    counts = np.unique(parts, axis=1, return_counts=True)[1]
    return int(sum(-(-int(count) // longest) for count in counts))


def settle(state: State, standing: Standing) -> Standing:
    """Take what a leg of training found, unless it costs more than what stands.

    Args:
        state: at the end of the leg; automata go back to what they were if its diagram is not taken.
        standing: before the leg.
    """
    cost = int(state.tally[LEAST])
    if cost <= standing.cost:
        return Standing(cost, state.best.copy(), state.probabilities.copy(), state.parameters.copy())
    state.probabilities[:] = standing.probabilities
    state.parameters[:] = standing.parameters
    return standing


def fault_rows(network: Network, best: NDArray[np.int64]) -> List[Tuple[int, int]]:
    """List where faults of a diagram are: layer and lower level, each once, sorted.

    Args:
        network: of the structure.
        best: action of each automaton in the diagram, or -1.
    """
    codes = np.zeros(network.above.size, dtype=np.int64)
    for action in best[best >= 0]:
        covered = slice(network.begin[action], network.begin[action + 1])
        codes[network.cells[covered]] = network.codes[covered]
    return sorted(
        {
            (int(network.layer[cell]), int(network.level[cell]))
            for cell, above in enumerate(network.above)
            if above >= 0 and is_fault(int(codes[cell]), int(codes[above]))
        }
    )


def reopen(network: Network, state: State, standing: Standing, random: Any) -> None:
    """Let automata of some levels beside a row of faults begin anew; all forget the costs they remember.

    The row is drawn, then whether levels above or below it, then how many from it on. Where there is no fault, which
    levels of which layer is drawn.

    Args:
        network: of the structure.
        state: of training; changed.
        standing: whose diagram's faults are meant.
        random: a NumPy generator.
    """
    rows = fault_rows(network, standing.best)
    if rows:
        layer, lower = rows[int(random.integers(len(rows)))]
        top = int(network.level[network.layer == layer].max())
        if random.random() < 0.5:
            low, high = lower + 1, lower + 1 + int(random.integers(top - lower))
        else:
            low, high = lower - int(random.integers(lower)), lower
    else:
        layers = np.unique(network.layer)
        layer = int(layers[int(random.integers(layers.size))])
        top = int(network.level[network.layer == layer].max())
        low, high = sorted(int(each) for each in random.integers(1, top + 1, size=2))
    opened = (network.layer == layer) & (network.level >= low) & (network.level <= high)
    for automaton in np.flatnonzero(opened).tolist():
        actions = slice(network.first[automaton], network.first[automaton + 1])
        state.probabilities[actions] = state.parameters[actions] = 1.0 / (actions.stop - actions.start)
    # Without any costs held, whatever else is remembered counts no more.
    state.memory.sums[:] = 0
    state.tally[BEGUN], state.tally[LEAST], state.tally[HITS] = state.tally[RUN], UNKNOWN, 0
