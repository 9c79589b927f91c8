"""A robot's Voronoi cell among many, by looking at the robots around it (Eq. 1).

The cell is cut out of the rectangle of all targets, half-plane by half-plane, robots in growing rings; the search ends
where robots are more than twice as far away as the farthest corner. The polygon is only used to leave out what need not
be looked at, and is wider than the cell by more than rounding can do: ``owns`` has the last word.
"""

from __future__ import annotations

from typing import NamedTuple, Tuple

import numpy as np

from mrta_demir_cf.planning.arrays import Floats, Indices
from mrta_demir_cf.planning.compiled import inner_kernel
from mrta_demir_cf.planning.kernels.grids import border_of_ring, cell_along
from mrta_demir_cf.planning.kernels.ways import Ways, place_on_way
from mrta_demir_cf.planning.point_grid import PointGrid

__all__ = ["Outline", "outline_of", "owns", "sketch_cell"]

_SLACK = 1e-9
"""Share by which polygons are widened."""

_NOISE = 1e-14
"""Share of the largest square that rounding may add to the difference of two squares, and more."""


class Outline(NamedTuple):
    """Room for the polygon around a robot's cell and for the robots that may have a share in it: O(M).

    Attributes:
        corners: relative to the robot, (M + 8, 2) [m], those used first, against the clock.
        spare: the same, while the polygon is being cut.
        rivals: indices of robots, (M,), those used first.
        places: where those are, (M, 2) [m].
    """

    corners: Floats
    spare: Floats
    rivals: Indices
    places: Floats


def outline_of(team: int) -> Outline:
    """Make room for the cells of a team."""
    return Outline(np.empty((team + 8, 2)), np.empty((team + 8, 2)), np.empty(team, dtype=np.intp), np.empty((team, 2)))


@inner_kernel
def sketch_cell(  # noqa: PLR0917 - numba knows no keyword-only arguments
    robot: int, now: float, drift: float, ways: Ways, robots: PointGrid, targets: PointGrid, outline: Outline
) -> Tuple[int, int]:
    """Draw a polygon around the part of a robot's cell where targets are.

    Args:
        robot: whose cell.
        now: the moment [s].
        drift: how far robots may have moved since they were sorted [m].
        ways: of all robots.
        robots: sorted into cells.
        targets: sorted into cells.
        outline: what is written to.

    Returns:
        The number of corners, 0 if nothing can be the robot's; the number of rivals: nobody else is nearer to any
        point of the polygon, or as near.
    """
    at_x, at_y = place_on_way(ways, robot, now)
    scale = _draw_rectangle(at_x, at_y, targets, outline.corners)
    reach, corners, rivals, ring = scale, 4, 0, 0
    column, row = cell_along(at_x, robots.low[0], robots), cell_along(at_y, robots.low[1], robots)
    while ring < robots.side and border_of_ring(at_x, at_y, ring, robots) - drift <= 2.0 * reach + _SLACK * scale:
        for across in range(max(row - ring, 0), min(row + ring, robots.side - 1) + 1):
            step = 1 if abs(across - row) == ring else 2 * ring
            for along in range(column - ring, column + ring + 1, step):
                if along < 0 or along >= robots.side:
                    continue
                cell = across * robots.side + along
                for position in range(robots.first[cell], robots.ends[cell]):
                    other = robots.members[position]
                    if other == robot:
                        continue
                    there_x, there_y = place_on_way(ways, other, now)
                    along_x, along_y = there_x - at_x, there_y - at_y
                    square = along_x * along_x + along_y * along_y
                    if square == 0.0:
                        if other < robot:
                            return 0, 0
                        continue
                    if square > 4.0 * reach * reach * (1.0 + _SLACK):
                        continue
                    width = scale * (_SLACK * np.sqrt(square) + _NOISE * scale)
                    beyond = _beyond(outline.corners, corners, along_x, along_y) - square / 2.0
                    if beyond <= -width:
                        continue
                    outline.rivals[rivals] = other
                    outline.places[rivals, 0], outline.places[rivals, 1] = there_x, there_y
                    rivals += 1
                    if beyond > width:
                        corners = _cut(outline, corners, along_x, along_y, square / 2.0 + width)
                        if corners == 0:
                            return 0, 0
                        reach = _reach(outline.corners, corners)
        ring += 1
    return corners, rivals


@inner_kernel
def owns(robot: int, square: float, x: float, y: float, outline: Outline, rivals: int) -> bool:  # noqa: PLR0917
    """Tell whether a robot is nearest to a target within its polygon, of equally near ones the first (Eq. 1).

    Args:
        robot: whose polygon.
        square: of its distance to the target [m^2].
        x: of the target [m].
        y: of the target [m].
        outline: with the rivals.
        rivals: how many.
    """
    for index in range(rivals):
        along_x, along_y = x - outline.places[index, 0], y - outline.places[index, 1]
        other = along_x * along_x + along_y * along_y
        if other < square or (other == square and outline.rivals[index] < robot):
            return False
    return True


@inner_kernel
def _draw_rectangle(at_x: float, at_y: float, targets: PointGrid, corners: Floats) -> float:
    """Begin with the rectangle of all targets; give how far its farthest corner is [m]."""
    left, right = targets.low[0] - at_x, targets.high[0] - at_x
    lower, upper = targets.low[1] - at_y, targets.high[1] - at_y
    farthest_x, farthest_y = max(abs(left), abs(right)), max(abs(lower), abs(upper))
    scale = float(np.sqrt(farthest_x * farthest_x + farthest_y * farthest_y))
    slack = _SLACK * scale
    corners[0, 0], corners[0, 1] = left - slack, lower - slack
    corners[1, 0], corners[1, 1] = right + slack, lower - slack
    corners[2, 0], corners[2, 1] = right + slack, upper + slack
    corners[3, 0], corners[3, 1] = left - slack, upper + slack
    return scale * (1.0 + 2.0 * _SLACK)


@inner_kernel
def _beyond(corners: Floats, count: int, along_x: float, along_y: float) -> float:
    """Give the largest scalar product of a corner and a direction."""
    largest = -np.inf
    for index in range(count):
        largest = max(largest, corners[index, 0] * along_x + corners[index, 1] * along_y)
    return largest


@inner_kernel
def _reach(corners: Floats, count: int) -> float:
    """Tell how far the farthest corner is [m]."""
    largest = 0.0
    for index in range(count):
        largest = max(largest, corners[index, 0] * corners[index, 0] + corners[index, 1] * corners[index, 1])
    return float(np.sqrt(largest))


@inner_kernel
def _cut(outline: Outline, count: int, along_x: float, along_y: float, limit: float) -> int:
    """Keep the part of a polygon where the scalar product with a direction is within a limit; give its corners."""
    corners, spare = outline.corners, outline.spare
    kept = 0
    last_x, last_y = corners[count - 1, 0], corners[count - 1, 1]
    last = last_x * along_x + last_y * along_y - limit
    for index in range(count):
        next_x, next_y = corners[index, 0], corners[index, 1]
        excess = next_x * along_x + next_y * along_y - limit
        if (excess > 0.0) != (last > 0.0):
            share = last / (last - excess)
            spare[kept, 0], spare[kept, 1] = last_x + (next_x - last_x) * share, last_y + (next_y - last_y) * share
            kept += 1
        if excess <= 0.0:
            spare[kept, 0], spare[kept, 1] = next_x, next_y
            kept += 1
        last_x, last_y, last = next_x, next_y, excess
    for index in range(kept):
        corners[index, 0], corners[index, 1] = spare[index, 0], spare[index, 1]
    return kept
