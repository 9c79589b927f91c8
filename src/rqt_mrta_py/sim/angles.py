"""Angles of many robots at once."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

__all__ = ["wrap_angles"]

_FULL_TURN = 2.0 * np.pi


def wrap_angles(angles: NDArray[np.float64]) -> NDArray[np.float64]:
    """Bring angles into (-pi, pi]; to the last bit what ``model.wrap_angle`` gives for each.

    Args:
        angles: of any shape [rad]; what is not finite becomes not a number.
    """
    # Both steps are exact: a remainder is, and so is the difference of two numbers of which neither is twice the other.
    with np.errstate(invalid="ignore"):
        wrapped: NDArray[np.float64] = np.fmod(angles, _FULL_TURN)
        turns = (wrapped > np.pi).view(np.int8) - (wrapped <= -np.pi).view(np.int8)
        wrapped -= turns * _FULL_TURN
    return wrapped
