"""The shortest open path of one robot, proved: a tour through a place that is nowhere, which joins start and end."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, Dict, List, NamedTuple, Optional, Tuple

import numpy as np

from mtrp_allocators.references.cuts import cut_off_sets
from mtrp_allocators.references.programme import Programme, Row

if TYPE_CHECKING:
    from numpy.typing import NDArray

__all__ = ["PathOptimum", "shortest_path"]


class PathOptimum(NamedTuple):
    """The order of the shortest path, and how many sets had to be cut off."""

    order: Tuple[int, ...]
    cuts: int


def shortest_path(
    starts: NDArray[np.float64], between: NDArray[np.float64], time_limit: Optional[float] = None
) -> PathOptimum:
    """Find the shortest path from a start through all targets, wherever it ends.

    The symmetric travelling salesman problem on start, targets and a dummy place next to the start, from which every
    way costs nothing:

        minimise    sum d_e x_e
        subject to  sum of the edges at each place = 2,  x_(dummy, start) = 1
                    sum of the edges that leave S >= 2        for each set S of places

    Args:
        starts: from the start to the targets, shape (targets,) [m].
        between: from target to target, symmetric, shape (targets, targets) [m].
        time_limit: for each programme that is solved [s]; None for none.

    Raises:
        UnsolvedError: a programme was not solved within its limit.
    """
    targets = len(starts)
    if targets < 2:
        return PathOptimum(tuple(range(targets)), 0)
    # Places: the targets, the start, the dummy.
    places = targets + 2
    costs = np.zeros((places, places))
    costs[:targets, :targets] = between
    costs[targets, :targets] = costs[:targets, targets] = starts
    edges = _Edges(places)
    programme = Programme(costs[edges.one, edges.other])
    for place in range(places):
        programme.add(Row(edges.at(place), 2.0, 2.0))
    programme.add(Row(edges.joining(targets, targets + 1), 1.0, 1.0))
    values = programme.solve_with_cuts(edges.missing, time_limit)
    return PathOptimum(edges.path(values), programme.cuts)


class _Edges:
    """Numbers the edges between places."""

    def __init__(self, places: int) -> None:
        self._places = places
        self.one, self.other = np.triu_indices(places, 1)

    def at(self, place: int) -> NDArray[np.intp]:
        """List the edges at a place."""
        return np.flatnonzero((self.one == place) | (self.other == place))

    def joining(self, one: int, other: int) -> NDArray[np.intp]:
        """Find the edge between two places, the smaller one first."""
        return np.flatnonzero((self.one == one) & (self.other == other))

    def missing(self, values: NDArray[np.float64]) -> List[Row]:
        """Find sets of places that a solution does not join with the others by two edges."""
        capacity = np.zeros((self._places, self._places))
        capacity[self.one, self.other] = capacity[self.other, self.one] = values
        # From the dummy, the last place, to all others.
        rows = []
        for cut in cut_off_sets(capacity[:-1, :-1], capacity[-1, :-1], 2.0):
            inside = np.zeros(self._places, dtype=bool)
            inside[cut] = True
            rows.append(Row(np.flatnonzero(inside[self.one] != inside[self.other]), 2.0, math.inf))
        return rows

    def path(self, values: NDArray[np.float64]) -> Tuple[int, ...]:
        """Follow the edges of a whole solution from the start."""
        joined: Dict[int, List[int]] = {place: [] for place in range(self._places)}
        for edge in np.flatnonzero(values > 0.5).tolist():
            one, other = int(self.one[edge]), int(self.other[edge])
            joined[one].append(other)
            joined[other].append(one)
        start, dummy = self._places - 2, self._places - 1
        order: List[int] = []
        before, here = dummy, start
        while True:
            here, before = next(place for place in joined[here] if place != before), here
            if here == dummy:
                return tuple(order)
            order.append(here)
