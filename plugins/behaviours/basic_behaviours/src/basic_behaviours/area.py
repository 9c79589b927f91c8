"""Areas of floor, and the lanes along which a robot sees all of one."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Callable, Sequence, Tuple, Union

from rqt_mrta_py.model import Pose

__all__ = ["Area", "Circle", "Lane", "Rectangle", "from_nearer_end", "lanes"]

Lane = Tuple[Pose, ...]
"""Where to begin and where to end, in the frame ``map``; one place only where the lane is too short to drive along."""


@dataclass(frozen=True)
class Rectangle:
    """A rectangle along the axes of the frame ``map``.

    Attributes:
        centre: of it; its heading does not matter.
        length: along x [m].
        width: along y [m].
    """

    centre: Pose
    length: float
    width: float

    def contains(self, place: Pose) -> bool:
        """Tell whether a place lies in it."""
        across, along = abs(place.y - self.centre.y), abs(place.x - self.centre.x)
        return along <= self.length / 2.0 and across <= self.width / 2.0


@dataclass(frozen=True)
class Circle:
    """A disc of floor.

    Attributes:
        centre: of it, in the frame ``map``; its heading does not matter.
        radius: [m].
    """

    centre: Pose
    radius: float

    def contains(self, place: Pose) -> bool:
        """Tell whether a place lies in it."""
        return place.distance(self.centre) <= self.radius


Area = Union[Rectangle, Circle]


def lanes(area: Area, spacing: float) -> Tuple[Lane, ...]:
    """Lay parallel lanes over an area, the robot turning round at the end of each.

    As few as lie at most a spacing apart, the outer ones half of their distance from the border, along the longer side
    of a rectangle. They end half of that distance before the border.

    Args:
        area: to be seen.
        spacing: at most between neighbouring lanes [m].

    Returns:
        The lanes in the order and direction in which they are driven; at least one.
    """
    if isinstance(area, Circle):
        along, across = 2.0 * area.radius, 2.0 * area.radius
    else:
        along, across = max(area.length, area.width), min(area.length, area.width)
    count = max(1, math.ceil(across / spacing - 1e-9))
    apart = across / count
    offsets = [(index + 0.5) * apart - across / 2.0 for index in range(count)]
    if isinstance(area, Circle):
        reach = [math.sqrt(area.radius**2 - offset**2) - apart / 2.0 for offset in offsets]
    else:
        reach = [along / 2.0 - apart / 2.0] * count
    laid = []
    for index, (offset, half) in enumerate(zip(offsets, reach)):
        ends = (-half, half) if index % 2 == 0 else (half, -half)
        laid.append(tuple(_placer(area)(end, offset) for end in (ends if half > 0.0 else (0.0,))))
    return tuple(laid)


def from_nearer_end(laid: Sequence[Lane], pose: Pose) -> Tuple[Lane, ...]:
    """Turn lanes round where the end of the last one is nearer to a pose than the beginning of the first."""
    if laid and pose.distance(laid[-1][-1]) < pose.distance(laid[0][0]):
        return tuple(tuple(reversed(lane)) for lane in reversed(laid))
    return tuple(laid)


def _placer(area: Area) -> Callable[[float, float], Pose]:
    """Give what makes a place of the distances along and across the lanes from the area's centre [m]."""
    x, y = area.centre.x, area.centre.y
    if isinstance(area, Rectangle) and area.width > area.length:
        return lambda along, across: Pose(x + across, y + along)
    return lambda along, across: Pose(x + along, y + across)
