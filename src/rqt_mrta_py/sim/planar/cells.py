"""What is near what: points in square cells, and how to lay out lists of unequal lengths one after the other."""

from __future__ import annotations

from typing import Tuple

import numpy as np
from numpy.typing import NDArray

__all__ = ["Cells", "Floats", "Rows", "laid_out"]

Floats = NDArray[np.float64]
Rows = NDArray[np.intp]

_POINTS_A_CELL = 2.0
_MOST_CELLS_A_SIDE = 256
_LEAST_CELL = 1e-3


class Cells:
    """An index of points in the plane, each in one square cell; the size of the cells follows from the points.

    Args:
        x, y: the points, all finite [m], shape (points,).
    """

    def __init__(self, x: Floats, y: Floats) -> None:
        self._points = x.size
        if not self._points:
            return
        self._low_x, self._low_y = float(x.min()), float(y.min())
        span_x, span_y = float(x.max()) - self._low_x, float(y.max()) - self._low_y
        roomy = (span_x * span_y * _POINTS_A_CELL / self._points) ** 0.5
        self._cell = max(roomy, span_x / _MOST_CELLS_A_SIDE, span_y / _MOST_CELLS_A_SIDE, _LEAST_CELL)
        self._columns = int(span_x / self._cell) + 1
        self._lines = int(span_y / self._cell) + 1
        cell = self._column(x) * self._lines + self._line(y)
        self._order: Rows = np.argsort(cell, kind="stable")
        self._begins: Rows = np.concatenate(([0], np.cumsum(np.bincount(cell, minlength=self._columns * self._lines))))

    def near(self, x: Floats, y: Floats, reach: float) -> Tuple[Rows, Rows]:
        """Find the points that may lie within reach of others; some that it gives do not.

        Args:
            x: around which to look, all finite [m], shape (queries,).
            y: the same.
            reach: how far [m].

        Returns:
            Pairs as rows of queries and rows of points, each pair once, by query.
        """
        if not self._points or not x.size:
            return np.empty(0, dtype=np.intp), np.empty(0, dtype=np.intp)
        first_column, last_column = self._column(x - reach), self._column(x + reach)
        first_line, last_line = self._line(y - reach), self._line(y + reach)
        # The lines of one column lie one after the other, so a query takes one stretch from each column.
        query, column = laid_out(last_column - first_column + 1)
        base = (first_column[query] + column) * self._lines
        begins = self._begins[base + first_line[query]]
        stretch, place = laid_out(self._begins[base + last_line[query] + 1] - begins)
        return query[stretch], self._order[begins[stretch] + place]

    def _column(self, x: Floats) -> Rows:
        return _whole((x - self._low_x) / self._cell, self._columns)

    def _line(self, y: Floats) -> Rows:
        return _whole((y - self._low_y) / self._cell, self._lines)


def laid_out(counts: Rows) -> Tuple[Rows, Rows]:
    """Lay lists of unequal lengths out one after the other.

    Args:
        counts: their lengths, shape (lists,).

    Returns:
        Of each element its list and its place there: for 2, 0, 3 give 0, 0, 2, 2, 2 and 0, 1, 0, 1, 2.
    """
    ends = np.cumsum(counts)
    total = int(ends[-1]) if ends.size else 0
    # As repeating the numbers of the lists would give, in half the time.
    lists = np.cumsum(np.bincount(ends[:-1], minlength=total)[:total])
    return lists, np.arange(total) - (ends - counts)[lists]


def _whole(numbers: Floats, count: int) -> Rows:
    """Round down to whole numbers from 0 to below a count."""
    rows: Rows = np.clip(numbers, 0, count - 1).astype(np.intp)
    return rows
