"""One robot's decision among many: the open targets in its Voronoi cell and the cheapest of them."""

from __future__ import annotations

import numpy as np

from mrta_demir_cf.planning.arrays import Floats, Indices, Mask
from mrta_demir_cf.planning.compiled import kernel
from mrta_demir_cf.planning.kernels.pairs import farthest_of
from mrta_demir_cf.planning.kernels.sectors import SECTORS, WIDER, reach_in_sector, sector_of
from mrta_demir_cf.planning.target_grid import TargetGrid

__all__ = ["decide"]


@kernel
def decide(  # noqa: PLR0917 - numba knows no keyword-only arguments
    robot: int, places: Floats, targets: Floats, open: Mask, grid: TargetGrid, alpha: float
) -> int:
    """Select as ``selection.select`` does by Eq. 3 with ``alpha``, by Eq. 2 where ``alpha`` is 1.

    Returns:
        The index of the target; -1 if there is none.
    """
    squares = _squares_to(places, robot)
    bounds = _bounds(robot, places, squares, grid)
    reach = bounds.max()
    if reach < 0.0:
        return -1
    rivals = np.flatnonzero(squares <= (2.0 * reach * WIDER) ** 2)
    schedule = np.empty(8, dtype=np.intp)
    count = 0
    at_x, at_y = places[robot, 0], places[robot, 1]
    left, right = _cell(at_x - reach, grid.low[0], grid), _cell(at_x + reach, grid.low[0], grid)
    for row in range(_cell(at_y - reach, grid.low[1], grid), _cell(at_y + reach, grid.low[1], grid) + 1):
        for position in range(grid.first[row * grid.side + left], grid.first[row * grid.side + right + 1]):
            target = grid.members[position]
            if not open[target] or not _may_own(targets[target], places[robot], bounds, reach):
                continue
            if _owns(robot, targets[target], places, rivals):
                if count == len(schedule):
                    schedule = np.concatenate((schedule, schedule))
                schedule[count] = target
                count += 1
    if count == 0:
        return -1
    return _cheapest(places[robot], targets, np.sort(schedule[:count]), alpha)


@kernel
def _squares_to(places: Floats, robot: int) -> Floats:
    """Give the squares of the distances between a robot and all, (M,) [m^2]."""
    squares = np.empty(len(places))
    for other in range(len(places)):
        along_x, along_y = places[other, 0] - places[robot, 0], places[other, 1] - places[robot, 1]
        squares[other] = along_x * along_x + along_y * along_y
    return squares


@kernel
def _bounds(robot: int, places: Floats, squares: Floats, grid: TargetGrid) -> Floats:
    """Give how far the robot's Voronoi cell may reach in each sector, (6,) [m]; below 0 if another has it all."""
    bounds = np.full(SECTORS, np.inf)
    for other in range(len(places)):
        if squares[other] > 0.0:
            sector = sector_of(places[other, 0] - places[robot, 0], places[other, 1] - places[robot, 1])
            bounds[sector] = min(bounds[sector], squares[other])
        elif other < robot:
            return np.full(SECTORS, -1.0)
    for sector in range(SECTORS):
        if bounds[sector] == np.inf:
            bounds[sector] = reach_in_sector(sector, places[robot], grid.low, grid.high)
        else:
            bounds[sector] = np.sqrt(bounds[sector]) * WIDER
    return bounds


@kernel
def _may_own(target: Floats, place: Floats, bounds: Floats, reach: float) -> bool:
    """Tell whether a target lies within the bounds of the robot's Voronoi cell."""
    along_x, along_y = target[0] - place[0], target[1] - place[1]
    limit = bounds[sector_of(along_x, along_y)] + 1e-9 * reach
    return bool(along_x * along_x + along_y * along_y <= limit * limit)


@kernel
def _cell(coordinate: float, low: float, grid: TargetGrid) -> int:
    """Give the column or row of cells that holds a coordinate; the nearest one for what lies outside."""
    return int(min(max((coordinate - low) // grid.width, 0.0), grid.side - 1.0))


@kernel
def _owns(robot: int, target: Floats, places: Floats, rivals: Indices) -> bool:
    """Tell whether a robot is nearest to a target, of equally near ones the first (Eq. 1)."""
    along_x, along_y = target[0] - places[robot, 0], target[1] - places[robot, 1]
    own = along_x * along_x + along_y * along_y
    for rival in rivals:
        along_x, along_y = target[0] - places[rival, 0], target[1] - places[rival, 1]
        square = along_x * along_x + along_y * along_y
        if square < own or (square == own and rival < robot):
            return False
    return True


@kernel
def _cheapest(place: Floats, targets: Floats, schedule: Indices, alpha: float) -> int:
    """Give the cheapest target of a schedule by Eq. 3, the first of equals."""
    first = second = schedule[0]
    if alpha < 1.0 and len(schedule) > 1:
        first, second = farthest_of(targets, schedule, len(schedule))
    span = _distance(targets[first], targets[second])
    lowest, best = np.inf, -1
    for target in schedule:
        cost = _distance(place, targets[target])
        if alpha < 1.0:
            penalty = 0.0
            if len(schedule) > 1:
                farther = max(_distance(targets[first], targets[target]), _distance(targets[second], targets[target]))
                penalty = span - farther
            cost = alpha * cost + (1.0 - alpha) * penalty
        if cost < lowest:
            lowest, best = cost, target
    return best


@kernel
def _distance(start: Floats, end: Floats) -> float:
    along_x, along_y = end[0] - start[0], end[1] - start[1]
    return float(np.sqrt(along_x * along_x + along_y * along_y))
