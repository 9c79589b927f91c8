"""The loop of training, written so that numba can compile it; plainly it does the same, slowly."""

from __future__ import annotations

from typing import Any

from block_construction.learning.credit import local_cost
from block_construction.learning.drawing import draw_diagram
from block_construction.learning.fala import chosen_probability, other_probability
from block_construction.learning.memory import HELD, LEAST_HELD, TOTAL, remember
from block_construction.learning.network import Network
from block_construction.learning.pla import boltzmann, log_gradient, parameter_change, restoring_force
from block_construction.learning.reward import reward
from block_construction.learning.state import BEGUN, HITS, LEAST, RUN, Rules, State
from block_construction.learning.stops import greatest, hits_among_recent

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
    # Looked up once: in the loop each would be counted in and out.
    first, tally, selected, chosen = network.first, state.tally, state.selected, state.chosen
    probabilities, parameters, best = state.probabilities, state.parameters, state.best
    remembered, sums = state.memory.costs, state.memory.sums
    costs, convergence = state.costs, state.convergence
    while tally[RUN] < until:
        tally[RUN] += 1
        run = tally[RUN]
        blocks, faults = draw_diagram(network, state, random)
        cost = blocks + faults
        costs[run - 1] = cost
        tally[HITS] = hits_among_recent(tally[HITS], costs, run, tally[BEGUN], tally[LEAST])
        if cost < tally[LEAST]:
            tally[LEAST] = cost
            best[:] = -1
            for index in range(blocks):
                best[selected[index]] = chosen[index]
        certainty = 0.0
        for index in range(blocks):
            automaton, action = selected[index], chosen[index]
            told = local_cost(network, state.codes, action) if rules.local else cost
            own = sums[automaton]
            remember(remembered[automaton], own, told)
            begin, end = first[automaton], first[automaton + 1]
            if end - begin > 1:
                b = reward(own[TOTAL] / own[HELD], own[LEAST_HELD], told)
                if rules.parameterised:
                    learn_parameters(rules, probabilities[begin:end], parameters[begin:end], action - begin, b, random)
                else:
                    learn_probabilities(rules, probabilities[begin:end], action - begin, b)
            certainty += greatest(probabilities[begin:end])
        convergence[run - 1] = certainty / blocks
        if tally[HITS] >= rules.enough_hits or convergence[run - 1] >= rules.converged:
            return True
    return False


def learn_probabilities(rules: Rules, probabilities: Any, chosen: int, b: float) -> None:
    """Let an automaton of FALA learn.

    Args:
        rules: how it learns.
        probabilities: of its actions; changed.
        chosen: which of them.
        b: its reward.
    """
    for action in range(probabilities.size):
        p = probabilities[action]
        if action == chosen:
            probabilities[action] = chosen_probability(p, b, rules.rate, rules.penalty_rate)
        else:
            probabilities[action] = other_probability(p, b, rules.rate, rules.penalty_rate, probabilities.size)


def learn_parameters(  # noqa: PLR0917 - numba knows no keyword-only arguments
    rules: Rules, probabilities: Any, parameters: Any, chosen: int, b: float, random: Any
) -> None:
    """Let an automaton of PLA learn, and stray.

    Args:
        rules: how it learns.
        probabilities: of its actions; changed.
        parameters: of its actions; changed.
        chosen: which of them.
        b: its reward.
        random: a NumPy generator.
    """
    for action in range(parameters.size):
        gradient = log_gradient(probabilities[action], action == chosen)
        force = restoring_force(parameters[action], rules.stiffness, rules.bound, rules.power)
        noise = rules.noise * random.standard_normal()
        parameters[action] += parameter_change(b, gradient, force, noise, rules.rate)
    boltzmann(parameters, probabilities)
