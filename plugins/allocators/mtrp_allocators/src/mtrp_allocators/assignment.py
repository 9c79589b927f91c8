"""Allocation round by round: as many targets as there are robots are assigned at a time, or all of them by nearness."""

from __future__ import annotations

from typing import List

import numpy as np

from mtrp_allocators.routes import Distances, Routes
from rqt_mrta_py.hooks import MissingDependencyError

__all__ = ["assign_in_rounds", "assign_to_nearest"]


def assign_in_rounds(ways: Distances) -> Routes:
    """Assign robots to targets at the least total distance, move there, and assign anew (iterated Hungarian method).

    The rectangular assignment of H. W. Kuhn (1955), as SciPy solves it, of every robot to one of the targets that are
    left, or of every target to one of the robots.

    Args:
        ways: between all places.

    Raises:
        MissingDependencyError: SciPy is not installed.
    """
    try:
        from scipy.optimize import linear_sum_assignment
    except ImportError as error:
        raise MissingDependencyError("iterated assignment: SciPy is not installed; install scipy") from error
    robots, targets = ways.starts.shape
    routes: List[List[int]] = [[] for _ in range(robots)]
    left = np.arange(targets if robots else 0)
    here = np.array(ways.starts)
    while left.size:
        rows, columns = linear_sum_assignment(here[:, left])
        for robot, target in zip(rows.tolist(), left[columns].tolist()):
            routes[robot].append(target)
            here[robot] = ways.between[target]
        left = np.delete(left, columns)
    return tuple(map(tuple, routes))


def assign_to_nearest(ways: Distances) -> Routes:
    """Give each target to the robot that starts nearest to it, all auctions at a time; visit the nearest one next.

    Of equal distances the smaller index wins, of robots and of targets.

    Args:
        ways: between all places.
    """
    robots, _ = ways.starts.shape
    owner = ways.starts.argmin(axis=0) if robots else np.zeros(0, dtype=np.intp)
    routes: List[List[int]] = []
    for robot in range(robots):
        left = np.flatnonzero(owner == robot)
        here, route = ways.starts[robot], []
        while left.size:
            place = int(here[left].argmin())
            route.append(int(left[place]))
            here, left = ways.between[left[place]], np.delete(left, place)
        routes.append(route)
    return tuple(map(tuple, routes))
