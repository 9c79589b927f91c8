"""Which target a robot would visit next: FormRoughSchedule, Algorithm 1 of Sariel, Erdogan and Balch (2007)."""

from __future__ import annotations

from typing import Callable, NamedTuple, Optional

import numpy as np

from mrta_demir_cf.planning.arrays import Floats, Indices, Mask, checked_distances, checked_points, squared_distances
from mrta_demir_cf.planning.costs import CostFunction
from mrta_demir_cf.planning.rough_schedule import rough_schedule

__all__ = ["Rule", "Selection", "select", "selects_by"]


class Selection(NamedTuple):
    """What a robot makes of what is open.

    Attributes:
        schedule: T_R, indices of targets, rising.
        costs: of the targets of the schedule, (k,); infinite for those out of reach.
        chosen: t_S, the index of the cheapest target; None if there is none in reach.
        cost: its cost; infinite if there is none.
    """

    schedule: Indices
    costs: Floats
    chosen: Optional[int]
    cost: float


Rule = Callable[[int, Floats, Floats, Mask], Selection]
"""How a robot selects: from its row, (M, 2) robots [m], (N, 2) targets [m] and the (N,) mask of open targets."""


def select(
    robot: int,
    robots: Floats,
    targets: Floats,
    open: Mask,
    cost: CostFunction,
    *,
    distances: Optional[Floats] = None,
) -> Selection:
    """Form the rough schedule and take its cheapest target; of equal costs that with the smallest index (Algorithm 1).

    Differs from the paper: the printed loop takes the cost of each target as it puts it into the schedule; here the
    schedule is formed first, since Eq. 3 needs all of it.

    Args:
        robot: j, a row of ``robots``.
        robots: (M, 2) [m], frame map, in the order of ids; of those that are believed to take part.
        targets: (N, 2) [m], frame map.
        open: (N,), which targets are T_U.
        cost: Eq. 2 or 3, or another.
        distances: of this robot to all targets by its own map, (N,) [m]; infinite where it finds no way. Euclidean
            if None. Eq. 1 takes Euclidean distances in any case. Targets out of reach stay in the schedule, since they
            are nobody else's, but are not chosen and take no part in the farthest pair.

    Returns:
        The schedule and the choice.

    Raises:
        ValueError: a shape is wrong, a coordinate is not finite, a distance or a cost is NaN, there is no such robot.
    """
    robots = checked_points("robots", robots)
    targets = checked_points("targets", targets)
    schedule = rough_schedule(robot, robots, targets, open)
    places = targets[schedule]
    if distances is None:
        own = np.sqrt(squared_distances(robots[robot], places))
    else:
        own = checked_distances("distances", distances, len(targets))[schedule]
    reachable = np.isfinite(own)
    costs = np.full(len(schedule), np.inf)
    costs[reachable] = cost(own[reachable], places[reachable])
    if np.isnan(costs).any():
        target = int(schedule[np.isnan(costs)][0])
        raise ValueError(f"cost: gives NaN for target {target} and robot {robot}; costs must be numbers")
    if not np.isfinite(costs).any():
        return Selection(schedule, costs, None, float("inf"))
    best = int(costs.argmin())
    return Selection(schedule, costs, int(schedule[best]), float(costs[best]))


def selects_by(cost: CostFunction) -> Rule:
    """Make the rule that selects by a cost function and Euclidean distances; see ``select``."""

    def rule(robot: int, robots: Floats, targets: Floats, open: Mask) -> Selection:
        return select(robot, robots, targets, open, cost)

    return rule
