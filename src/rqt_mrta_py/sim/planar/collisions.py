"""Push-out: what overlaps comes apart, and nothing that moves ends inside what does not."""

from __future__ import annotations

from typing import List, Sequence, Set, Tuple

import numpy as np

from rqt_mrta_py.hooks import Contact
from rqt_mrta_py.model import Arena, Obstacle
from rqt_mrta_py.sim.planar.cells import Floats
from rqt_mrta_py.sim.planar.crowd import Crowd
from rqt_mrta_py.sim.planar.meetings import FixedMeetings, Meetings, MovingMeetings
from rqt_mrta_py.sim.world_checks import WALL

__all__ = ["Collisions"]

_ROUNDS = 8
_LEAST_DEPTH = 1e-6
"""What is less deep in something fixed is so by rounding [m]."""
_LEAST_DEPTH_AMONG = 1e-3
"""Moving things that overlap less are left as they are [m]."""
_MOST_DEPTH_IN_FIXED = 1e-4
"""What is deeper than this in a wall or an obstacle goes back to where it was [m]."""
_TOUCH = 1e-3
"""Things nearer than this are in contact [m]."""
_BACKED = 1e-3
"""How much of its mobility a thing keeps against what it stands with its back to."""
_OPPOSED = -0.3
"""Below this cosine two directions oppose each other."""


class Collisions:
    """Keeps a crowd's things apart from one another and out of walls and obstacles.

    In each of a few rounds, things that overlap part by their masses, and then whatever is in a wall or an obstacle is
    pushed out of the one that it is deepest in. What has a wall, an obstacle or a frozen robot at its back does not
    give way to what pushes it there, nor does the next in such a row. Pushes move things, they do not turn them.

    Things that are still in a wall or an obstacle after that, wedged in between several, go back to the pose that they
    had before the step. So whatever pushes, nothing that moves gets into a wall or an obstacle; what starts in some,
    which no checked scenario has, gets neither deeper into these nor into others, even if it must stay where it is.
    Things among themselves may overlap for some steps when many press together.
    """

    def __init__(self, crowd: Crowd, arena: Arena, obstacles: Sequence[Obstacle]) -> None:
        self._crowd = crowd
        self._moving = MovingMeetings(crowd)
        self.fixed = FixedMeetings(crowd, arena, obstacles)
        self._fixed_names: List[str] = [obstacle.id for obstacle in obstacles]
        self._fixed_names += [WALL] * (self.fixed.count - len(obstacles))

    def resolve(self, before: Floats) -> None:
        """Push things apart.

        Args:
            before: all poses before they last moved, shape (3, things).
        """
        crowd = self._crowd
        mobility = crowd.mobility()
        backs = np.zeros((2, mobility.size))
        for _ in range(_ROUNDS):
            among = self._moving.find(_LEAST_DEPTH_AMONG)
            if among.first.size:
                self._part(among, mobility, backs)
            inside = self.fixed.find(_LEAST_DEPTH)
            if inside.first.size:
                self._push_out(inside, mobility, backs)
            elif not among.first.size:
                return
        self._take_back(before)

    def contacts(self) -> Tuple[Contact, ...]:
        """List what touches what now: each pair once, sorted."""
        names = self._crowd.names
        among, fixed = self._moving.find(-_TOUCH), self.fixed.find(-_TOUCH)
        pairs: Set[Tuple[str, str]] = set()
        pairs.update((names[i], names[j]) for i, j in zip(among.first.tolist(), among.second.tolist()))
        pairs.update((names[i], self._fixed_names[j]) for i, j in zip(fixed.first.tolist(), fixed.second.tolist()))
        return tuple(sorted(Contact(min(pair), max(pair)) for pair in pairs))

    def _part(self, among: Meetings, mobility: Floats, backs: Floats) -> None:
        """Push pairs apart by their masses.

        Of n pushes a thing takes the sum over the root of n: the sum overshoots where they agree, and by their mean it
        would take many rounds to come out from between others.
        """
        crowd = self._crowd
        movers = np.stack((crowd.carrier[among.first], crowd.carrier[among.second]))
        away = np.stack((among.away, -among.away), axis=1)
        yielding = mobility[movers]
        is_backed = (away * backs[:, movers]).sum(axis=0) < _OPPOSED
        is_backed |= yielding == 0.0
        yielding = np.where(is_backed, _BACKED * yielding, yielding)
        both = yielding.sum(axis=0)
        share = yielding / np.where(both > 0.0, both, 1.0)
        # Whoever is pushed by something that does not give way does not give way either.
        stands_fast = is_backed[::-1] & ~is_backed
        backs[:, movers[stands_fast]] = away[:, stands_fast]
        pushes = np.bincount(movers.ravel(), minlength=mobility.size)
        way = away * (share * among.depth)
        for axis in (0, 1):
            total = np.bincount(movers.ravel(), weights=way[axis].ravel(), minlength=mobility.size)
            crowd.poses[axis] += total / np.sqrt(np.maximum(pushes, 1))
        crowd.carry()

    def _push_out(self, inside: Meetings, mobility: Floats, backs: Floats) -> None:
        """Push what moves out of the fixed thing that it is deepest in."""
        crowd = self._crowd
        movers = crowd.carrier[inside.first]
        order = np.lexsort((-inside.depth, movers))
        order = order[mobility[movers[order]] > 0.0]
        _, deepest = np.unique(movers[order], return_index=True)
        chosen = order[deepest]
        away = inside.away[:, chosen]
        crowd.poses[:2, movers[chosen]] += away * inside.depth[chosen]
        backs[:, movers[chosen]] = away
        crowd.carry()

    def _take_back(self, before: Floats) -> None:
        """Put back what is in something fixed, and deeper than it was in this same one before the step."""
        crowd = self._crowd
        now = self.fixed.find(_MOST_DEPTH_IN_FIXED)
        if not now.first.size:
            return
        after = crowd.poses.copy()
        crowd.poses[:] = before
        is_deeper = now.depth > self._depths_of(now, self.fixed.find(_MOST_DEPTH_IN_FIXED))
        goes_back = np.zeros(crowd.carrier.size, dtype=np.bool_)
        goes_back[crowd.carrier[now.first[is_deeper]]] = True
        crowd.poses[:] = np.where(goes_back[crowd.carrier], before, after)

    def _depths_of(self, pairs: Meetings, inside: Meetings) -> Floats:
        """Give how deep pairs are in each other among other meetings with what is fixed, 0 for those not there [m]."""
        wanted, found = (meetings.first * self.fixed.count + meetings.second for meetings in (pairs, inside))
        _, rows, there = np.intersect1d(wanted, found, assume_unique=True, return_indices=True)
        depths = np.zeros(wanted.size)
        depths[rows] = inside.depth[there]
        return depths
