"""The planner ``local``: a beam over what is placed, then moves within groups, for structures too large for ``exact``.

The beam keeps, after every block, the states with the least

    length so far + from the last block to the nearest place
                  + sum over the group's other blocks of (nearest place to it + it to the nearest place)

which is a lower bound of the whole group's length, for ways only grow longer as blocks are placed. Of two states with
the same blocks placed and the same one placed last, the longer is dropped, as in the programme of ``exact``; a beam
that drops no others finds what that finds. Afterwards each block is tried a few places earlier and later in its
group; the same is done to the plan of ``greedy``, and the shorter one is taken.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Callable, Dict, List, NamedTuple, Optional, Sequence, Tuple

import numpy as np

from block_construction.errors import ConstructionError
from block_construction.execution.cost import plan_cost
from block_construction.execution.greedy import plan_greedily
from block_construction.execution.order import Group
from block_construction.execution.problem import START, BuildProblem, Step
from block_construction.execution.supply import remaining_stock

if TYPE_CHECKING:
    from numpy.typing import NDArray

__all__ = ["plan_locally"]

_FARTHEST_MOVE = 4
"""So many places a block is moved within its group's order: each changes what is in the way of those between."""
_LEAST_GAIN = 1e-9
"""What is shorter by less is as long [m]."""

_Stock = Tuple[Tuple[Tuple[int, int], int], ...]


class _State(NamedTuple):
    """One way to have placed some blocks.

    Attributes:
        estimate: length, and the lower bound of what the rest of the group costs [m].
        length: so far [m].
        covered: columns and rows that blocks lie on.
        placed: blocks of this group, bit by bit.
        stock: what is left where there is not as much as is needed.
        step: the last.
        before: how it came here.
    """

    estimate: float
    length: float
    covered: int
    placed: int
    stock: _Stock
    step: Step
    before: Optional[_State]


def plan_locally(
    problem: BuildProblem, *, beam: int, on_progress: Callable[[float], None] = lambda _: None
) -> Tuple[Step, ...]:
    """Find a short plan for the problem's order of groups.

    Args:
        problem: what is built, and where.
        beam: so many states are kept after each block.
        on_progress: is told which part of the work is done, from 0 to 1.

    Raises:
        ConstructionError: no plan was found.
    """
    found: List[List[Step]] = []
    why: List[ConstructionError] = []
    finders: Tuple[Callable[[], List[Step]], ...] = (
        lambda: _by_beam(problem, beam, on_progress),
        lambda: list(plan_greedily(problem)),
    )
    for find in finders:
        try:
            found.append(find())
        except ConstructionError as error:
            why.append(error)
    if not found:
        raise why[0]
    polished = [_polished(problem, steps) for steps in found]
    on_progress(1.0)
    return min(polished, key=lambda steps: (plan_cost(problem, steps).total, steps))


def _by_beam(problem: BuildProblem, beam: int, on_progress: Callable[[float], None]) -> List[Step]:
    """Keep the best states after each block.

    Raises:
        ConstructionError: none is left.
    """
    states = [_State(0.0, 0.0, 0, 0, tuple(sorted(remaining_stock(problem.places).items())), Step(0, START), None)]
    blocks = len(problem.diagram.blocks)
    done = 0
    for group in problem.groups:
        bounds = _Bounds.of(problem, states[0].covered, group)
        rest = sum(bounds.placing) + sum(bounds.leaving[block] for block in group)
        states = [
            each._replace(placed=0, estimate=each.length + bounds.leaving[each.step.block] + rest) for each in states
        ]
        for _ in group:
            states = _extended(problem, states, group, bounds)[:beam]
            if not states:
                raise ConstructionError(
                    f"no_path: {problem.diagram.structure.name}: local found no order of the group of block "
                    f"{group[0]} in which every block can be fetched and placed"
                )
            done += 1
            on_progress(0.9 * done / blocks)
    return _steps(min(states, key=lambda each: (each.length, each.step)))


class _Bounds(NamedTuple):
    """The least that blocks of a group can cost once others of it are placed [m].

    Attributes:
        placing: from the nearest supply place to each of the group, in its order.
        leaving: from each block, by number, or the start, to the nearest supply place.
    """

    placing: Tuple[float, ...]
    leaving: NDArray[np.float64]

    @classmethod
    def of(cls, problem: BuildProblem, covered: int, group: Group) -> _Bounds:
        """Measure them before any of the group is placed."""
        lengths = problem.ways.lengths(covered)
        leaving: NDArray[np.float64] = lengths.min(axis=0)
        return cls(tuple(float(lengths[problem.holding(block), block].min()) for block in group), leaving)


