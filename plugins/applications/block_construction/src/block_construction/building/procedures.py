"""The two procedures of a builder as tables of actions: manipulation fetches a block, assembly places it.

Dantas (2017), section 3.4.
"""

from __future__ import annotations

from typing import Tuple

from block_construction.building.actions import Action, Ending, Kind
from block_construction.building.gripping import CENTRED
from rqt_mrta_py.hooks import ArmModel

__all__ = ["CLEARANCE", "STAND_OFF", "TRAVEL_SPEED", "TURN_RATE", "assembly", "manipulation", "withdrawal"]

TRAVEL_SPEED = 0.03
"""Dantas (2017), section 6.3 [m/s]."""
TURN_RATE = 0.08
"""The same [rad/s]."""
SLOW = 0.01
"""Near what is touched [m/s]."""
STAND_OFF = 0.55
"""From the middle of a block to where the arm is raised and lowered before it; its arc swings out to 0.49 m [m]."""
CLEARANCE = 0.01
"""So high above its place a block is brought over it [m]."""
_NEARLY_DOWN = 0.001
"""So high the base is set right for the last time [m]."""
_NEAR = 0.03
"""So far from its end an approach becomes slow, and a retreat fast [m]."""
_PRESS = 0.003
"""So far beyond contact the magnet is driven, so that the block lies square before it, and is known to be close [m]."""
_LIFT = 0.02
"""So far a block is lifted before it is drawn back [m]."""


def manipulation(arm: ArmModel, height: float) -> Tuple[Action, ...]:
    """List the actions that fetch a block.

    Differs from the paper: the magnet is switched on after the approach, and not before; it takes what is up to 1 cm
    away, and how far away that was nobody would know.

    Args:
        arm: of the robot.
        height: of the block's middle [m].

    Raises:
        ValueError: the arm does not reach it.
    """
    low = arm.angle_at(height)
    lifted = arm.angle_at(height + _LIFT)
    contact = arm.reach_at(low) + CENTRED.ahead
    return (
        Action(Kind.POSITION, arm.highest, STAND_OFF, TRAVEL_SPEED, magnet=False),
        Action(Kind.LOWER, low, STAND_OFF, SLOW, magnet=False),
        Action(Kind.APPROACH, low, contact + _NEAR, TRAVEL_SPEED, magnet=False, wait=0.0),
        Action(Kind.APPROACH, low, contact - _PRESS, SLOW, magnet=False),
        Action(Kind.APPROACH, low, contact - _PRESS, SLOW, magnet=True, ending=Ending.HELD),
        Action(Kind.RAISE, lifted, None, SLOW, magnet=True),
        Action(Kind.RETREAT, lifted, STAND_OFF, TRAVEL_SPEED, magnet=True, wait=0.0),
        Action(Kind.RAISE, arm.highest, STAND_OFF, SLOW, magnet=True),
    )


def assembly(arm: ArmModel, height: float, ahead: float) -> Tuple[Action, ...]:
    """List the actions that place a block.

    Differs from the paper: the arm is lowered to a little above the slot before the block approaches, for on the arm's
    arc it would hit what is higher behind the slot; the paper approaches first. It leaves out retreating and raising.

    Args:
        arm: of the robot.
        height: of the block's middle in its slot [m].
        ahead: of the block's middle before the magnet's face [m].

    Raises:
        ValueError: the arm does not reach it.
    """
    above, nearly, down = (arm.angle_at(height + more) for more in (CLEARANCE, _NEARLY_DOWN, 0.0))
    over = arm.reach_at(above) + ahead
    return (
        Action(Kind.POSITION, arm.highest, STAND_OFF, TRAVEL_SPEED, magnet=True),
        Action(Kind.LOWER, above, STAND_OFF, SLOW, magnet=True),
        Action(Kind.APPROACH, above, over + _NEAR, TRAVEL_SPEED, magnet=True, wait=0.0),
        Action(Kind.APPROACH, above, over, SLOW, magnet=True),
        Action(Kind.LOWER, nearly, None, SLOW, magnet=True),
        Action(Kind.LOWER, down, None, SLOW, magnet=True),
        Action(Kind.LOWER, down, None, SLOW, magnet=False, ending=Ending.LET_GO),
        Action(Kind.RETREAT, down, arm.reach_at(down) + ahead + _NEAR, SLOW, magnet=False, wait=0.0),
        Action(Kind.RETREAT, down, STAND_OFF, TRAVEL_SPEED, magnet=False, wait=0.0),
        Action(Kind.RAISE, arm.highest, STAND_OFF, SLOW, magnet=False),
    )


def withdrawal(arm: ArmModel, angle: float, *, magnet: bool) -> Tuple[Action, ...]:
    """List the actions of a robot that was interrupted with its arm down: away from whatever is before it, arm up.

    Args:
        arm: of the robot.
        angle: at which the arm is [rad].
        magnet: whether it holds something.
    """
    return (
        Action(Kind.RETREAT, angle, STAND_OFF, SLOW, magnet=magnet),
        Action(Kind.RAISE, arm.highest, STAND_OFF, SLOW, magnet=magnet),
    )
