"""A balanced plan: who visits what in which order so that the longest route is short, made once and then kept.

For the time objective one target ahead is not enough: who takes the nearest target now may be far from everything that
is left in the end. Here every robot plans for the whole team to the end, from what all believe anyway: where robots are
and which targets are open. The plan is deterministic, so robots that believe the same make the same plan, each for
itself, and nobody has to send one or to lead. Of its own route a robot takes the first target, and asks the others for
it like for any (REQUEST): it commits itself to one target at a time.

What makes it good is that it is kept. A plan made anew at every arrival is as short at each moment, but it changes its
mind: robots turn round on their ways. So it stands as long as what happens is what was planned (``Plan.stands``), and
is made anew, from then and there, if robots come or go, targets appear, or anybody does what was not planned.

Differs from the paper: T_R is the robot's route in the plan, c_ji the way along it until t_i; and T_R is not formed
anew whenever the robot knows anything new, only when the plan does not stand any more.

What it costs: with m robots and n targets, n rounds of m n bids, then sweeps of n (m + n) moves, at the start and after
each contingency; looking the plan up costs O(m + n). A robot must know of all robots and all targets: where each plans
for a few neighbours only, plans contradict one another at their borders, and much of what they gain is lost.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import AbstractSet, Generic, Hashable, Mapping, Optional, Tuple, TypeVar

import numpy as np

from mrta_demir_cf.planning.arrays import Floats, Mask, checked_points, checked_situation, squared_distances
from mrta_demir_cf.planning.selection import Selection

__all__ = ["KeptPlan", "Plan", "balanced_routes"]

_Robot = TypeVar("_Robot", bound=Hashable)
_Target = TypeVar("_Target", bound=Hashable)


def balanced_routes(robots: Floats, targets: Floats, begun: Optional[Floats] = None) -> Tuple[Tuple[int, ...], ...]:
    """Make routes whose longest is short: a sequential auction with bids of path lengths, improved move by move.

    Args:
        robots: (M, 2) [m], frame map: where the routes begin; at least one if there are targets.
        targets: (N, 2) [m], frame map.
        begun: (M,), how long the way is that each robot has to go before its route begins [m]; none if None.

    Returns:
        Of each robot the indices of its targets, in the order of visiting.

    Raises:
        ValueError: a shape is wrong, a coordinate is not finite, or there is no robot for the targets.
    """
    from mrta_demir_cf.planning.kernels.routes import improve, insert_all, ways_between

    robots = checked_points("robots", robots)
    targets = checked_points("targets", targets)
    team = len(robots)
    if len(targets) and not team:
        raise ValueError(f"robots: there is none for {len(targets)} target(s); give at least one")
    ways = ways_between(robots, targets)
    if begun is not None:
        ways[:team, team:-1] += np.asarray(begun, dtype=np.float64)[:, None]
    plan = insert_all(ways, team, True)
    improve(plan, ways, team, True)
    edges = [*np.flatnonzero(plan < team).tolist(), len(plan)]
    return tuple(tuple((plan[start + 1 : end] - team).tolist()) for start, end in zip(edges, edges[1:]))


@dataclass(frozen=True)
class Plan(Generic[_Robot, _Target]):
    """Who visits what in which order.

    Attributes:
        routes: of each robot that was counted upon.
    """

    routes: Mapping[_Robot, Tuple[_Target, ...]]

    def left(self, robot: _Robot, open: AbstractSet[_Target]) -> Tuple[_Target, ...]:
        """List what is left of a robot's route.

        Args:
            robot: of the plan.
            open: targets that have not been visited.
        """
        return tuple(target for target in self.routes[robot] if target in open)

    def stands(self, robots: AbstractSet[_Robot], open: AbstractSet[_Target], claims: Mapping[_Target, _Robot]) -> bool:
        """Tell whether all that happened since was planned.

        It was if the robots are the same, nothing is open that was not, each robot has visited targets from the front
        of its route only, and goes for the next, not for another's.

        Args:
            robots: that take part now.
            open: targets that have not been visited.
            claims: for which of them who goes, or has asked for them.
        """
        if robots != self.routes.keys() or not open <= {target for route in self.routes.values() for target in route}:
            return False
        if any(target in open and target not in self.routes.get(robot, ()) for target, robot in claims.items()):
            return False
        for robot, route in self.routes.items():
            left = self.left(robot, open)
            if left != route[len(route) - len(left) :]:
                return False
            claimed = [claims.get(target) == robot for target in left]
            if sorted(claimed, reverse=True) != claimed:
                return False
        return True


class KeptPlan:
    """The rule of selection described above, for missions decided offline; it keeps its plan from call to call.

    One of them may serve a whole team, since all robots would make the same plan, or one each robot.
    """

    def __init__(self) -> None:
        self._plan: Plan[int, int] = Plan({})
        self._targets: Floats = np.zeros((0, 2))
        self.plans = 0
        """How many have been made."""

    def __call__(self, robot: int, robots: Floats, targets: Floats, open: Mask) -> Selection:
        """Take the next target of the robot's route.

        Args:
            robot: j, a row of ``robots``.
            robots: (M, 2) [m], frame map, in the order of ids; of those that are believed to take part.
            targets: (N, 2) [m], frame map.
            open: (N,), which targets have not been visited.

        Returns:
            What is left of the robot's route, each target with the way until it; nothing where its route is at an end.

        Raises:
            ValueError: as ``select``.
        """
        robots, targets, candidates = checked_situation(robot, robots, targets, open)
        still_open = set(candidates.tolist())
        same = np.array_equal(targets, self._targets)
        if not (same and self._plan.stands(set(range(len(robots))), still_open, {})):
            routes = balanced_routes(robots, targets[candidates])
            self._plan = Plan({row: tuple(candidates[list(route)].tolist()) for row, route in enumerate(routes)})
            self._targets = targets
            self.plans += 1
        return _selection(robots[robot], targets, self._plan.left(robot, still_open))


def _selection(place: Floats, targets: Floats, route: Tuple[int, ...]) -> Selection:
    """Give a route as a schedule: in the order of indices, each target with the way until it."""
    if not route:
        return Selection(np.zeros(0, dtype=np.intp), np.zeros(0), None, float("inf"))
    stops = np.array(route, dtype=np.intp)
    places = np.vstack((place, targets[stops]))
    ways = np.sqrt(squared_distances(places[:-1], places[1:])).cumsum()
    order = stops.argsort()
    return Selection(stops[order], ways[order], route[0], float(ways[0]))
