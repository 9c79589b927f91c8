"""The planner ``pla``: a network of parameterised learning automata.

For each step of a plan there is an assembly automaton, whose actions are the blocks of the group that the step belongs
to, and for each length of blocks in that group a manipulation automaton, whose actions are the places that have such
blocks. A run draws a block, without those placed already (5.8) or in the way of others, then a place for it, step by
step. Automata that acted learn from what the whole plan costs, each by what it remembers of its own runs.
"""

from __future__ import annotations

import math
from collections import deque
from dataclasses import dataclass
from typing import TYPE_CHECKING, Callable, Deque, Dict, List, NamedTuple, Sequence, Tuple

import numpy as np

from block_construction.errors import ConstructionError
from block_construction.execution.problem import START, BuildProblem, Step
from block_construction.execution.supply import remaining_stock
from block_construction.learning.pla import boltzmann, log_gradient, parameter_change, restoring_force
from block_construction.learning.reward import reward

if TYPE_CHECKING:
    from numpy.typing import NDArray

__all__ = ["LearnedPlan", "Learning", "learn_plan", "open_share"]

_MOST_MEMORY, _MOST_ITERATIONS, _MOST_POWER = 100_000, 10_000_000, 5


@dataclass(frozen=True)
class Learning:
    """How the network learns (Dantas 2017, section 5.4 and equations 2.5 to 2.10).

    Attributes:
        rate: l1.
        memory: of how many runs an automaton remembers the costs, the source's J.
        iterations: runs.
        stiffness, bound, power: K, L and n of the force that holds parameters.
        noise: standard deviation of s.

    Raises:
        ConstructionError: one of them is out of range.
    """

    rate: float = 0.2
    memory: int = 100
    iterations: int = 4000
    stiffness: float = 1.0
    bound: float = 10.0
    power: int = 1
    noise: float = 0.1

    def __post_init__(self) -> None:
        for name, most in (("memory", _MOST_MEMORY), ("iterations", _MOST_ITERATIONS), ("power", _MOST_POWER)):
            value = getattr(self, name)
            if not 1 <= value <= most:
                raise ConstructionError(f"setting {name}: must be 1 to {most} (found {value})")
        for name, largest in (("rate", 1.0), ("stiffness", 10.0), ("bound", 100.0), ("noise", 10.0)):
            if not 0.0 <= getattr(self, name) <= largest:
                raise ConstructionError(f"setting {name}: must be 0 to {largest:g} (found {getattr(self, name)})")


class LearnedPlan(NamedTuple):
    """What a network came to.

    Attributes:
        steps: the shortest plan that it drew.
        lengths: of all plans that it drew, in order [m].
    """

    steps: Tuple[Step, ...]
    lengths: Tuple[float, ...]


class _Automaton(NamedTuple):
    """One automaton.

    Attributes:
        first: where its actions begin among those of all.
        actions: numbers of blocks or of places.
        remembered: costs of the last runs in which it acted [m].
    """

    first: int
    actions: Tuple[int, ...]
    remembered: Deque[float]


class _Choice(NamedTuple):
    """What an automaton drew: the position of the action among all automata's."""

    automaton: _Automaton
    position: int


class _Network(NamedTuple):
    """All automata: one for blocks a step, and those for places by the length of the block."""

    blocks: Tuple[_Automaton, ...]
    places: Tuple[Dict[int, _Automaton], ...]
    size: int


def learn_plan(
    problem: BuildProblem,
    learning: Learning,
    random: np.random.Generator,
    on_progress: Callable[[float], None] = lambda _: None,
) -> LearnedPlan:
    """Let a network draw plans and learn, and keep the shortest.

    Args:
        problem: what is built, and where.
        learning: how.
        random: of all chance.
        on_progress: is told which part of the work is done, from 0 to 1.

    Raises:
        ConstructionError: no plan that was drawn can be driven.

    Dantas (2017), algorithms 4 to 6.
    Differs from the paper: as printed, a way to a supply place begins at the supply place before; here it begins where
    the robot stands, as the text says. The shortest plan is kept, which the printed algorithm never stores. Blocks that
    would be in the way of others come after those, which the source does not ask. Places that have no such block any
    more are left out; the source has as many as are needed.
    """
    network = _network(problem, learning.memory)
    parameters = np.array([1.0 / len(each.actions) for each in _automata(network) for _ in each.actions])
    probabilities = parameters.copy()
    shortest = math.inf
    best: Tuple[Step, ...] = ()
    lengths: List[float] = []
    for run in range(learning.iterations):
        steps, choices, length = _drawn(problem, network, probabilities.tolist(), random)
        if math.isfinite(length):
            lengths.append(length)
            if length < shortest:
                shortest, best = length, steps
            _learn(learning, parameters, probabilities, choices, length, random)
        on_progress((run + 1) / learning.iterations)
    if not best:
        raise ConstructionError(
            f"no_path: {problem.diagram.structure.name}: in none of {learning.iterations} drawn plans is there a way "
            "to every block"
        )
    return LearnedPlan(best, tuple(lengths))


