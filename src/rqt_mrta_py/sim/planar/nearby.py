"""What robots have around them: found by cells, and kept while nothing has moved far."""

from __future__ import annotations

from typing import Dict, List, NamedTuple, Optional, Tuple

import numpy as np

from rqt_mrta_py.sim.planar.cells import Cells, Floats, Rows
from rqt_mrta_py.sim.planar.visible import Visible

__all__ = ["Nearby", "Pairs"]

_FORESIGHT = 0.25
"""How much farther than robots see, as a share of that, things are kept in mind."""
_MOST_TRAVEL = 0.49
"""What is kept in mind lasts until something has come this share of that way: two may have come towards each other."""
_MOST_KEPT = 4_000_000
"""Pairs in mind, which bounds the memory."""


class Pairs(NamedTuple):
    """Robots and the things that they may see, one pair an element of every array.

    Attributes:
        robot: its place among the robots that look.
        thing: its column in ``Visible``.
        radius: of the thing [m].
        reach_squared: of how far away its middle may be for something of it to be seen [m2].
    """

    robot: Rows
    thing: Rows
    radius: Floats
    reach_squared: Floats


class Nearby:
    """Finds what robots may see.

    Args:
        visible: what there is, up to date whenever somebody asks.
        heights: of the planes of the robots' range finders [m], shape (robots,).
    """

    def __init__(self, visible: Visible, heights: Floats) -> None:
        self._visible = visible
        self._heights = heights
        self._kept: Dict[Tuple[float, bytes], Tuple[float, Pairs]] = {}
        self._count = 0
        self._lineup = -1
        self._obstacle_cells: Optional[Cells] = None

    def pairs(self, rows: Rows, max_range: float) -> Pairs:
        """Give all things that robots may see, at their heights; some are a bit too far away.

        Args:
            rows: of the robots.
            max_range: how far they see [m].
        """
        if self._lineup != self._visible.lineup:
            self._lineup = self._visible.lineup
            self._forget()
        key = (max_range, rows.tobytes())
        travel = self._visible.travel
        if key in self._kept:
            last, pairs = self._kept[key]
            if travel <= last:
                return pairs
            del self._kept[key]
            self._count -= pairs.robot.size
        pairs = self._found(rows, max_range)
        if self._count + pairs.robot.size > _MOST_KEPT:
            self._forget()
        self._kept[key] = (travel + _MOST_TRAVEL * _FORESIGHT * max_range, pairs)
        self._count += pairs.robot.size
        return pairs

    def _forget(self) -> None:
        self._kept.clear()
        self._count = 0

    def _found(self, rows: Rows, max_range: float) -> Pairs:
        visible = self._visible
        obstacles = visible.obstacles
        x, y, _ = visible.poses
        if self._obstacle_cells is None:
            self._obstacle_cells = Cells(x[:obstacles], y[:obstacles])
        groups: List[Pairs] = []
        for cells, first, radius in (
            (self._obstacle_cells, 0, visible.shapes.radius[:obstacles]),
            (Cells(x[obstacles:], y[obstacles:]), obstacles, visible.shapes.radius[obstacles:]),
        ):
            reach = (1 + _FORESIGHT) * max_range + radius.max(initial=0.0)
            groups.append(self._near(rows, cells, first, reach, max_range))
        return Pairs(*(np.concatenate(fields) for fields in zip(*groups)))

    def _near(self, rows: Rows, cells: Cells, first: int, reach: float, max_range: float) -> Pairs:
        """Find things of one kind, of which the first has a column, that are no farther away than a reach."""
        visible, own = self._visible, rows + self._visible.obstacles
        (x, y, _), shapes = visible.poses, visible.shapes
        robot, thing = cells.near(x[own], y[own], reach)
        thing += first
        apart_x, apart_y = x[thing] - x[own][robot], y[thing] - y[own][robot]
        radius, height = shapes.radius[thing], self._heights[rows][robot]
        is_near = apart_x * apart_x + apart_y * apart_y <= ((1 + _FORESIGHT) * max_range + radius) ** 2
        is_near &= (shapes.low[thing] <= height) & (height <= shapes.high[thing])
        is_near &= own[robot] != thing
        found = np.flatnonzero(is_near)
        radius = radius[found]
        return Pairs(robot[found], thing[found], radius, (max_range + radius) ** 2)
