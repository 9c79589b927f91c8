"""The loop of training, written so that numba can compile it; plainly it does the same, slowly."""

from __future__ import annotations

from typing import Any

from block_construction.learning.credit import local_cost
from block_construction.learning.drawing import draw_diagram
from block_construction.learning.fala import chosen_probability, other_probability
from block_construction.learning.memory import remember
from block_construction.learning.network import Network
from block_construction.learning.pla import boltzmann, log_gradient, parameter_change, restoring_force
from block_construction.learning.reward import reward
from block_construction.learning.state import BEGUN, HITS, LEAST, RUN, Rules, State
from block_construction.learning.stops import greatest_probability, hits_among_recent

__all__ = ["learn_parameters", "learn_probabilities", "train"]


def train(network: Network, rules: Rules, state: State, random: Any, until: int) -> bool:
    """Draw diagrams and learn from them.

    Dantas (2017), algorithm 2.
    Differs from the paper: the new least cost is kept, which it leaves out.

    Args:
        network: all automata.
        rules: how they learn.
        state: where to begin; changed.
        random: a NumPy generator.
        until: how many runs there shall have been.

    Returns:
        Whether a stop criterion ended it before.
    """
    tally, memory = state.tally, state.memory
    while tally[RUN] < until:
        tally[RUN] += 1
        run = tally[RUN]
        blocks, faults = draw_diagram(network, state, random)
        cost = blocks + faults
        state.costs[run - 1] = cost
        tally[HITS] = hits_among_recent(tally[HITS], state.costs, run, tally[BEGUN], tally[LEAST])
        if cost < tally[LEAST]:
            tally[LEAST] = cost
            state.best[:] = -1
            for index in range(blocks):
                state.best[state.selected[index]] = state.chosen[index]
        certainty = 0.0
        for index in range(blocks):
            automaton, action = state.selected[index], state.chosen[index]
            told = local_cost(network, state.codes, action) if rules.local else cost
            remember(memory, automaton, told)
            first, end = network.first[automaton], network.first[automaton + 1]
            if end - first == 1:
                certainty += 1.0
                continue
            b = reward(memory.total[automaton] / memory.held[automaton], memory.least[automaton], told)
            if rules.parameterised:
                learn_parameters(network, rules, state, index, b, random)
            else:
                learn_probabilities(network, rules, state, index, b)
            certainty += greatest_probability(state.probabilities, first, end)
        state.convergence[run - 1] = certainty / blocks
        if tally[HITS] >= rules.enough_hits or state.convergence[run - 1] >= rules.converged:
            return True
    return False


def learn_probabilities(network: Network, rules: Rules, state: State, index: int, b: float) -> None:
    """Let an automaton of FALA learn.

    Args:
        network: all automata.
        rules: how they learn.
        state: changed.
        index: of the automaton among those that were selected.
        b: its reward.
    """
    automaton = state.selected[index]
    first, end = network.first[automaton], network.first[automaton + 1]
    for action in range(first, end):
        p = state.probabilities[action]
        if action == state.chosen[index]:
            state.probabilities[action] = chosen_probability(p, b, rules.rate, rules.penalty_rate)
        else:
            state.probabilities[action] = other_probability(p, b, rules.rate, rules.penalty_rate, end - first)


def learn_parameters(  # noqa: PLR0917 - numba knows no keyword-only arguments
    network: Network, rules: Rules, state: State, index: int, b: float, random: Any
) -> None:
    """Let an automaton of PLA learn, and stray.

    Args:
        network: all automata.
        rules: how they learn.
        state: changed.
        index: of the automaton among those that were selected.
        b: its reward.
        random: a NumPy generator.
    """
    automaton = state.selected[index]
    first, end = network.first[automaton], network.first[automaton + 1]
    for action in range(first, end):
        gradient = log_gradient(state.probabilities[action], action == state.chosen[index])
        force = restoring_force(state.parameters[action], rules.stiffness, rules.bound, rules.power)
        noise = rules.noise * random.standard_normal()
        state.parameters[action] += parameter_change(b, gradient, force, noise, rules.rate)
    boltzmann(state.parameters, state.probabilities, first, end)
