"""Ways over cells, held against scipy's Dijkstra on a graph that is built independently."""

from __future__ import annotations

import math
from typing import List

import pytest
from hypothesis import given
from hypothesis import strategies as st

from rqt_mrta_py.robot.navigation.search import shortest_way
from tests.robot.navigation.drawings import DRAWINGS, cells, oracle


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
