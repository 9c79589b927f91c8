"""How automata learn, and what they have come to, as numbers and arrays that loops can be compiled over."""

from __future__ import annotations

from typing import TYPE_CHECKING, NamedTuple

import numpy as np

from block_construction.learning.memory import Memory, empty_memory
from block_construction.learning.network import Network

if TYPE_CHECKING:
    from numpy.typing import NDArray

__all__ = ["BEGUN", "HITS", "LEAST", "RUN", "UNKNOWN", "Rules", "State", "initial_state"]

RUN, BEGUN, LEAST, HITS = 0, 1, 2, 3
"""Where a state's tally counts runs, those before this leg of training, its least cost, and its recent runs of that."""
UNKNOWN = 2**31 - 1
"""More than anything costs."""


class Rules(NamedTuple):
    """How automata learn.

    Attributes:
        parameterised: PLA; else FALA.
        local: each selected automaton is told the cost of its own block; else all that of the diagram.
        rate: l1.
        penalty_rate: l2 of FALA.
        stiffness, bound, power: K, L and n of PLA.
        noise: standard deviation of what strays into PLA's parameters: that of s, times l1 or sqrt(l1).
        enough_hits: w; 101: never.
        converged: training ends when the mean of the selected automata's greatest probabilities is so high; above 1:
            never.
    """

    parameterised: bool
    local: bool
    rate: float
    penalty_rate: float
    stiffness: float
    bound: float
    power: int
    noise: float
    enough_hits: int
    converged: float


class State(NamedTuple):
    """What training has come to.

    Attributes:
        probabilities, parameters: of all actions; FALA has no parameters.
        memory: of all automata.
        covered: the last run in which each cell was covered.
        codes: of the last diagram's cells.
        selected, chosen: automata of the last diagram and their actions, as many as it has blocks.
        best: action of each automaton in the first diagram of the least cost, or -1.
        costs: of all runs.
        convergence: mean of the selected automata's greatest probabilities, after each run.
        tally: see above.
    """

    probabilities: NDArray[np.float64]
    parameters: NDArray[np.float64]
    memory: Memory
    covered: NDArray[np.int64]
    codes: NDArray[np.int64]
    selected: NDArray[np.int64]
    chosen: NDArray[np.int64]
    best: NDArray[np.int64]
    costs: NDArray[np.int32]
    convergence: NDArray[np.float64]
    tally: NDArray[np.int64]


def initial_state(network: Network, memory: int, iterations: int) -> State:
    """Make automata that know nothing: p = 1/k, equation 5.3, and for PLA u = 1/k.

    Args:
        network: all automata.
        memory: R.
        iterations: at most.
    """
    counts = np.diff(network.first)
    uniform = np.repeat(1.0 / counts, counts)
    automata = counts.size
    covered, codes, selected, chosen = (np.zeros(automata, dtype=np.int64) for _ in range(4))
    return State(
        *(uniform, uniform.copy(), empty_memory(automata, memory), covered, codes, selected, chosen),
        best=np.full(automata, -1, dtype=np.int64),
        costs=np.zeros(iterations, dtype=np.int32),
        convergence=np.zeros(iterations),
        tally=np.array([0, 0, UNKNOWN, 0], dtype=np.int64),
    )
