"""One training, from a structure to the best diagram seen."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, Callable, NamedTuple, Optional, Tuple

import numpy as np

from block_construction.errors import ConstructionError
from block_construction.learning.compiled import training_loop
from block_construction.learning.network import Network, network_of, placements_of
from block_construction.learning.reopening import Standing, least_blocks, reopen, settle
from block_construction.learning.state import BEGUN, LEAST, RUN, UNKNOWN, Rules, initial_state
from rqt_mrta_py.hooks import BlockPlacement, Structure

if TYPE_CHECKING:
    from numpy.typing import NDArray

__all__ = ["Course", "Training", "learn", "prepare"]

_STEPS = 100
"""How often progress is told."""


class Course(NamedTuple):
    """How long a training lasts.

    Attributes:
        memory: R.
        iterations: at most.
        leg: of these, how many at most before some automata begin anew; None: they never do.
    """

    memory: int
    iterations: int
    leg: Optional[int] = None


class Training(NamedTuple):
    """What a training came to.

    Attributes:
        placements: of the best diagram seen.
        cost: of that.
        bound: no diagram costs less.
        costs: of all runs.
        convergence: mean of the selected automata's greatest probabilities, after each run.
    """

    placements: Tuple[BlockPlacement, ...]
    cost: int
    bound: int
    costs: NDArray[np.int32]
    convergence: NDArray[np.float64]


def prepare(rules: Rules, *, compiled: bool) -> None:
    """Make the loop of training ready, which takes seconds where numba compiles it the first time; nothing is learned.

    Args:
        rules: of any training.
        compiled: whether by numba.
    """
    network = network_of(Structure("cell", ((1,),)), (1,))
    training_loop(compiled)(network, rules, initial_state(network, 1, 1), np.random.default_rng(0), 0)


def learn(
    network: Network,
    rules: Rules,
    course: Course,
    random: Any,
    *,
    compiled: bool,
    on_progress: Callable[[float], None] = lambda _: None,
) -> Training:
    """Train a network.

    Args:
        network: of the structure.
        rules: how automata learn.
        course: how long.
        random: a NumPy generator; the same training has the same outcome.
        compiled: whether by numba; the outcome is the same.
        on_progress: is told which part of the iterations is done, from 0 to 1.

    Raises:
        ConstructionError: parameters of PLA grew beyond all bounds.
    """
    loop = training_loop(compiled)
    iterations = course.iterations
    state = initial_state(network, course.memory, iterations)
    standing = Standing(UNKNOWN, state.best, state.probabilities, state.parameters)
    bound = least_blocks(network, int(np.abs(network.lengths).max()))
    step = max(1, iterations // _STEPS)
    while True:
        run = int(state.tally[RUN])
        until = min(iterations, run + step)
        if course.leg:
            until = min(until, int(state.tally[BEGUN]) + course.leg)
        # Whether parameters stay finite is asked in the end.
        with np.errstate(over="ignore", invalid="ignore"):
            at_rest = loop(network, rules, state, random, until)
        run = int(state.tally[RUN])
        on_progress(run / iterations)
        if course.leg is None:
            if at_rest or run == iterations:
                break
        elif at_rest or run == iterations or run == state.tally[BEGUN] + course.leg or state.tally[LEAST] == bound:
            standing = settle(state, standing)
            if run == iterations or standing.cost == bound:
                break
            reopen(network, state, standing, random)
    if not np.isfinite(state.parameters).all():
        raise ConstructionError("parameters of automata grew beyond all bounds; lower rate, stiffness, power or noise")
    best, cost = (standing.best, standing.cost) if course.leg else (state.best, int(state.tally[LEAST]))
    return Training(placements_of(network, best.tolist()), cost, bound, state.costs[:run], state.convergence[:run])
