"""Selection among many robots and targets by looking at few of them: the choices are those of ``select``.

A robot's Voronoi cell ends before the nearest robot of each sector (``sectors``), so it is enough to compare
the targets within those bounds with the robots within twice the largest. One decision takes O(M + k) steps for k
targets looked at, instead of O(M N), and no more memory than robots and targets themselves.
"""

from __future__ import annotations

from typing import List, Optional

import numpy as np

from mrta_demir_cf.planning.arrays import Floats, Indices, Mask, squared_distances
from mrta_demir_cf.planning.costs import CostFunction
from mrta_demir_cf.planning.point_grid import PointGrid, grid_of
from mrta_demir_cf.planning.rough_schedule import owners
from mrta_demir_cf.planning.sectors import SECTORS, WIDER, reach_in_sector
from mrta_demir_cf.planning.selection import Selection, select

__all__ = ["PrunedSelection"]

_SLACK = 1e-9

_PAIRS = 50_000
"""So many robots and targets are compared in the time that one robot needs for its decision."""


class PrunedSelection:
    """The rule that selects by a cost function, for many robots and targets that stay where they are."""

    def __init__(self, targets: Floats, cost: CostFunction) -> None:
        """Sort the targets.

        Args:
            targets: (N, 2) [m], the same that the rule is called with.
            cost: Eq. 2 or 3, or another.
        """
        self._targets = targets
        self._cost = cost
        self._grid: Optional[PointGrid] = (
            grid_of(targets, targets.min(axis=0), targets.max(axis=0), crowd=2.0) if len(targets) else None
        )

    def __call__(self, robot: int, robots: Floats, targets: Floats, open: Mask) -> Selection:
        """Select as ``select`` does, see there; coordinates are not checked again."""
        nothing = Selection(np.zeros(0, dtype=np.intp), np.zeros(0), None, float("inf"))
        squares = squared_distances(robots[robot], robots)
        if self._grid is None or (squares[:robot] == 0.0).any():
            return nothing
        corners = np.array([self._grid.low, self._grid.high])
        # Robots all but in one place would bound sectors by what is mostly rounding.
        others = np.flatnonzero(squares > 1e-12 * np.abs(corners - robots[robot]).max() ** 2)
        sectors = _sectors(robots[others] - robots[robot])
        bounds = np.full(SECTORS, np.inf)
        np.minimum.at(bounds, sectors, squares[others])
        bounds = np.sqrt(bounds) * WIDER
        for sector in np.flatnonzero(np.isinf(bounds)).tolist():
            bounds[sector] = reach_in_sector(sector, robots[robot], self._grid.low, self._grid.high)
        reach = float(bounds.max())
        near = self._targets_within(robots[robot], reach)
        near = near[open[near]]
        offsets = targets[near] - robots[robot]
        limits = bounds[_sectors(offsets)] + _SLACK * reach
        near = np.sort(near[squared_distances(np.zeros(2), offsets) <= limits * limits])
        if not len(near):
            return nothing
        rivals = np.flatnonzero(squares <= (2.0 * reach * WIDER) ** 2)
        me = int(np.searchsorted(rivals, robot))
        choice = select(me, robots[rivals], targets[near], np.ones(len(near), dtype=np.bool_), self._cost)
        chosen = None if choice.chosen is None else int(near[choice.chosen])
        return Selection(near[choice.schedule], choice.costs, chosen, choice.cost)

    def who_may_own(self, asked: List[int], robots: Floats, open: Mask) -> List[int]:
        """Leave out robots that own nothing, where it costs less to find all owners than to ask them one by one.

        Args:
            asked: rows of robots.
            robots: (M, 2) [m], in the order of ids.
            open: (N,), which targets are open.

        Returns:
            Those of ``asked`` that own an open target, or all.
        """
        candidates = np.flatnonzero(open)
        if len(asked) * _PAIRS < len(candidates) * len(robots):
            return asked
        order = np.lexsort((robots[:, 1], robots[:, 0]))
        alone = np.concatenate([[True], (robots[order[1:]] != robots[order[:-1]]).any(axis=1)])
        first = np.sort(order[alone])
        owning = np.zeros(len(robots), dtype=np.bool_)
        owning[first[owners(robots[first], self._targets[candidates])]] = True
        return [robot for robot in asked if owning[robot]]

    def _targets_within(self, place: Floats, reach: float) -> Indices:
        """Give the targets of all cells that a square of twice ``reach`` around a place touches."""
        grid = self._grid
        if grid is None:
            return np.zeros(0, dtype=np.intp)
        low = np.clip((place - reach - grid.low) // grid.width, 0, grid.side - 1).astype(np.intp)
        high = np.clip((place + reach - grid.low) // grid.width, 0, grid.side - 1).astype(np.intp)
        rows: List[Indices] = []
        for row in range(int(low[1]), int(high[1]) + 1):
            start, end = grid.first[row * grid.side + low[0]], grid.first[row * grid.side + high[0] + 1]
            rows.append(grid.members[start:end])
        return np.concatenate(rows)


def _sectors(directions: Floats) -> Indices:
    """Tell in which sector directions lie, (n, 2) to (n,); the same for those on an edge as rounding has it."""
    turns = np.arctan2(directions[:, 1], directions[:, 0]) / (np.pi / 3.0)
    sectors: Indices = np.floor(turns).astype(np.intp) % 6
    return sectors
