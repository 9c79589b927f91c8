"""An improvement of the rough schedule: each robot imagines how it and its neighbours would share their targets.

Where Eq. 1 cuts the targets up by the distance to robots, and Eq. 2 and 3 look one target ahead, here a robot plans to
the end for a few: it takes itself, its nearest neighbours and the targets in the cells of them all (Eq. 1), lets them
bid for every target one after another by cheapest insertion, improves the routes that come of it, and goes for the
first target of its own route. The rest is thought of anew at every decision: it commits to one target at a time, as
DEMiR-CF demands, and needs what it knows anyway: poses of others and open targets, nothing from a centre.

Differs from the paper: T_R is what the imagined auction leaves to the robot, so borders between cells give way where a
neighbour passes by in any case; c_ji is the way along the robot's own route until t_i.

What it costs: with g robots and k targets imagined, k rounds of g k bids and some sweeps over (g + k) k places; both
numbers are bounded (``neighbours``, ``horizon``), however large the team and the mission are. Robots with other
beliefs, or other neighbours, imagine other plans and may want the same target; that is what auctions are for.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import List, Optional

import numpy as np

from mrta_demir_cf.planning.arrays import (
    Floats,
    Indices,
    Mask,
    checked_distances,
    checked_situation,
    squared_distances,
)
from mrta_demir_cf.planning.rough_schedule import owners
from mrta_demir_cf.planning.selection import Selection

__all__ = ["Rollout"]


@dataclass(frozen=True)
class Rollout:
    """The rule of selection described above; see the module.

    Attributes:
        neighbours: how many other robots a robot imagines, its nearest ones.
        horizon: how many targets it imagines at most, its nearest ones.
        balance: whether the longest route counts (time objective) and not the length of all (path objective).
    """

    neighbours: int = 4
    horizon: int = 50
    balance: bool = False

    def __post_init__(self) -> None:
        if self.neighbours < 0:
            raise ValueError(f"neighbours: is {self.neighbours}; give at least 0")
        if self.horizon < 1:
            raise ValueError(f"horizon: is {self.horizon}; give at least 1")

    def __call__(
        self, robot: int, robots: Floats, targets: Floats, open: Mask, *, distances: Optional[Floats] = None
    ) -> Selection:
        """Imagine, and take the first target of the own route.

        Args:
            robot: j, a row of ``robots``.
            robots: (M, 2) [m], frame map, in the order of ids; of those that are believed to take part.
            targets: (N, 2) [m], frame map.
            open: (N,), which targets are open.
            distances: of this robot to all targets by its own map, (N,) [m]; infinite where it finds no way. Euclidean
                if None. Ways of others and between targets are Euclidean in any case.

        Returns:
            The targets of the robot's route, each with the way until it. A robot to which the imagined auction leaves
            nothing names what is in its cell, at a cost beyond that of the whole plan, lest robots that imagine
            different plans leave a target to one another for ever.

        Raises:
            ValueError: as ``select``.
        """
        robots, targets, candidates = checked_situation(robot, robots, targets, open)
        if distances is not None:
            distances = checked_distances("distances", distances, len(targets))
            candidates = candidates[np.isfinite(distances[candidates])]
        holders = owners(robots, targets[candidates])
        group = self._group(robots, robot)
        is_imagined = np.zeros(len(robots), dtype=np.bool_)
        is_imagined[group] = True
        imagined = is_imagined[holders]
        candidates, holders = candidates[imagined], holders[imagined]
        own = squared_distances(robots[robot], targets[candidates])
        if len(candidates) > self.horizon:
            kept = np.sort(own.argsort(kind="stable")[: self.horizon])
            candidates, holders, own = candidates[kept], holders[kept], own[kept]
        own = np.sqrt(own) if distances is None else distances[candidates]
        return self._imagine(robots[group], targets[candidates], own, candidates, holders == robot)

    def _group(self, robots: Floats, robot: int) -> Indices:
        """Give the robot and its nearest neighbours, the nearest first."""
        squares = squared_distances(robots[robot], robots)
        squares[robot] = -1.0
        if len(robots) > 4 * (self.neighbours + 1):
            # The place of the last that counts, and all that are as near: sorting those is enough.
            last = np.partition(squares, self.neighbours)[self.neighbours]
            near = np.flatnonzero(squares <= last)
            return near[squares[near].argsort(kind="stable")[: self.neighbours + 1]]
        return squares.argsort(kind="stable")[: self.neighbours + 1]

    def _imagine(self, group: Floats, places: Floats, own: Floats, candidates: Indices, held: Mask) -> Selection:
        from mrta_demir_cf.planning.kernels.routes import improve, insert_all, route_lengths, ways_between

        team = len(group)
        ways = ways_between(group, places)
        ways[0, team:-1] = own
        plan = insert_all(ways, team, self.balance)
        improve(plan, ways, team, self.balance)
        route: List[int] = []
        for node in plan[1:].tolist():
            if node < team:
                break
            route.append(node)
        if route:
            steps = ways[[0, *route[:-1]], route]
            order = np.argsort(route)
            nodes = np.array(route, dtype=np.intp)[order]
            costs = np.cumsum(steps)[order]
            return Selection(candidates[nodes - team], costs, int(candidates[route[0] - team]), float(steps[0]))
        costs = own[held] + route_lengths(plan, ways, team).sum()
        if not len(costs):
            return Selection(candidates[held], costs, None, float("inf"))
        best = int(costs.argmin())
        return Selection(candidates[held], costs, int(candidates[held][best]), float(costs[best]))
