"""Ways over cells, held against scipy's Dijkstra on a graph that is built independently."""

from __future__ import annotations

import math
from typing import List, Tuple

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from scipy.sparse import csr_matrix
from scipy.sparse.csgraph import dijkstra

from rqt_mrta_py.robot.navigation.search import distances, shortest_way

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


def length_of(way: List[int], blocked: bytes, width: int) -> float:
    """Add up a way's steps, each of which must be allowed."""
    total = 0.0
    for one, other in zip(way, way[1:]):
        (row, column), (next_row, next_column) = divmod(one, width), divmod(other, width)
        assert max(abs(next_row - row), abs(next_column - column)) == 1
        assert not blocked[other]
        assert not blocked[row * width + next_column]
        assert not blocked[next_row * width + column]
        total += math.hypot(next_row - row, next_column - column)
    return total


@given(DRAWINGS, st.data())
def test_shortest_way_is_as_short_as_the_oracle_says(drawing: List[str], data: st.DataObject) -> None:
    blocked, width = cells(drawing)
    free = [cell for cell, taken in enumerate(blocked) if not taken]
    if not free:
        return
    start, goal = data.draw(st.sampled_from(free)), data.draw(st.sampled_from(free))
    way = shortest_way(blocked, width, start, goal)
    expected = oracle(blocked, width)[start, goal]
    if way is None:
        assert math.isinf(expected)
    else:
        assert (way[0], way[-1]) == (start, goal)
        assert length_of(way, blocked, width) == pytest.approx(expected)


@given(DRAWINGS, st.data())
def test_distances_are_those_of_the_oracle(drawing: List[str], data: st.DataObject) -> None:
    blocked, width = cells(drawing)
    free = [cell for cell, taken in enumerate(blocked) if not taken]
    if not free:
        return
    goal = data.draw(st.sampled_from(free))
    assert distances(blocked, width, goal) == pytest.approx(list(oracle(blocked, width)[goal]))


def test_shortest_way_does_not_cut_corners() -> None:
    blocked, width = cells(["..", ".#"])
    # From the upper right to the lower left: 1 up, the diagonal is barred by the blocked corner.
    start, goal = width + 2, 2 * width + 1
    way = shortest_way(blocked, width, start, goal)
    assert way == [start, width + 1, goal]


def test_shortest_way_is_the_same_one_every_time() -> None:
    blocked, width = cells(["....."] * 5)
    ways = {tuple(shortest_way(blocked, width, width + 1, 4 * width + 3) or ()) for _ in range(3)}
    assert len(ways) == 1
