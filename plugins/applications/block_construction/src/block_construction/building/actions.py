"""The five actions of a builder (Dantas 2017, section 3.4): what each one aims at and what ends it."""

from __future__ import annotations

from enum import Enum
from typing import NamedTuple, Optional

__all__ = ["Action", "Ending", "Kind"]


class Kind(Enum):
    """What an action is."""

    POSITION = "position"
    APPROACH = "approach"
    RETREAT = "retreat"
    RAISE = "raise"
    LOWER = "lower"


class Ending(Enum):
    """What must be heard before an action is over."""

    THERE = "there"
    """Base and arm are where they shall be."""
    HELD = "held"
    """The magnet holds something; that nothing was there is known once base and arm are where they shall be."""
    LET_GO = "let_go"
    """The magnet holds nothing any more."""


class Action(NamedTuple):
    """One action.

    Attributes:
        kind: which of the five.
        angle: of joint 1, to which the arm goes [rad].
        distance: from the robot's middle to that of the block that is fetched or placed, to which the base goes along
            its heading [m]; None: as the arm's reach takes, so that what the magnet holds goes straight up or down.
        speed: of base, or of the magnet up or down where ``distance`` is None, at most [m/s].
        magnet: whether it is on.
        ending: what ends it.
        wait: how long to stand still afterwards [s].
    """

    kind: Kind
    angle: float
    distance: Optional[float]
    speed: float
    magnet: bool
    ending: Ending = Ending.THERE
    wait: float = 0.5
