"""The event-driven mission of many robots and targets, compiled where numba is installed, else in NumPy."""

from __future__ import annotations

from typing import TYPE_CHECKING, List, Optional

import numpy as np

from mrta_demir_cf.planning.arrays import Floats, checked_points
from mrta_demir_cf.planning.compiled import has_compiler
from mrta_demir_cf.planning.costs import CostFunction, FarthestAddition, eyh_cost
from mrta_demir_cf.planning.mission import Mission
from mrta_demir_cf.planning.missions import commit_until_arrival
from mrta_demir_cf.planning.point_grid import grid_of
from mrta_demir_cf.planning.pruning import PrunedSelection

if TYPE_CHECKING:
    from mrta_demir_cf.planning.kernels.decisions import Field

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
    if not len(targets) or not len(robots) or _too_far(robots, targets):
        possible = False
    if alpha is None or not possible or compiled is False:
        selection = PrunedSelection(targets, cost)
        return commit_until_arrival(robots, targets, selection, selection.who_may_own)
    return _compiled(robots, targets, alpha)


def _too_far(robots: Floats, targets: Floats) -> bool:
    """Tell whether squares of distances may be infinite, of which kernels know nothing."""
    return bool(max(np.abs(robots).max(), np.abs(targets).max()) > 1e150)


def _compiled(robots: Floats, targets: Floats, alpha: float) -> Mission:
    from mrta_demir_cf.planning.kernels.arrivals import progress_of, run_arrivals

    field, progress = _field(robots, targets), progress_of(len(robots), len(targets))
    decisions = run_arrivals(field, progress, alpha)
    routes: List[List[int]] = [[] for _ in robots]
    for robot, target in zip(progress.visitors.tolist(), progress.visited.tolist()):
        routes[robot].append(target)
    makespan = float(field.ways.arrivals.max())
    return Mission(tuple(map(tuple, routes)), tuple(progress.lengths.tolist()), makespan, decisions)


def _field(robots: Floats, targets: Floats) -> Field:
    """Sort robots and targets, and make room for decisions."""
    from mrta_demir_cf.planning.kernels.cells import outline_of
    from mrta_demir_cf.planning.kernels.decisions import Field
    from mrta_demir_cf.planning.kernels.queues import queues_of
    from mrta_demir_cf.planning.kernels.ways import Ways

    low, high = np.minimum(robots.min(axis=0), targets.min(axis=0)), np.maximum(robots.max(axis=0), targets.max(axis=0))
    return Field(
        Ways(robots.copy(order="C"), robots.copy(order="C"), np.zeros(len(robots)), np.zeros(len(robots))),
        queues_of(robots),
        grid_of(robots, low, high, crowd=1.0),
        grid_of(targets, targets.min(axis=0), targets.max(axis=0), crowd=2.0),
        np.ascontiguousarray(targets),
        outline_of(len(robots)),
        np.empty(len(targets), dtype=np.intp),
        np.empty(len(targets), dtype=np.intp),
        np.empty(len(targets)),
    )
