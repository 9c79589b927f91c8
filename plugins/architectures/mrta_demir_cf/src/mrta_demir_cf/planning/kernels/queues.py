"""Robots that wait at one place from the beginning: only the first of them can own a target, the others stay hidden.

A robot behind another is as far from everything and comes later, so that it neither gets a target nor keeps any from a
third one. Those who leave a depot one by one would be looked at again and again.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from mrta_demir_cf.planning.arrays import Floats, Indices, Mask
from mrta_demir_cf.planning.compiled import inner_kernel

__all__ = ["Queues", "queues_of", "step_forward"]


class Queues(NamedTuple):
    """Who stands behind whom.

    Attributes:
        followers: the next robot at the same place, (M,); -1 if there is none, or since it has come forward.
        hidden: who stands behind another that has not left yet, (M,).
        moved: whether this has changed since robots were sorted into cells, (1,).
    """

    followers: Indices
    hidden: Mask
    moved: Mask


def queues_of(robots: Floats) -> Queues:
    """Let robots that start at one place queue by their index, (M, 2) [m]."""
    order = np.lexsort((robots[:, 1], robots[:, 0]))
    together = (robots[order[1:]] == robots[order[:-1]]).all(axis=1)
    followers, hidden = np.full(len(robots), -1, dtype=np.intp), np.zeros(len(robots), dtype=np.bool_)
    followers[order[:-1][together]] = order[1:][together]
    hidden[order[1:][together]] = True
    return Queues(followers, hidden, np.ones(1, dtype=np.bool_))


@inner_kernel
def step_forward(queues: Queues, robot: int) -> None:
    """Let the robot behind one that leaves be seen."""
    follower = queues.followers[robot]
    if follower >= 0:
        queues.followers[robot] = -1
        queues.hidden[follower] = False
        queues.moved[0] = True
