"""Where the robots and tasks of a new application are: on a grid, well apart."""

from __future__ import annotations

import math
from typing import Iterator, List, NamedTuple, Optional, Sequence, Tuple

from rqt_mrta_py.model import Arena, Pose

__all__ = ["Layout", "lay_out"]

_CELL = 2.0
"""Between neighbours, and from the outermost to a wall at least half of it [m]."""

_SMALLEST = 6.0
"""Length of the sides of the smallest arena [m]."""

_APART = 1.0
"""So far are places of the grid from given ones [m]."""

Point = Tuple[float, float]


class Layout(NamedTuple):
    """Floor, start poses of robots and places of tasks, in the frame ``map``."""

    arena: Arena
    starts: Tuple[Pose, ...]
    places: Tuple[Pose, ...]


def lay_out(robots: int, tasks: int, given: Sequence[Point] = (), arena: Optional[Arena] = None) -> Layout:
    """Find a place for everything.

    Robots start side by side at the lower wall; the places of tasks are spread over the rest of the floor.

    Args:
        robots: how many.
        tasks: how many tasks need a place.
        given: places that are taken, in the frame ``map`` [m].
        arena: the floor; None: as large as needed, around the origin.

    Raises:
        ValueError: the arena has not enough room.
    """
    floor = arena or _floor(robots + tasks, given)
    cell = _CELL
    cells: List[Point] = []
    while True:
        cells = [point for point in _cells(floor, cell) if all(_far(point, other) for other in given)]
        if len(cells) >= robots + tasks:
            break
        if arena is None:
            floor = _wider(floor)
        elif cell > _APART:
            cell /= 2
        else:
            raise ValueError(f"has no room for {robots} robots and {tasks} places {cell:g} m apart; give a larger one")
    starts = cells[:robots]
    rest = cells[robots:]
    step = len(rest) / tasks if tasks else 1.0
    # From the far end, so that the first task is not beside the first robot.
    places = [rest[len(rest) - 1 - int(number * step)] for number in range(tasks)]
    return Layout(
        floor,
        tuple(Pose(x, y, round(math.pi / 2, 4)) for x, y in starts),
        tuple(Pose(x, y, 0.0) for x, y in places),
    )


def _floor(count: int, given: Sequence[Point]) -> Arena:
    """Make a square floor with a cell for everybody, and half a cell around whatever is given."""
    half = max(_SMALLEST, _CELL * math.ceil(math.sqrt(count))) / 2
    xs, ys = [x for x, _ in given], [y for _, y in given]
    room = _CELL / 2
    return Arena(
        float(math.floor(min([-half, *(x - room for x in xs)]))),
        float(math.floor(min([-half, *(y - room for y in ys)]))),
        float(math.ceil(max([half, *(x + room for x in xs)]))),
        float(math.ceil(max([half, *(y + room for y in ys)]))),
    )


def _wider(floor: Arena) -> Arena:
    return Arena(floor.min_x - _CELL, floor.min_y, floor.max_x + _CELL, floor.max_y, floor.wall_height)


def _cells(floor: Arena, cell: float) -> Iterator[Point]:
    """Give the middles of cells, by rows from the lower wall."""
    columns, rows = int((floor.max_x - floor.min_x) / cell), int((floor.max_y - floor.min_y) / cell)
    for row in range(rows):
        for column in range(columns):
            x = floor.min_x + (floor.max_x - floor.min_x) * (column + 0.5) / columns
            y = floor.min_y + (floor.max_y - floor.min_y) * (row + 0.5) / rows
            yield round(x, 2), round(y, 2)


def _far(point: Point, other: Point) -> bool:
    return math.hypot(point[0] - other[0], point[1] - other[1]) >= _APART
