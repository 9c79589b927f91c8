"""Straight lines over the free cells of a grid, and ways pulled straight along them."""

from __future__ import annotations

import math
from typing import List, Sequence, Tuple

__all__ = ["pull_straight", "sees"]

Point = Tuple[float, float]

_CORNER = 1e-9


def sees(blocked: bytes, width: int, start: Point, end: Point) -> bool:
    """Tell whether every cell that a straight line touches is free.

    Args:
        blocked: one byte a cell, row by row, with a blocked ring; anything but 0 blocks.
        width: cells in a row.
        start: column and row of a point as fractions of cells: the cell (c, r) covers [c, c + 1) x [r, r + 1).
        end: of the other point.

    Returns:
        True if the line is free. A line through a corner touches the cells on both sides of it.
    """
    (x, y), (end_x, end_y) = start, end
    column, row = math.floor(x), math.floor(y)
    last_column, last_row = math.floor(end_x), math.floor(end_y)
    if blocked[row * width + column] or blocked[last_row * width + last_column]:
        return False
    dx, dy = end_x - x, end_y - y
    step_column = 1 if dx > 0.0 else -1
    step_row = 1 if dy > 0.0 else -1
    # Parameter along the line at the next column and row border, and between borders.
    per_column = 1.0 / abs(dx) if dx else math.inf
    per_row = 1.0 / abs(dy) if dy else math.inf
    next_column = (column + 1 - x if dx > 0.0 else x - column) * per_column if dx else math.inf
    next_row = (row + 1 - y if dy > 0.0 else y - row) * per_row if dy else math.inf
    while (column, row) != (last_column, last_row):
        beside_column, beside_row = row * width + column + step_column, (row + step_row) * width + column
        if abs(next_column - next_row) < _CORNER and (blocked[beside_column] or blocked[beside_row]):
            return False
        # Rounding must not carry the line past the last column or row.
        if row == last_row or (column != last_column and next_column < next_row):
            column += step_column
            next_column += per_column
        else:
            row += step_row
            next_row += per_row
        if blocked[row * width + column]:
            return False
    return True


def pull_straight(blocked: bytes, width: int, points: Sequence[Point]) -> List[Point]:
    """Leave out the points of a way that need not be passed, because a later one is in sight.

    Args:
        blocked: as for ``sees``.
        width: cells in a row.
        points: the way, as for ``sees``; neighbours among them are taken to see each other.

    Returns:
        The first point, those where the way bends, and the last.
    """
    kept = [points[0]]
    anchor = 0
    while anchor < len(points) - 1:
        following = anchor + 1
        while following < len(points) - 1 and sees(blocked, width, points[anchor], points[following + 1]):
            following += 1
        kept.append(points[following])
        anchor = following
    return kept
