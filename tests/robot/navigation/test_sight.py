from __future__ import annotations

import math
from typing import List, Tuple

import pytest
from hypothesis import assume, given
from hypothesis import strategies as st

from rqt_mrta_py.robot.navigation.sight import pull_straight, sees

WIDTH = 10
WALLED = [[row in (0, 9) or column in (0, 9) for column in range(10)] for row in range(10)]


def room(*blocked: Tuple[int, int]) -> bytes:
    """Make a 10 x 10 room with a ring, and cells (column, row) blocked in it."""
    return bytes(WALLED[row][column] or (column, row) in blocked for row in range(10) for column in range(10))


@pytest.mark.parametrize(
    ("start", "end", "expected"),
    [
        ((1.5, 1.5), (8.5, 1.5), True),
        ((1.5, 5.5), (8.5, 5.5), False),
        ((8.5, 5.5), (1.5, 5.5), False),
        # From (1.5, 3.5) with slope 1/4 the line is at row 4.25 in column 4.5, just above the block at row 5.
        ((1.5, 3.5), (7.5, 5.0), True),
        ((5.5, 1.5), (5.5, 8.5), False),
        # Through the corner (5, 6) of the block (5, 5): it touches the block.
        ((4.0, 5.0), (6.0, 7.0), False),
        ((4.0, 5.2), (5.6, 6.8), True),
        ((2.5, 2.5), (2.5, 2.5), True),
        ((5.5, 5.5), (5.5, 5.5), False),
    ],
)
def test_sees_only_over_free_cells(start: Tuple[float, float], end: Tuple[float, float], expected: bool) -> None:
    assert sees(room((5, 5)), WIDTH, start, end) is expected


POINTS = st.tuples(st.floats(1.0, 8.999), st.floats(1.0, 8.999))
BLOCKS = st.lists(st.tuples(st.integers(1, 8), st.integers(1, 8)), max_size=12)


@given(BLOCKS, POINTS, POINTS)
def test_sees_agrees_with_walking_the_line_in_small_steps(
    blocks: List[Tuple[int, int]], start: Tuple[float, float], end: Tuple[float, float]
) -> None:
    walked = set()
    for step in range(2001):
        part = step / 2000
        x, y = start[0] + part * (end[0] - start[0]), start[1] + part * (end[1] - start[1])
        # A walk in steps may jump a cell whose corner is barely cut; leave such lines out.
        assume(abs(x - round(x)) > 0.006 or abs(y - round(y)) > 0.006)
        walked.add((math.floor(x), math.floor(y)))
    assert sees(room(*blocks), WIDTH, start, end) is not bool(walked & set(blocks))


def test_pull_straight_keeps_the_bends_only() -> None:
    points = [(2.5, 3.5), (2.5, 2.5), (3.5, 2.5), (4.5, 2.5), (5.5, 2.5), (5.5, 3.5)]
    assert pull_straight(room(), WIDTH, points) == [points[0], points[-1]]
    # With (3, 3) and (4, 3) blocked: the first point sees only the second, for the line to the third touches a
    # corner; the second sees the fifth, for the line to the last enters row 3 at x = 4.
    assert pull_straight(room((3, 3), (4, 3)), WIDTH, points) == [points[0], points[1], points[4], points[5]]


def test_pull_straight_leaves_a_single_step_alone() -> None:
    assert pull_straight(room(), WIDTH, [(1.5, 1.5), (1.7, 1.5)]) == [(1.5, 1.5), (1.7, 1.5)]
