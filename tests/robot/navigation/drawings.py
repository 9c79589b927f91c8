"""Small floors for searches, drawn in characters, and shortest lengths on them computed independently."""

from __future__ import annotations

import math
from typing import List, Tuple

import numpy as np
from hypothesis import strategies as st
from scipy.sparse import csr_matrix
from scipy.sparse.csgraph import dijkstra

__all__ = ["DRAWINGS", "cells", "oracle"]

DRAWINGS = st.integers(1, 9).flatmap(
    lambda columns: st.lists(st.text("..#", min_size=columns, max_size=columns), min_size=1, max_size=9)
)


def cells(drawing: List[str]) -> Tuple[bytes, int]:
    """Put a ring of blocked cells around a drawing in which # is blocked."""
    width = len(drawing[0]) + 2
    rows = ["#" * width, *(f"#{row}#" for row in drawing), "#" * width]
    return bytes(cell == "#" for cell in "".join(rows)), width


def oracle(blocked: bytes, width: int) -> np.ndarray:
    """Compute all shortest lengths between free cells from the rule's own words."""
    free = {divmod(cell, width): cell for cell, taken in enumerate(blocked) if not taken}
    edges = [
        (cell, free[row + down, column + right], math.hypot(down, right))
        for (row, column), cell in free.items()
        for down in (-1, 0, 1)
        for right in (-1, 0, 1)
        if (down or right) and {(row + down, column + right), (row + down, column), (row, column + right)} <= set(free)
    ]
    shape = (len(blocked), len(blocked))
    if not edges:
        lengths = np.full(shape, np.inf)
        np.fill_diagonal(lengths, 0.0)
        return lengths
    first, second, length = zip(*edges)
    return dijkstra(csr_matrix((length, (first, second)), shape=shape))
