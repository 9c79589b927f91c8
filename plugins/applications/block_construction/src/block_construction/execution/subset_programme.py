"""The planner ``exact``: a dynamic programme over what is placed of a group, and the block placed last.

What lies in the way depends on the set of placed blocks only, not on their order. Of all orders of a subset that end
with the same block, only the shortest matters for what follows:

    least(S + b, b) = min over a in S of least(S, a) + trip(S, a, b)

where trip(S, a, b) is the shortest way from the pose of a, by a place that has b's length, to the pose of b; there is
none while a block that b would be in the way of is not in S. Groups follow one another, each entered from every block
that the one before may have ended with.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Callable, Dict, List, Tuple

import numpy as np

from block_construction.errors import ConstructionError
from block_construction.execution.order import Group
from block_construction.execution.problem import START, BuildProblem, Step
from block_construction.execution.supply import remaining_stock

if TYPE_CHECKING:
    from numpy.typing import NDArray

__all__ = ["LARGEST_GROUP", "plan_exactly"]

LARGEST_GROUP = 15
"""So many blocks may be in a group: each more doubles the work."""


def plan_exactly(problem: BuildProblem, on_progress: Callable[[float], None] = lambda _: None) -> Tuple[Step, ...]:
    """Find the shortest plan for the problem's order of groups and its side of approach for each block.

    Args:
        problem: what is built, and where.
        on_progress: is told which part of the work is done, from 0 to 1.

    Raises:
        ConstructionError: a group has too many blocks, there is no plan, or the shortest takes more blocks from a place
            than there are.
    """
    largest = max(problem.groups, key=len)
    if len(largest) > LARGEST_GROUP:
        block = problem.block(largest[0])
        raise ConstructionError(
            f"exact: layer {block.layer} on level {block.placement.z} has {len(largest)} blocks; up to {LARGEST_GROUP} "
            "are accepted; take the method local"
        )
    entries: Dict[int, float] = {START: 0.0}
    traces: List[_GroupTrace] = []
    covered, done, work = 0, 0, sum(2 ** len(group) for group in problem.groups)
    for group in problem.groups:
        trace = _solve_group(problem, covered, group, entries)
        traces.append(trace)
        entries = trace.ends()
        covered |= problem.covered_by(group)
        done += 2 ** len(group)
        on_progress(done / work)
    last = min(entries, key=lambda block: (entries[block], block))
    if not np.isfinite(entries[last]):
        raise ConstructionError(
            f"no_path: {problem.diagram.structure.name}: blocks close the way to others in every order"
        )
    order: List[int] = []
    for trace in reversed(traces):
        part, last = trace.back(last)
        order[:0] = part
    steps = _with_places(problem, order)
    _check_stock(problem, steps)
    return steps


class _GroupTrace:
    """Least lengths of one group: ``least[S, b]`` with the way there."""

    def __init__(self, group: Group, least: NDArray[np.float64], before: NDArray[np.int64]) -> None:
        self._group = group
        self._least = least
        self._before = before

    def ends(self) -> Dict[int, float]:
        """Give the least length of the whole so far, by the group's last block."""
        return {block: float(self._least[-1, index]) for index, block in enumerate(self._group)}

    def back(self, last: int) -> Tuple[List[int], int]:
        """Give the group's order that ends with a block, and the last block before the group."""
        subset, index = len(self._least) - 1, self._group.index(last)
        order: List[int] = []
        while True:
            order.insert(0, self._group[index])
            before = int(self._before[subset, index])
            subset &= ~(1 << index)
            if not subset:
                return order, before
            index = before


def _solve_group(problem: BuildProblem, covered: int, group: Group, entries: Dict[int, float]) -> _GroupTrace:
    count = len(group)
    members = np.array(group, dtype=np.int64)
    least = np.full((1 << count, count), np.inf)
    before = np.zeros((1 << count, count), dtype=np.int64)
    starts = np.array(sorted(entries), dtype=np.int64)
    reached = np.array([entries[int(start)] for start in starts])
    needs = [sum(1 << group.index(other) for other in problem.before[block]) for block in group]
    for index, block in enumerate(group):
        if needs[index]:
            continue
        both = reached + _trips(problem, covered, starts, block)
        best = int(np.argmin(both))
        least[1 << index, index] = both[best]
        before[1 << index, index] = starts[best]
    masks = [problem.covers[block - 1] for block in group]
    for subset in range(1, (1 << count) - 1):
        if not np.isfinite(least[subset]).any():
            continue
        now = covered
        for index in range(count):
            if subset >> index & 1:
                now |= masks[index]
        for index, block in enumerate(group):
            if subset >> index & 1 or needs[index] & ~subset:
                continue
            both = least[subset] + _trips(problem, now, members, block)
            best = int(np.argmin(both))
            least[subset | 1 << index, index] = both[best]
            before[subset | 1 << index, index] = best
    return _GroupTrace(group, least, before)


def _trips(problem: BuildProblem, covered: int, lasts: NDArray[np.int64], block: int) -> NDArray[np.float64]:
    """Measure the shortest ways from several poses, by one place each, to a block's pose [m]."""
    lengths, places = problem.ways.lengths(covered), problem.holding(block)
    trips: NDArray[np.float64] = (lengths[np.ix_(places, lasts)] + lengths[places, block][:, None]).min(axis=0)
    return trips


def _with_places(problem: BuildProblem, order: List[int]) -> Tuple[Step, ...]:
    steps: List[Step] = []
    covered, last = 0, START
    for block in order:
        steps.append(problem.nearest_trip(covered, last, block).step)
        covered |= problem.covers[block - 1]
        last = block
    return tuple(steps)


def _check_stock(problem: BuildProblem, steps: Tuple[Step, ...]) -> None:
    for (place, units), there in sorted(remaining_stock(problem.places).items()):
        taken = sum(step.place == place and problem.block(step.block).units == units for step in steps)
        if taken > there:
            raise ConstructionError(
                f"exact: the shortest plan takes {taken} blocks of {units} units from supply place {place}, which has "
                f"{there}; take the method local or greedy"
            )