def _extended(problem: BuildProblem, states: Sequence[_State], group: Group, bounds: _Bounds) -> List[_State]:
    """Place one more block in every possible way, and sort what comes out by its estimate."""
    best: Dict[Tuple[int, int, _Stock], _State] = {}
    needs = [sum(1 << group.index(other) for other in problem.before[block]) for block in group]
    for state in states:
        lengths, last, stock = problem.ways.lengths(state.covered), state.step.block, dict(state.stock)
        for index, block in enumerate(group):
            if state.placed >> index & 1 or needs[index] & ~state.placed:
                continue
            for step, length in _options(problem, lengths[:, last] + lengths[:, block], block, stock):
                total = state.length + length
                placed = state.placed | 1 << index
                left = _taken(state.stock, step.place, problem.block(block).units)
                key = (placed, block, left)
                known = best.get(key)
                if known is None or total < known.length:
                    estimate = state.estimate + length - bounds.placing[index] - float(bounds.leaving[last])
                    covered = state.covered | problem.covers[block - 1]
                    best[key] = _State(estimate, total, covered, placed, left, step, state)
    return sorted(best.values(), key=lambda each: (each.estimate, each.placed, each.step))


def _options(
    problem: BuildProblem, both: NDArray[np.float64], block: int, stock: Dict[Tuple[int, int], int]
) -> List[Tuple[Step, float]]:
    """List places to fetch a block from: the nearest, and wherever blocks may run out all that have some."""
    units = problem.block(block).units
    places = [int(place) for place in problem.holding(block) if stock.get((int(place) + 1, units), 1) > 0]
    options = sorted((float(both[place]), place) for place in places if np.isfinite(both[place]))
    limited = any((place + 1, units) in stock for place in places)
    return [(Step(place + 1, block), length) for length, place in (options if limited else options[:1])]


def _taken(stock: _Stock, place: int, units: int) -> _Stock:
    return tuple((key, count - (key == (place, units))) for key, count in stock)


def _steps(state: _State) -> List[Step]:
    steps: List[Step] = []
    walked: Optional[_State] = state
    while walked is not None and walked.step.block != START:
        steps.append(walked.step)
        walked = walked.before
    return steps[::-1]


def _polished(problem: BuildProblem, steps: List[Step]) -> Tuple[Step, ...]:
    """Move blocks within their groups for as long as that shortens the plan."""
    limited = bool(remaining_stock(problem.places))
    ends = np.cumsum([len(group) for group in problem.groups])
    improved = True
    while improved:
        improved = False
        for first, end in zip([0, *map(int, ends[:-1])], map(int, ends)):
            for source in range(first, end):
                for target in range(max(first, source - _FARTHEST_MOVE), min(end, source + _FARTHEST_MOVE + 1)):
                    low, high = min(source, target), max(source, target) + 1
                    moved = steps[:]
                    moved.insert(target, moved.pop(source))
                    if not _is_open(problem, moved[low:high]):
                        continue
                    old = _window(problem, steps, low, high, choose=False)
                    new = _window(problem, moved, low, high, choose=not limited)
                    if sum(new[1]) < sum(old[1]) - _LEAST_GAIN:
                        steps, improved = [*moved[:low], *new[0], *moved[low + len(new[0]) :]], True
    return tuple(steps)


def _is_open(problem: BuildProblem, steps: Sequence[Step]) -> bool:
    """Tell whether no step of a group places what is in the way of a later one."""
    return all(
        step.block not in problem.before[earlier.block] for index, step in enumerate(steps) for earlier in steps[:index]
    )


def _window(
    problem: BuildProblem, steps: Sequence[Step], low: int, high: int, *, choose: bool
) -> Tuple[List[Step], List[float]]:
    """Measure the steps from ``low`` to the one after the window, all that a change within it can change.

    Args:
        problem: what is built, and where.
        steps: of the whole plan.
        low: where the window begins.
        high: where it ends.
        choose: fetch each block from where both ways together are shortest, instead of from the step's place.
    """
    covered = problem.covered_by([step.block for step in steps[:low]])
    last = steps[low - 1].block if low else START
    taken: List[Step] = []
    lengths: List[float] = []
    for step in steps[low : high + 1]:
        trip = problem.nearest_trip(covered, last, step.block) if choose else problem.trip(covered, last, step)
        taken.append(trip.step)
        lengths.append(trip.length)
        covered |= problem.covers[step.block - 1]
        last = step.block
    return taken, lengths
