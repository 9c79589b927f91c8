"""The loop over arrivals of ``missions.commit_until_arrival``, decision by decision the same."""

from __future__ import annotations

from typing import Tuple

import numpy as np

from mrta_demir_cf.planning.arrays import Floats, Indices
from mrta_demir_cf.planning.compiled import kernel
from mrta_demir_cf.planning.kernels.cells import decide
from mrta_demir_cf.planning.missions import retry_gap
from mrta_demir_cf.planning.target_grid import TargetGrid

__all__ = ["run_arrivals"]

_retry_gap = kernel(retry_gap)


@kernel
def run_arrivals(
    robots: Floats, targets: Floats, grid: TargetGrid, alpha: float
) -> Tuple[Indices, Indices, Floats, Floats, int]:
    """Decide a whole mission.

    Args:
        robots: (M, 2) start places [m], at least one.
        targets: (N, 2) [m], at least one.
        grid: of the targets.
        alpha: of Eq. 3; 1 for Eq. 2.

    Returns:
        Robots and targets of all commitments, in order, both (N,); lengths of paths (M,) [m]; last arrivals (M,) [s];
        the number of decisions.
    """
    team = len(robots)
    starts, goals, places = robots.copy(), robots.copy(), robots.copy()
    departures, arrivals, lengths = np.zeros(team), np.zeros(team), np.zeros(team)
    moving = np.zeros(team, dtype=np.bool_)
    asked = np.ones(team, dtype=np.bool_)
    unclaimed = np.ones(len(targets), dtype=np.bool_)
    visitors = np.empty(len(targets), dtype=np.intp)
    visited = np.empty(len(targets), dtype=np.intp)
    claimed, decisions, since_retry, now = 0, 0, 0, 0.0
    while claimed < len(targets):
        arrived = -1
        under_way = 0
        for robot in range(team):
            if moving[robot]:
                under_way += 1
                if arrived < 0 or arrivals[robot] < arrivals[arrived]:
                    arrived = robot
        retry = arrived < 0
        if arrived >= 0:
            now = arrivals[arrived]
            starts[arrived] = goals[arrived]
            departures[arrived] = now
            moving[arrived] = False
            since_retry += 1
            if since_retry > _retry_gap(under_way - 1, team):
                since_retry = 0
                retry = True
        for robot in range(team):
            asked[robot] = retry and not moving[robot]
            span = arrivals[robot] - departures[robot]
            share = (now - departures[robot]) / span if span > 0.0 else 1.0
            for axis in range(2):
                places[robot, axis] = starts[robot, axis] + (goals[robot, axis] - starts[robot, axis]) * share
        if arrived >= 0:
            asked[arrived] = False
        for turn in range(-1, team):
            robot = arrived if turn < 0 else turn
            if robot < 0 or (turn >= 0 and not asked[robot]):
                continue
            decisions += 1
            target = decide(robot, places, targets, unclaimed, grid, alpha)
            if target < 0:
                continue
            along_x = targets[target, 0] - starts[robot, 0]
            along_y = targets[target, 1] - starts[robot, 1]
            length = np.sqrt(along_x * along_x + along_y * along_y)
            goals[robot] = targets[target]
            departures[robot], arrivals[robot] = now, now + length
            lengths[robot] += length
            moving[robot] = True
            unclaimed[target] = False
            visitors[claimed], visited[claimed] = robot, target
            claimed += 1
    return visitors, visited, lengths, arrivals, decisions
