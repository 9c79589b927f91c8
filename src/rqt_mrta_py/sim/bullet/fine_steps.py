"""When physics must go in fine steps: while a builder handles blocks, and until they rest; coarse steps move them."""

from __future__ import annotations

import math
from typing import Mapping

from rqt_mrta_py.sim.bullet.loose_bodies import LooseBodies
from rqt_mrta_py.sim.bullet.mecanum_robot import MecanumRobot

__all__ = ["FINE_STEP", "SETTLING", "is_at_work"]

FINE_STEP = 1 / 240
"""Of physics, while a builder is at work, or blocks settle [s]."""
SETTLING = 3.0
"""So long a block that was put down settles until it rests; in coarse steps, a stack never would [s]."""

_NEAR = 0.30
"""A block whose centre lies so far from a magnet may soon be touched by it, or by what it holds [m]."""
_UP = 0.05
"""An arm is up within so much of its highest angle [rad]."""


def is_at_work(builders: Mapping[str, MecanumRobot], loose: LooseBodies) -> bool:
    """Tell whether some builder whose arm is not up, or that holds something, has other bodies near its magnet.

    Args:
        builders: by id.
        loose: all that they could touch.
    """
    for name, builder in builders.items():
        held = loose.held_by(name)
        is_up = min(builder.arm_angle(), builder.goal) >= builder.arm.highest - _UP
        if is_up and not held:
            continue
        (x, y, _), _ = builder.hand_frame()
        for body, (position, _) in loose.states().items():
            if body not in held and math.hypot(position[0] - x, position[1] - y) <= _NEAR:
                return True
    return False
