"""Which nodes of a lattice a robot can be at, time step by time step."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, Dict, FrozenSet, List, NamedTuple, Optional, Sequence, Set, Tuple

import numpy as np

from block_construction.team.floor import MOVES, Floor
from block_construction.team.timed_way import TimedWay, last_time, place_at, places_at

if TYPE_CHECKING:
    from numpy.typing import NDArray

__all__ = ["DIAGONAL", "STRAIGHT", "Move", "Start", "Steps", "Wavefront"]

STRAIGHT, DIAGONAL = 2, 3
"""Time steps of a move to a neighbour; waiting takes one. 3 / 2 is a little more than the root of 2."""
_CHUNK = 32
_SLACK = 1e-6


class Move(NamedTuple):
    """From a node at a time step to another; the node before the first is the start, that after the last the goal.

    Attributes:
        begin, end: time steps.
        source, target: nodes; -1 stands for the start or the goal.
    """

    begin: int
    end: int
    source: int
    target: int


class Steps(NamedTuple):
    """How time passes.

    Attributes:
        now: of step 0 [s].
        unit: between steps [s].
        most: how many there are at most.
    """

    now: float
    unit: float
    most: int


class Start(NamedTuple):
    """Where a robot begins, which is no node.

    Attributes:
        patience: for how many steps it can be waited at.
        near: how many steps it takes to each node around it.
        place: [m].
    """

    patience: int
    near: Dict[int, int]
    place: Tuple[float, float]


class Wavefront:
    """Exact earliest arrival among others' ways (Silver 2005, cooperative path finding), by sets of nodes.

    Differs from the paper: instead of searching node by node (A*), the set of all nodes that can be reached at a time
    step follows from those of the steps before, which is quicker where arrays are.

    Args:
        floor: where there is room.
        covered: columns and rows that blocks lie on.
        others: their ways.
        clearance: to be kept from them at the nodes [m].
        steps: how time passes.
        start: where it begins.
    """

    def __init__(
        self,
        floor: Floor,
        covered: FrozenSet[Tuple[int, int]],
        others: Sequence[TimedWay],
        clearance: float,
        *,
        steps: Steps,
        start: Start,
    ) -> None:
        self._lattice, self._edges = floor.lattice, floor.edges(covered)
        self._free = floor.free(covered)
        self._clearance, self._steps, self._start = clearance, steps, start
        # From those who are nearer than the clearance already one may go away.
        gaps = [math.dist(start.place, place_at(way, steps.now)) for way in others]
        self._others = [way for way, gap in zip(others, gaps) if gap >= clearance]
        self._close = [way for way, gap in zip(others, gaps) if gap < clearance]
        self._shifts = [floor.lattice.step(move) for move in range(len(MOVES))]
        rest = math.ceil((last_time(others) - steps.now) / steps.unit) if others else 0
        self._at_rest = max(rest, 0)
        self._masks: Dict[int, NDArray[np.bool_]] = {}
        self._gaps: Dict[int, NDArray[np.float64]] = {}

    def find(self, goal: Dict[int, int], earliest: int, forbidden: Set[Move]) -> Optional[List[Move]]:
        """Find the moves that come to the goal soonest.

        Args:
            goal: how many steps it takes from each node around it.
            earliest: step from which on the goal may be stood at.
            forbidden: moves that may not be made.

        Returns:
            Moves one after another, waits left out; None if the goal cannot be reached.
        """
        banned: Dict[Tuple[int, int], List[Move]] = {}
        for move in forbidden:
            banned.setdefault((move.begin, move.end), []).append(move)
        reached: List[NDArray[np.bool_]] = []
        best: Optional[Move] = None
        unchanged = 0
        for step in range(self._steps.most):
            now = self._spread(step, reached, banned)
            reached.append(now)
            for node, duration in goal.items():
                arrival = step + duration
                move = Move(step, arrival, node, -1)
                if now[node] and arrival >= earliest and (best is None or arrival < best.end) and move not in forbidden:
                    best = move
            if best is not None and step + 1 >= best.end:
                break
            same = step > self._at_rest and bool(np.array_equal(now, reached[-2]))
            unchanged = unchanged + 1 if same else 0
            if (
                best is None
                and unchanged > DIAGONAL
                and step > max(self._last_seed(), earliest, *self._bans(forbidden))
            ):
                return None
        return None if best is None else self._back(best, reached, forbidden)

    def _last_seed(self) -> int:
        # Who may wait at the start for ever has seeded everything that is ever free around it once others rest.
        return min(self._start.patience, self._at_rest) + max(self._start.near.values(), default=0)

    @staticmethod
    def _bans(forbidden: Set[Move]) -> List[int]:
        return [0, *(move.end for move in forbidden)]

    def _spread(
        self, step: int, reached: Sequence[NDArray[np.bool_]], banned: Dict[Tuple[int, int], List[Move]]
    ) -> NDArray[np.bool_]:
        mask = self._mask(step)
        now = np.zeros_like(mask)
        if step >= 1:
            now |= reached[step - 1]
            if self._close:
                now &= self._no_nearer(step - 1, step, 0)
        for node, duration in self._start.near.items():
            if 0 <= step - duration <= self._start.patience and Move(step - duration, step, -1, node) not in banned.get(
                (step - duration, step), ()
            ):
                now[node] = True
        for move, shift in enumerate(self._shifts):
            duration = STRAIGHT if move < 4 else DIAGONAL
            if step < duration:
                continue
            leaving = reached[step - duration] & self._edges[move]
            for each in banned.get((step - duration, step), ()):
                if each.source >= 0 and each.target == each.source + shift:
                    leaving[each.source] = False
            if self._close:
                leaving &= self._no_nearer(step - duration, step, shift)
            if shift > 0:
                now[shift:] |= leaving[:-shift]
            else:
                now[:shift] |= leaving[-shift:]
        now &= mask
        return now

    def _back(self, last: Move, reached: Sequence[NDArray[np.bool_]], forbidden: Set[Move]) -> List[Move]:
        """Go back from the goal, always to the earliest time at which a node could be waited at."""
        moves = [last]
        node, step = last.source, last.begin
        while node >= 0:
            move = self._before(node, step, reached, forbidden)
            if move.source != move.target:
                moves.append(move)
            node, step = move.source, move.begin
        return moves[::-1]

    def _before(self, node: int, step: int, reached: Sequence[NDArray[np.bool_]], forbidden: Set[Move]) -> Move:
        if step >= 1 and reached[step - 1][node] and (not self._close or self._no_nearer(step - 1, step, 0)[node]):
            return Move(step - 1, step, node, node)
        duration = self._start.near.get(node)
        if duration is not None and 0 <= step - duration <= self._start.patience:
            move = Move(step - duration, step, -1, node)
            if move not in forbidden:
                return move
        for number, shift in enumerate(self._shifts):
            duration = STRAIGHT if number < 4 else DIAGONAL
            source, begin = node - shift, step - duration
            if begin < 0 or not (reached[begin][source] and self._edges[number][source]):
                continue
            move = Move(begin, step, source, node)
            if move not in forbidden and (not self._close or self._no_nearer(begin, step, shift)[source]):
                return move
        raise AssertionError("every node that was reached was reached from somewhere")

    def _mask(self, step: int) -> NDArray[np.bool_]:
        """Tell which nodes are free of others at a step."""
        step = min(step, self._at_rest)
        if step not in self._masks:
            chunk = np.arange(step, max(step, min(step + _CHUNK - 1, self._at_rest)) + 1)
            times = np.asarray(self._steps.now + chunk * self._steps.unit, dtype=np.float64)
            free = np.repeat(self._free[None, :], len(chunk), axis=0)
            for way in self._others:
                there = places_at(way, times)
                dx, dy = (self._lattice.places[:, axis] - there[:, axis, None] for axis in (0, 1))
                free &= dx * dx + dy * dy >= (self._clearance - _SLACK) ** 2
            self._masks.update(zip(chunk.tolist(), free))
        return self._masks[step]

    def _no_nearer(self, begin: int, end: int, shift: int) -> NDArray[np.bool_]:
        """Tell from which nodes a move comes no nearer to those who are close, or stays far enough away."""
        before, after = self._gap(begin), np.roll(self._gap(end), -shift, axis=1)
        kept: NDArray[np.bool_] = np.all((after >= self._clearance) | (after >= before - _SLACK), axis=0)
        return kept

    def _gap(self, step: int) -> NDArray[np.float64]:
        step = min(step, self._at_rest)
        if step not in self._gaps:
            time = np.array([self._steps.now + step * self._steps.unit])
            self._gaps[step] = np.stack(
                [np.hypot(*(self._lattice.places - places_at(way, time)).T) for way in self._close]
            )
        return self._gaps[step]
