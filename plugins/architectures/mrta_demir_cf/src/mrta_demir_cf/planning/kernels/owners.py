"""Which robots have an open target in their Voronoi cells, found target by target: soon where few are open."""

from __future__ import annotations

import numpy as np

from mrta_demir_cf.planning.arrays import Mask
from mrta_demir_cf.planning.compiled import inner_kernel
from mrta_demir_cf.planning.kernels.decisions import Field
from mrta_demir_cf.planning.kernels.grids import border_of_ring, cell_along
from mrta_demir_cf.planning.kernels.ways import place_on_way

__all__ = ["mark_owners"]


@inner_kernel
def mark_owners(now: float, drift: float, field: Field, owning: Mask) -> None:
    """Say of each robot whether an open target is its own by Eq. 1.

    Args:
        now: the moment [s].
        drift: how far robots may have moved since they were sorted [m].
        field: robots and open targets.
        owning: (M,), written to.
    """
    for robot in range(len(owning)):
        owning[robot] = False
    for cell in range(len(field.targets.ends)):
        for position in range(field.targets.first[cell], field.targets.ends[cell]):
            target = field.targets.members[position]
            owning[_owner_of(field.places[target, 0], field.places[target, 1], now, drift, field)] = True


@inner_kernel
def _owner_of(x: float, y: float, now: float, drift: float, field: Field) -> int:
    """Give the robot nearest to a place, of equally near ones the first."""
    robots = field.robots
    column, row = cell_along(x, robots.low[0], robots), cell_along(y, robots.low[1], robots)
    owner, least, ring, reach = 0, np.inf, 0, np.inf
    while ring < robots.side and border_of_ring(x, y, ring, robots) - drift <= reach:
        for across in range(max(row - ring, 0), min(row + ring, robots.side - 1) + 1):
            step = 1 if abs(across - row) == ring else 2 * ring
            for along in range(column - ring, column + ring + 1, step):
                if along < 0 or along >= robots.side:
                    continue
                cell = across * robots.side + along
                for position in range(robots.first[cell], robots.ends[cell]):
                    robot = robots.members[position]
                    there_x, there_y = place_on_way(field.ways, robot, now)
                    along_x, along_y = x - there_x, y - there_y
                    square = along_x * along_x + along_y * along_y
                    if square < least or (square == least and robot < owner):
                        owner, least = robot, square
        ring += 1
        reach = np.sqrt(least) + 1e-9 * robots.width * robots.side
    return owner
