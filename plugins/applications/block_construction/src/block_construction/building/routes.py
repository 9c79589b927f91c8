"""How far a builder has to go."""

from __future__ import annotations

import math
from typing import FrozenSet, Optional, Sequence

from block_construction.building.gripping import CENTRED, stand_before
from block_construction.building.procedures import STAND_OFF
from block_construction.building.seams import Traffic
from block_construction.building.slot import BlockTask, Cell, Fetch
from rqt_mrta_py.model import Pose

__all__ = ["nearest", "stand_off", "way_length"]


def stand_off(block: Pose) -> Pose:
    """Give where a robot stands before it lowers its arm to a block [m, rad]."""
    return stand_before(block, STAND_OFF - CENTRED.ahead, CENTRED)


def way_length(
    traffic: Traffic, pose: Pose, slot: BlockTask, covered: FrozenSet[Cell], fetch: Optional[Fetch]
) -> Optional[float]:
    """Give the ways from somewhere over a supply place to a slot [m].

    Args:
        traffic: knows ways.
        pose: of the robot.
        slot: where to.
        covered: what blocks lie on.
        fetch: the supply place; None: the robot has its block already.

    Returns:
        Both together; None if there is none.
    """
    goal = stand_off(slot.facing)
    if fetch is None:
        return traffic.length((pose.x, pose.y), (goal.x, goal.y), covered)
    stand = stand_off(fetch.facing)
    fetching = traffic.length((pose.x, pose.y), (stand.x, stand.y), covered)
    placing = traffic.length((stand.x, stand.y), (goal.x, goal.y), covered)
    return None if fetching is None or placing is None else fetching + placing


def nearest(traffic: Traffic, pose: Pose, slot: BlockTask, places: Sequence[Fetch], covered: FrozenSet[Cell]) -> Fetch:
    """Give the supply place with the shortest ways, of two alike the first.

    Args:
        traffic: knows ways.
        pose: of the robot.
        slot: where the block is to be placed.
        places: to choose from, at least one.
        covered: what blocks lie on.
    """

    def length(fetch: Fetch) -> float:
        found = way_length(traffic, pose, slot, covered, fetch)
        return math.inf if found is None else found

    return min(places, key=length)
