"""The event-driven mission of many robots and targets, compiled where numba is installed, else in NumPy."""

from __future__ import annotations

from typing import List, Optional

import numpy as np

from mrta_demir_cf.planning.arrays import Floats, checked_points
from mrta_demir_cf.planning.compiled import has_compiler
from mrta_demir_cf.planning.costs import CostFunction, FarthestAddition, eyh_cost
from mrta_demir_cf.planning.mission import Mission
from mrta_demir_cf.planning.missions import commit_until_arrival
from mrta_demir_cf.planning.pruning import PrunedSelection
from mrta_demir_cf.planning.target_grid import grid_of

__all__ = ["event_driven"]


def event_driven(robots: Floats, targets: Floats, cost: CostFunction, *, compiled: Optional[bool] = None) -> Mission:
    """Decide what ``missions.commit_until_arrival`` decides by the same cost function: the same mission, sooner.

    Memory is O(M + N). The first compiled mission of a process takes some seconds more, for compilation.

    Args:
        robots: (M, 2) start places [m].
        targets: (N, 2) [m].
        cost: Eq. 2 or 3 are compiled; others are not.
        compiled: whether to compile; as can be if None.

    Returns:
        The mission.

    Raises:
        ValueError: a shape is wrong, a coordinate is not finite, there is no robot for the targets; or compilation is
            asked for and not possible.
    """
    robots = checked_points("robots", robots)
    targets = checked_points("targets", targets)
    alpha = cost.alpha if isinstance(cost, FarthestAddition) else 1.0 if cost is eyh_cost else None
    possible = alpha is not None and has_compiler()
    if compiled and not possible:
        raise ValueError("compiled: is True; it needs numba (extra compiled) and costs by EYH or UEM")
    if alpha is None or not (possible if compiled is None else compiled) or not len(targets) or not len(robots):
        return commit_until_arrival(robots, targets, PrunedSelection(targets, cost))
    from mrta_demir_cf.planning.kernels.arrivals import run_arrivals

    visitors, visited, lengths, arrivals, decisions = run_arrivals(robots, targets, grid_of(targets), alpha)
    routes: List[List[int]] = [[] for _ in robots]
    for robot, target in zip(visitors.tolist(), visited.tolist()):
        routes[robot].append(target)
    return Mission(tuple(map(tuple, routes)), tuple(lengths.tolist()), float(np.max(arrivals)), decisions)
