"""What loose bodies cover, seen from above."""

from __future__ import annotations

import math
from typing import Sequence, Tuple

from rqt_mrta_py.hooks import BodyState
from rqt_mrta_py.model import Pose

__all__ = ["axes_of", "footprint_of", "footprints_overlap"]

_TOUCH = 1e-9
"""Overlaps smaller than this are rounding [m]."""

_Vector = Tuple[float, float, float]


def axes_of(quaternion: Tuple[float, float, float, float]) -> Tuple[_Vector, _Vector, _Vector]:
    """Give the x, y and z axes of a frame in the frame that it is turned in.

    Args:
        quaternion: x, y, z, w; of length 1.
    """
    x, y, z, w = quaternion
    return (
        (1 - 2 * (y * y + z * z), 2 * (x * y + z * w), 2 * (x * z - y * w)),
        (2 * (x * y - z * w), 1 - 2 * (x * x + z * z), 2 * (y * z + x * w)),
        (2 * (x * z + y * w), 2 * (y * z - x * w), 1 - 2 * (x * x + y * y)),
    )


def footprint_of(state: BodyState, size: Sequence[float]) -> Tuple[Pose, Tuple[float, float]]:
    """Give the rectangle that a box covers, or a little more if it does not lie flat.

    Args:
        state: where it is.
        size: its length, width, height [m].

    Returns:
        The rectangle's centre and heading in the frame ``map``, and its length and width [m].
    """
    axes = axes_of(state.orientation)
    # Along whichever side lies flattest the rectangle is least too large.
    flattest = min(axes, key=lambda axis: abs(axis[2]))
    length = math.hypot(flattest[0], flattest[1])
    cos, sin = flattest[0] / length, flattest[1] / length
    along = sum(abs(cos * axis[0] + sin * axis[1]) * side for axis, side in zip(axes, size))
    across = sum(abs(cos * axis[1] - sin * axis[0]) * side for axis, side in zip(axes, size))
    return Pose(state.position[0], state.position[1], math.atan2(sin, cos)), (along, across)


def footprints_overlap(
    first: Pose, first_size: Sequence[float], second: Pose, second_size: Sequence[float], apart: float = 0.0
) -> bool:
    """Tell whether two rectangles are closer to each other than they may be.

    They are apart if there is a gap between them along the direction of one of their sides.

    Args:
        first: centre and heading of one, frame ``map``.
        first_size: its length and width; what follows is passed over [m].
        second: centre and heading of the other, frame ``map``.
        second_size: as of the first [m].
        apart: how wide a gap must be [m].
    """
    dx, dy = second.x - first.x, second.y - first.y
    for yaw in (first.yaw, first.yaw + math.pi / 2, second.yaw, second.yaw + math.pi / 2):
        between = abs(math.cos(yaw) * dx + math.sin(yaw) * dy)
        if (
            between
            >= _half_extent(first.yaw - yaw, first_size) + _half_extent(second.yaw - yaw, second_size) + apart - _TOUCH
        ):
            return False
    return True


def _half_extent(turn: float, size: Sequence[float]) -> float:
    """Give how far a turned rectangle reaches from its centre along a direction [m]."""
    return (abs(math.cos(turn)) * size[0] + abs(math.sin(turn)) * size[1]) / 2
