"""The optimum of several robots on open paths, proved: an integer programme whose cuts are found as they are needed."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, Dict, List, NamedTuple, Optional, Sequence, Tuple

import numpy as np

from mtrp_allocators.references.cuts import cut_off_sets
from mtrp_allocators.references.path_optimum import shortest_path
from mtrp_allocators.references.programme import Programme, Row
from mtrp_allocators.routes import Distances, Routes, total_length

if TYPE_CHECKING:
    from numpy.typing import NDArray

__all__ = ["Optimum", "least_total_length"]


class Optimum(NamedTuple):
    """Routes of the least total length.

    Attributes:
        routes: one optimal solution.
        length: of them together [m].
        cuts: how many sets had to be cut off.
    """

    routes: Routes
    length: float
    cuts: int


def least_total_length(ways: Distances, time_limit: Optional[float] = None) -> Optimum:
    """Find routes of the least total length, and prove that there are no shorter ones.

    With x_st = 1 where t is visited right after s, and y_rt = 1 where robot r begins with t:

        minimise    sum c_rt y_rt + sum d_st x_st
        subject to  sum_r y_rt + sum_s x_st = 1               for each target t
                    sum_t y_rt <= 1,  sum_t x_st <= 1         for each robot r and target s
                    sum of all that enters S >= 1             for each set S of targets

    A path ends where nothing leaves a target. Sets that the solution found so far does not enter are cut off, first
    of the relaxation, then of whole solutions.

    Args:
        ways: between all places; at least one robot.
        time_limit: for each programme that is solved [s]; None for none.

    Raises:
        ValueError: there is no robot.
        UnsolvedError: a programme was not solved within its limit.
    """
    robots, targets = ways.starts.shape
    if not robots:
        raise ValueError("without robots nothing can be visited")
    if not targets:
        return Optimum(((),) * robots, 0.0, 0)
    if robots == 1:
        found = shortest_path(ways.starts[0], ways.between, time_limit)
        return Optimum((found.order,), total_length(ways, [found.order]), found.cuts)
    return _several(ways, time_limit)


def _several(ways: Distances, time_limit: Optional[float]) -> Optimum:
    robots, targets = ways.starts.shape
    arcs = _Arcs(robots, targets)
    programme = Programme(np.concatenate((ways.starts.ravel(), ways.between[arcs.before, arcs.after])))
    for target in range(targets):
        programme.add(Row(arcs.entering([target]), 1.0, 1.0))
        programme.add(Row(arcs.leaving(target), -math.inf, 1.0))
    for robot in range(robots):
        programme.add(Row(arcs.beginning(robot), -math.inf, 1.0))
    solution = programme.solve_with_cuts(arcs.missing, time_limit)
    routes = arcs.routes(solution)
    return Optimum(routes, total_length(ways, routes), programme.cuts)


class _Arcs:
    """Numbers the variables: first the arcs from robots to targets, row by row, then those between targets."""

    def __init__(self, robots: int, targets: int) -> None:
        self._robots, self._targets = robots, targets
        self.before, self.after = np.nonzero(~np.eye(targets, dtype=bool))
        self._first = robots * targets

    def beginning(self, robot: int) -> NDArray[np.intp]:
        """List the arcs by which a robot begins."""
        return np.arange(robot * self._targets, (robot + 1) * self._targets)

    def leaving(self, target: int) -> NDArray[np.intp]:
        """List the arcs that leave a target."""
        return self._first + np.flatnonzero(self.before == target)

    def entering(self, targets: Sequence[int]) -> NDArray[np.intp]:
        """List the arcs that enter a set of targets."""
        inside = np.zeros(self._targets, dtype=bool)
        inside[list(targets)] = True
        starts = (np.arange(self._robots)[:, None] * self._targets + np.flatnonzero(inside)).ravel()
        return np.concatenate((starts, self._first + np.flatnonzero(inside[self.after] & ~inside[self.before])))

    def missing(self, values: NDArray[np.float64]) -> List[Row]:
        """Find sets of targets that a solution does not enter."""
        capacity = np.zeros((self._targets, self._targets))
        capacity[self.before, self.after] = values[self._first :]
        sources = values[: self._first].reshape(self._robots, self._targets).sum(axis=0)
        return [Row(self.entering(cut.tolist()), 1.0, math.inf) for cut in cut_off_sets(capacity, sources, 1.0)]

    def routes(self, values: NDArray[np.float64]) -> Routes:
        """Follow the arcs of a whole solution."""
        used = values[self._first :] > 0.5
        follower: Dict[int, int] = dict(zip(self.before[used].tolist(), self.after[used].tolist()))
        routes: List[Tuple[int, ...]] = []
        for starts in values[: self._first].reshape(self._robots, self._targets) > 0.5:
            route = np.flatnonzero(starts).tolist()
            while route and route[-1] in follower:
                route.append(follower[route[-1]])
            routes.append(tuple(route))
        return tuple(routes)
