"""Finds room for labels so that none covers another."""

from __future__ import annotations

import math
from typing import Iterable, List, NamedTuple, Optional, Tuple

from rqt_mrta_py.render.canvas import Box, Point

__all__ = ["LabelPlacer", "Placement"]

# Best first: to the right of its thing, then left, above, below, then in the corners between.
_DIRECTIONS: Tuple[Tuple[float, float], ...] = (
    (1.0, 0.0),
    (-1.0, 0.0),
    (0.0, -1.0),
    (0.0, 1.0),
    (0.8, -0.8),
    (0.8, 0.8),
    (-0.8, -0.8),
    (-0.8, 0.8),
)
_DISTANCES = (3.0, 12.0, 24.0, 40.0, 60.0, 85.0)


class Placement(NamedTuple):
    """Where a label goes.

    Attributes:
        box: its rectangle.
        far: True if it stands so far from its thing that a line should join them.
    """

    box: Box
    far: bool


class LabelPlacer:
    """Places labels one after the other; those placed first have the choice.

    Labels never meet one another nor leave the bounds. They keep off other things where they can.

    Args:
        bounds: that labels must stay in.
        things: rectangles better not covered.
    """

    def __init__(self, bounds: Box, things: Iterable[Box] = ()) -> None:
        self._bounds = bounds
        self._things = tuple(things)
        self.placed: List[Box] = []

    def place(self, anchor: Point, radius: float, size: Tuple[float, float]) -> Optional[Placement]:
        """Find the best place for a label.

        Args:
            anchor: middle of the thing named.
            radius: of the thing named [pixels].
            size: width and height of the label [pixels].

        Returns:
            Its place, which is then taken; None if there is no room near its thing.
        """
        covering: Optional[Tuple[int, Placement]] = None
        for distance in _DISTANCES:
            for direction in _DIRECTIONS:
                box = _box_beside(anchor, radius + distance, direction, size)
                if not self._bounds.holds(box) or any(box.meets(other) for other in self.placed):
                    continue
                covered = sum(box.meets(thing) for thing in self._things)
                placement = Placement(box, distance > _DISTANCES[0])
                if not covered:
                    self.placed.append(box)
                    return placement
                if covering is None or covered < covering[0]:
                    covering = (covered, placement)
        if covering is None:
            return None
        self.placed.append(covering[1].box)
        return covering[1]


def _box_beside(anchor: Point, distance: float, direction: Tuple[float, float], size: Tuple[float, float]) -> Box:
    (dx, dy), (width, height) = direction, size
    reach = distance / math.hypot(dx, dy)
    x = anchor[0] + dx * reach + math.copysign(width / 2.0, dx) * (dx != 0.0)
    y = anchor[1] + dy * reach + math.copysign(height / 2.0, dy) * (dy != 0.0)
    left, top = round(x - width / 2.0), round(y - height / 2.0)
    return Box(left, top, left + width, top + height)
