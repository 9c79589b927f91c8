"""Rough schedules: the targets that a robot counts upon visiting, without committing to any (Eq. 1).

S. Sariel, N. Erdogan, T. Balch, Incremental task selection and allocation for the real-world multiple travelling robot
problem, 2007. Letters of the paper: r_j robot, t_i target, T_U unvisited targets, T_Rj rough schedule of r_j.
"""

from __future__ import annotations

import numpy as np

from mrta_demir_cf.planning.arrays import Floats, Indices, Mask, checked_situation, squared_distances

__all__ = ["owners", "rough_schedule"]

_ROWS = 32
"""Robots whose distances to all targets are looked at together: bounds the memory by O(M + N)."""


def rough_schedule(robot: int, robots: Floats, targets: Floats, open: Mask) -> Indices:
    """List the open targets that no other robot is nearer to (Eq. 1).

        reldist(r_j, t_i) = dist(r_j, t_i) - min_{k != j} dist(r_k, t_i),   T_Rj = {t_i in T_U : reldist(r_j, t_i) < 0}

    T_Rj are the open targets in the Voronoi cell of r_j. A single robot has them all.

    Differs from the paper: of robots at the same distance the one with the smallest index owns the target. With "<"
    alone nobody would, and robots that share a depot would never start.

    Args:
        robot: j, a row of ``robots``.
        robots: (M, 2) [m], frame map, in the order of ids; of those that are believed to take part.
        targets: (N, 2) [m], frame map.
        open: (N,), which targets are T_U.

    Returns:
        Indices of targets, rising.

    Raises:
        ValueError: a shape is wrong, a coordinate is not finite, or there is no such robot.
    """
    robots, targets, candidates = checked_situation(robot, robots, targets, open)
    schedule: Indices = candidates[owners(robots, targets[candidates]) == robot]
    return schedule


def owners(robots: Floats, targets: Floats) -> Indices:
    """Tell for each target the row of its nearest robot, of equally near ones the first: whose Voronoi cell it is in.

    Args:
        robots: (M, 2) [m], at least one.
        targets: (N, 2) [m].
    """
    least = np.full(len(targets), np.inf)
    nearest = np.zeros(len(targets), dtype=np.intp)
    everywhere = np.arange(len(targets))
    for first in range(0, len(robots), _ROWS):
        squares = squared_distances(robots[first : first + _ROWS, None, :], targets)
        rows = squares.argmin(axis=0)
        nearer = squares[rows, everywhere] < least
        least[nearer] = squares[rows, everywhere][nearer]
        nearest[nearer] = rows[nearer] + first
    return nearest
