"""One robot's decision among many: the open targets in its Voronoi cell and the cheapest of them."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from mrta_demir_cf.planning.arrays import Floats, Indices
from mrta_demir_cf.planning.compiled import inner_kernel
from mrta_demir_cf.planning.kernels.cells import Outline, owns, sketch_cell
from mrta_demir_cf.planning.kernels.grids import cell_along
from mrta_demir_cf.planning.kernels.pairs import farthest_of
from mrta_demir_cf.planning.kernels.queues import Queues
from mrta_demir_cf.planning.kernels.ways import Ways, place_on_way
from mrta_demir_cf.planning.point_grid import PointGrid

__all__ = ["Field", "decide"]


class Field(NamedTuple):
    """What robots decide on, and room to do so.

    Attributes:
        ways: of all robots.
        queues: robots that are yet at one place.
        robots: those that are not hidden, sorted into cells from time to time.
        targets: those that are open, sorted into cells.
        places: of all targets, (N, 2) [m].
        outline: room for a cell.
        schedule: room for the indices of its targets, (N,).
        outer: room for those of them that may be the farthest pair, (N,).
        squares: room for the squares of distances to them, (N,) [m^2].
    """

    ways: Ways
    queues: Queues
    robots: PointGrid
    targets: PointGrid
    places: Floats
    outline: Outline
    schedule: Indices
    outer: Indices
    squares: Floats


@inner_kernel
def decide(robot: int, now: float, drift: float, field: Field, alpha: float) -> int:
    """Select as ``selection.select`` does by Eq. 3 with ``alpha``, by Eq. 2 where ``alpha`` is 1.

    Args:
        robot: who decides.
        now: the moment [s].
        drift: how far robots may have moved since they were sorted [m].
        field: robots and open targets.
        alpha: the weight of the distance.

    Returns:
        The index of the target; -1 if there is none.
    """
    corners, rivals = sketch_cell(robot, now, drift, field.ways, field.robots, field.targets, field.outline)
    if corners == 0:
        return -1
    count = _form_schedule(robot, now, corners, rivals, field, alpha == 1.0)
    if count == 0:
        return -1
    return _cheapest(field, count, alpha)


@inner_kernel
def _form_schedule(  # noqa: PLR0917 - numba knows no keyword-only arguments
    robot: int, now: float, corners: int, rivals: int, field: Field, nearest: bool
) -> int:
    """Collect a robot's targets, in no order; only such as are no farther than those before if ``nearest``."""
    at_x, at_y = place_on_way(field.ways, robot, now)
    polygon, grid = field.outline.corners, field.targets
    left, right, lower, upper = grid.side, 0, grid.side, 0
    for corner in range(corners):
        column = cell_along(at_x + polygon[corner, 0], grid.low[0], grid)
        row = cell_along(at_y + polygon[corner, 1], grid.low[1], grid)
        left, right, lower, upper = min(left, column), max(right, column), min(lower, row), max(upper, row)
    count, limit = 0, np.inf
    for row in range(lower, upper + 1):
        for cell in range(row * grid.side + left, row * grid.side + right + 1):
            for position in range(grid.first[cell], grid.ends[cell]):
                target = grid.members[position]
                x, y = field.places[target, 0], field.places[target, 1]
                square = (x - at_x) * (x - at_x) + (y - at_y) * (y - at_y)
                if square <= limit and owns(robot, square, x, y, field.outline, rivals):
                    field.schedule[count], field.squares[count] = target, square
                    count += 1
                    if nearest:
                        # Roots of different squares may be equal.
                        limit = square * (1.0 + 1e-12)
    return count


@inner_kernel
def _cheapest(field: Field, count: int, alpha: float) -> int:
    """Give the cheapest target of a schedule by Eq. 3, the first of equals."""
    places = field.places
    paired = alpha < 1.0 and count > 1
    first = second = field.schedule[0]
    if paired:
        first, second = farthest_of(places, field.schedule, count, field.outer)
    span = _distance(places, first, second)
    lowest, best = np.inf, -1
    for index in range(count):
        target = field.schedule[index]
        cost = alpha * np.sqrt(field.squares[index])
        if cost > lowest:
            continue
        if paired:
            farther = max(_distance(places, first, target), _distance(places, second, target))
            cost += (1.0 - alpha) * (span - farther)
        if cost < lowest or (cost == lowest and target < best):
            lowest, best = cost, target
    return best


@inner_kernel
def _distance(places: Floats, start: int, end: int) -> float:
    along_x, along_y = places[end, 0] - places[start, 0], places[end, 1] - places[start, 1]
    return float(np.sqrt(along_x * along_x + along_y * along_y))
