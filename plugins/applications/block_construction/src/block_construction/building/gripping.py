"""Where a block is at the magnet, and where the robot must stand so that block or magnet is somewhere."""

from __future__ import annotations

import math
from typing import NamedTuple

from block_construction.diagram.block_set import BODY_WIDTH
from rqt_mrta_py.model import Pose, wrap_angle

__all__ = ["CENTRED", "Grip", "grip_of", "stand_before", "touching"]


class Grip(NamedTuple):
    """How a magnet holds a block.

    Attributes:
        ahead: from the magnet's face to the block's middle, along the robot's heading [m].
        aside: of the block's middle from straight ahead, to the left [m].
        turn: of the block from lying square before the magnet, counter-clockwise [rad].
    """

    ahead: float
    aside: float
    turn: float


CENTRED = Grip(BODY_WIDTH / 2.0, 0.0, 0.0)
"""A block right at the magnet's face, held in its middle."""


def grip_of(robot: Pose, reach: float, block: Pose) -> Grip:
    """Tell how a block is held.

    Args:
        robot: where it is as it takes hold.
        reach: of its magnet's face, ahead of its middle [m].
        block: its middle; its yaw is the heading of a robot that it lies square before.
    """
    dx, dy = block.x - robot.x, block.y - robot.y
    cos, sin = math.cos(robot.yaw), math.sin(robot.yaw)
    return Grip(cos * dx + sin * dy - reach, cos * dy - sin * dx, wrap_angle(block.yaw - robot.yaw))


def stand_before(block: Pose, reach: float, grip: Grip) -> Pose:
    """Tell where a robot must stand so that the block that it holds is somewhere: the reverse of ``grip_of``.

    Args:
        block: where its middle shall be; its yaw is the heading of a robot that it lies square before.
        reach: of the magnet's face, ahead of the robot's middle [m].
        grip: how the block is held.
    """
    yaw = wrap_angle(block.yaw - grip.turn)
    ahead, cos, sin = reach + grip.ahead, math.cos(yaw), math.sin(yaw)
    return Pose(block.x - cos * ahead + sin * grip.aside, block.y - sin * ahead - cos * grip.aside, yaw)


def touching(grip: Grip) -> Grip:
    """Give a grip that was measured as it must be at least: no block is nearer than where it touches the magnet."""
    return grip._replace(ahead=max(grip.ahead, CENTRED.ahead))
