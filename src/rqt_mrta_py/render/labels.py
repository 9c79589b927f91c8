"""Finds room for labels so that none covers another."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, List, NamedTuple, Optional, Sequence, Tuple, Union

import numpy as np

from rqt_mrta_py.render.canvas import Box, Point

if TYPE_CHECKING:
    from numpy.typing import NDArray

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
_NEAR = _DISTANCES[:1]

_FREE, _THING, _LABEL = 0, 1, 2


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

    Labels never meet one another nor leave the bounds. They keep off other things where they can. What is taken is
    kept as a plan of the bounds, one cell to a pixel, so that a label's cost does not grow with what is there.

    Args:
        bounds: that labels must stay in.
        things: rectangles better not covered: left, top, right, bottom; or an array (things, 4) of them.
    """

    def __init__(self, bounds: Box, things: Union[Sequence[Sequence[float]], NDArray[np.float64]] = ()) -> None:
        self._bounds = bounds
        self._left, self._top = math.floor(bounds.left), math.floor(bounds.top)
        size = (max(math.ceil(bounds.bottom) - self._top, 0), max(math.ceil(bounds.right) - self._left, 0))
        self._plan = np.zeros(size, dtype=np.uint8)
        edges = np.array(things, dtype=np.float64).reshape(-1, 4) - (self._left, self._top, self._left, self._top)
        cells = np.hstack((np.floor(edges[:, :2]), np.ceil(edges[:, 2:]))).clip(0, max(size))
        for left, top, right, bottom in cells.astype(np.intp).tolist():
            self._plan[top:bottom, left:right] = _THING
        self.placed: List[Box] = []

    def place(self, anchor: Point, radius: float, size: Tuple[float, float], near: bool = False) -> Optional[Placement]:
        """Find the best place for a label.

        Args:
            anchor: middle of the thing named.
            radius: of the thing named [pixels].
            size: width and height of the label [pixels].
            near: the label must touch its thing and cover no other.

        Returns:
            Its place, which is then taken; None if there is no room near its thing.
        """
        least: Optional[Tuple[int, Placement]] = None
        for distance in _NEAR if near else _DISTANCES:
            for direction in _DIRECTIONS:
                box = _box_beside(anchor, radius + distance, direction, size)
                if not self._bounds.holds(box):
                    continue
                ground = self._ground(box)
                worst = int(ground.max(initial=_FREE))
                if worst == _FREE:
                    return self._take(Placement(box, distance > _DISTANCES[0]))
                if worst == _THING and not near:
                    covered = int(np.count_nonzero(ground))
                    if least is None or covered < least[0]:
                        least = (covered, Placement(box, distance > _DISTANCES[0]))
        return None if least is None else self._take(least[1])

    def _take(self, placement: Placement) -> Placement:
        self._ground(placement.box)[:] = _LABEL
        self.placed.append(placement.box)
        return placement

    def _ground(self, box: Box) -> NDArray[np.uint8]:
        left, top, right, bottom = box
        return self._plan[
            math.floor(top) - self._top : math.ceil(bottom) - self._top,
            math.floor(left) - self._left : math.ceil(right) - self._left,
        ]


def _box_beside(anchor: Point, distance: float, direction: Tuple[float, float], size: Tuple[float, float]) -> Box:
    (dx, dy), (width, height) = direction, size
    reach = distance / math.hypot(dx, dy)
    x = anchor[0] + dx * reach + math.copysign(width / 2.0, dx) * (dx != 0.0)
    y = anchor[1] + dy * reach + math.copysign(height / 2.0, dy) * (dy != 0.0)
    left, top = round(x - width / 2.0), round(y - height / 2.0)
    return Box(left, top, left + width, top + height)
