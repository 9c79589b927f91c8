"""Where building takes place: a square with walls, and the site in its middle."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import NamedTuple, Tuple

from block_construction.diagram.block_set import PITCH
from block_construction.errors import ConstructionError
from rqt_mrta_py.hooks import Structure

__all__ = ["Arena", "Point", "Site", "site_of"]

_MOST_CELLS = 400
"""Along one side of the grid."""
_LARGEST = 100.0
"""Across it a robot drives for an hour [m]."""
_SLACK = 1e-9


class Point(NamedTuple):
    """A place in the arena, from its corner [m]."""

    x: float
    y: float


@dataclass(frozen=True)
class Arena:
    """A square with walls, in which one robot drives.

    The source gives no measures; these follow from its distances per block (its tables 10 to 16).

    Attributes:
        side: of the square [m].
        cell: of the grid that ways are found on [m].
        robot_radius: that the robot keeps from walls and placed blocks [m].
        stand_off: from the middle of a block, or of a supply place, to where the robot stands before it [m].
        start: where the robot begins [m].

    Raises:
        ConstructionError: a measure is not finite and above 0, the side or the grid is too large, or the
            start too near to a wall.
    """

    side: float = 2.2
    cell: float = 0.04
    robot_radius: float = 0.18
    stand_off: float = 0.30
    start: Tuple[float, float] = (1.10, 0.20)

    def __post_init__(self) -> None:
        for name in ("side", "cell", "robot_radius", "stand_off"):
            value = getattr(self, name)
            if not (math.isfinite(value) and value > 0.0):
                raise ConstructionError(f"arena: {name}: must be finite and above 0 m (found {value})")
        if self.side > _LARGEST:
            raise ConstructionError(f"arena: side: {self.side:g} m; at most {_LARGEST:g} m are accepted")
        if not 2 <= self.side / self.cell <= _MOST_CELLS:
            raise ConstructionError(
                f"arena: cell: {self.cell:g} m for a side of {self.side:g} m; 2 to {_MOST_CELLS} cells a side are "
                "accepted"
            )
        if not self.has_room(Point(*self.start)):
            raise ConstructionError(
                f"arena: start: ({self.start[0]:g}, {self.start[1]:g}) m is nearer than {self.robot_radius:g} m to a "
                f"wall, or outside; the arena measures {self.side:g} m"
            )

    @property
    def middle(self) -> Point:
        """Its middle [m]."""
        return Point(self.side / 2.0, self.side / 2.0)

    def has_room(self, point: Point) -> bool:
        """Tell whether the robot can stand somewhere without touching a wall."""
        least, most = self.robot_radius - _SLACK, self.side - self.robot_radius + _SLACK
        return all(least <= value <= most for value in point)


class Site(NamedTuple):
    """Where the structure stands.

    Attributes:
        left, bottom: its corner of column 1, row 1 [m].
        right, top: the opposite one [m].
    """

    left: float
    bottom: float
    right: float
    top: float

    def distance(self, point: Point) -> float:
        """Tell how far a point lies outside of the site [m]; 0 inside."""
        return math.hypot(
            max(self.left - point.x, point.x - self.right, 0.0), max(self.bottom - point.y, point.y - self.top, 0.0)
        )


def site_of(arena: Arena, structure: Structure) -> Site:
    """Put a structure into the middle of the arena.

    Args:
        arena: where.
        structure: what will stand there.

    Raises:
        ConstructionError: there is no room around it for the robot to place its outermost blocks.
    """
    longer = max(structure.columns, structure.rows) * PITCH
    # The robot stands before the outermost blocks, whose middles lie half a pitch inside.
    needed = longer + 2.0 * (arena.stand_off - PITCH / 2.0 + arena.robot_radius)
    if needed > arena.side + _SLACK:
        most = max(0, math.floor((arena.side - needed + longer + _SLACK) / PITCH))
        column, row = _first_beyond(structure, most)
        raise ConstructionError(
            f"{structure.name}: measures {structure.columns * PITCH:g} m x {structure.rows * PITCH:g} m; the robot "
            f"needs an arena of {needed:g} m around it (found {arena.side:g} m); voxel x {column}, y {row}, "
            f"level 1 is beyond the {most} cells a side that have room"
        )
    half_width, half_depth = structure.columns * PITCH / 2.0, structure.rows * PITCH / 2.0
    x, y = arena.middle
    return Site(x - half_width, y - half_depth, x + half_width, y + half_depth)


def _first_beyond(structure: Structure, most: int) -> Tuple[int, int]:
    """Find the first column that is filled, by row, beyond so many columns or rows."""
    return next(
        (x, y)
        for y, row in enumerate(structure.heights, 1)
        for x, height in enumerate(row, 1)
        if height and max(x, y) > most
    )
