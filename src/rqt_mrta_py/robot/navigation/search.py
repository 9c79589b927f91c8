"""Shortest ways over the free cells of a flat grid with a blocked ring (see ``grid``).

A step goes to one of eight neighbours; a straight one costs 1, a diagonal one sqrt(2), and a diagonal step needs
both cells beside it free (no corner is cut). Ties are broken by the cell's number, so that equal grids give equal
ways.
"""

from __future__ import annotations

import heapq
import math
from typing import Dict, List, Optional, Tuple

__all__ = ["shortest_way", "steps_in_cells"]

_DIAGONAL = math.sqrt(2.0)


def shortest_way(blocked: bytes, width: int, start: int, goal: int) -> Optional[List[int]]:
    """Find a shortest way between two free cells by A* with the octile distance.

    Args:
        blocked: one byte a cell, row by row; anything but 0 blocks.
        width: cells in a row.
        start: a free cell.
        goal: a free cell.

    Returns:
        Cells from start to goal, both included; None if there is no way.
    """
    goal_row, goal_column = divmod(goal, width)
    spread = _DIAGONAL - 2.0

    def estimate(cell: int) -> float:
        rows = abs(cell // width - goal_row)
        columns = abs(cell % width - goal_column)
        # The octile distance: as many diagonal steps as the shorter leg has cells.
        return rows + columns + spread * (rows if rows < columns else columns)

    travelled: Dict[int, float] = {start: 0.0}
    came_from: Dict[int, int] = {}
    closed = bytearray(len(blocked))
    open_cells: List[Tuple[float, int]] = [(estimate(start), start)]
    neighbours = steps_in_cells(width)
    pop, push, infinity = heapq.heappop, heapq.heappush, math.inf
    while open_cells:
        cell = pop(open_cells)[1]
        if cell == goal:
            return _unwind(came_from, goal)
        if closed[cell]:
            continue
        closed[cell] = 1
        here = travelled[cell]
        for offset, beside_one, beside_other, step in neighbours:
            neighbour = cell + offset
            if blocked[neighbour] or closed[neighbour] or blocked[cell + beside_one] or blocked[cell + beside_other]:
                continue
            there = here + step
            if there < travelled.get(neighbour, infinity):
                travelled[neighbour] = there
                came_from[neighbour] = cell
                push(open_cells, (there + estimate(neighbour), neighbour))
    return None


def steps_in_cells(width: int) -> Tuple[Tuple[int, int, int, float], ...]:
    """List each step: its offset, the offsets of the cells beside it (of a straight one itself), its cost."""
    straight = tuple((offset, offset, offset, 1.0) for offset in (1, width, -1, -width))
    diagonal = tuple((along + across, along, across, _DIAGONAL) for along in (1, -1) for across in (width, -width))
    return straight + diagonal


def _unwind(came_from: Dict[int, int], goal: int) -> List[int]:
    way = [goal]
    while way[-1] in came_from:
        way.append(came_from[way[-1]])
    way.reverse()
    return way
