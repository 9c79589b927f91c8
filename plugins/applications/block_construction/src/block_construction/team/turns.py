"""Whose turn it is where there are more robots than tasks."""

from __future__ import annotations

import math
from typing import Dict, Mapping, Tuple

__all__ = ["nearest_pairs"]


def nearest_pairs(
    robots: Mapping[str, Tuple[float, float]], tasks: Mapping[int, Tuple[float, float]]
) -> Dict[str, int]:
    """Pair robots with tasks, always the nearest of those left; of pairs as near, the first by names.

    All robots know where all stand, and so come to the same.

    Args:
        robots: where each is that has nothing to do, by id [m].
        tasks: where each begins that nobody carries out, by number [m].

    Returns:
        Number of the task by id of the robot.
    """
    pairs = sorted(
        (round(math.dist(here, there), 6), robot, task)
        for robot, here in robots.items()
        for task, there in tasks.items()
    )
    chosen: Dict[str, int] = {}
    taken = set()
    for _, robot, task in pairs:
        if robot not in chosen and task not in taken:
            chosen[robot] = task
            taken.add(task)
    return chosen