def open_share(probability: float, open_sum: float) -> float:
    """Give the probability of an action among those that are open.

        p_n = p / sum of p over the open actions

    Dantas (2017), equation 5.8.
    """
    return probability / open_sum


def _network(problem: BuildProblem, memory: int) -> _Network:
    first = 0

    def automaton(actions: Sequence[int]) -> _Automaton:
        nonlocal first
        made = _Automaton(first, tuple(actions), deque(maxlen=memory))
        first += len(actions)
        return made

    blocks: List[_Automaton] = []
    places: List[Dict[int, _Automaton]] = []
    for group in problem.groups:
        holding = {problem.block(block).units: problem.holding(block) for block in group}
        for _ in group:
            blocks.append(automaton(group))
            places.append({units: automaton([int(each) + 1 for each in holding[units]]) for units in sorted(holding)})
    return _Network(tuple(blocks), tuple(places), first)


def _automata(network: _Network) -> List[_Automaton]:
    """List all automata in the order of their actions."""
    ordered: List[_Automaton] = []
    for block, places in zip(network.blocks, network.places):
        ordered += [block, *places.values()]
    return ordered


def _drawn(
    problem: BuildProblem, network: _Network, probabilities: Sequence[float], random: np.random.Generator
) -> Tuple[Tuple[Step, ...], List[_Choice], float]:
    """Draw a plan, and measure it [m]; infinite where there is no way."""
    chances = random.random(2 * len(network.blocks)).tolist()
    stock = remaining_stock(problem.places)
    placed = [False] * (len(network.blocks) + 1)
    steps: List[Step] = []
    choices: List[_Choice] = []
    covered, last, length = 0, START, 0.0
    for number, automaton in enumerate(network.blocks):
        open_blocks = [
            index
            for index, block in enumerate(automaton.actions)
            if not placed[block] and all(placed[other] for other in problem.before[block])
        ]
        choice = _draw(automaton, open_blocks, probabilities, chances[2 * number])
        block = automaton.actions[choice.position - automaton.first]
        units = problem.block(block).units
        holder = network.places[number][units]
        open_places = [index for index, place in enumerate(holder.actions) if stock.get((place, units), 1) > 0]
        fetched = _draw(holder, open_places, probabilities, chances[2 * number + 1])
        place = holder.actions[fetched.position - holder.first]
        if (place, units) in stock:
            stock[place, units] -= 1
        choices += [choice, fetched]
        steps.append(Step(place, block))
        ways = problem.ways.lengths(covered)
        length += float(ways[place - 1, last]) + float(ways[place - 1, block])
        covered |= problem.covers[block - 1]
        placed[block] = True
        last = block
    return tuple(steps), choices, length


def _draw(automaton: _Automaton, open_actions: Sequence[int], probabilities: Sequence[float], chance: float) -> _Choice:
    """Draw one of the open actions; where all have probability 0, each is as likely."""
    weights = [probabilities[automaton.first + index] for index in open_actions]
    total = sum(weights)
    if not total > 0.0:
        return _Choice(automaton, automaton.first + open_actions[int(chance * len(open_actions))])
    reached = 0.0
    for index, weight in zip(open_actions, weights):
        reached += open_share(weight, total)
        if chance < reached:
            return _Choice(automaton, automaton.first + index)
    return _Choice(automaton, automaton.first + open_actions[-1])


def _learn(  # noqa: PLR0917 - what all automata share, then what this run was
    learning: Learning,
    parameters: NDArray[np.float64],
    probabilities: NDArray[np.float64],
    choices: Sequence[_Choice],
    length: float,
    random: np.random.Generator,
) -> None:
    """Let the automata that acted learn; those with one action have nothing to learn."""
    acted = [choice for choice in choices if len(choice.automaton.actions) > 1]
    # Differs from the paper: printed is the root of the rate, with which its tables of diagrams do not come out.
    spread = learning.rate * learning.noise
    noise = iter((spread * random.standard_normal(sum(len(each.automaton.actions) for each in acted))).tolist())
    for automaton, chosen in acted:
        automaton.remembered.append(length)
        held = automaton.remembered
        b = reward(sum(held) / len(held), min(held), length)
        actions = slice(automaton.first, automaton.first + len(automaton.actions))
        u, p = parameters[actions], probabilities[actions]
        changes = [
            parameter_change(
                b,
                log_gradient(share, action == chosen),
                restoring_force(value, learning.stiffness, learning.bound, learning.power),
                next(noise),
                learning.rate,
            )
            for action, (value, share) in enumerate(zip(u.tolist(), p.tolist()), automaton.first)
        ]
        u += changes
        boltzmann(u, p)
