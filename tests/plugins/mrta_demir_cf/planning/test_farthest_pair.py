"""The farthest pair, its rule for ties, and that the rim loses no pair."""

from __future__ import annotations

import math
from typing import List, Tuple

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from mrta_demir_cf.planning.farthest_pair import farthest_pair, farthest_pair_of_all, rim

Point = Tuple[int, int]


def last_of_all(points: List[Point]) -> Tuple[int, int]:
    """Go through all pairs in lexicographic order in exact arithmetic; an equal one replaces the one before."""
    best, pair = -1, (0, 1)
    for first in range(len(points)):
        for second in range(first + 1, len(points)):
            gap = (points[first][0] - points[second][0]) ** 2 + (points[first][1] - points[second][1]) ** 2
            if gap >= best:
                best, pair = gap, (first, second)
    return pair


def test_the_two_ends_of_a_line_are_the_farthest_pair() -> None:
    assert farthest_pair(np.array([[1.0, 0.0], [-2.0, 0.0], [6.0, 0.0]])) == (1, 2)


def test_of_both_diagonals_of_a_square_the_last_is_taken() -> None:
    # Diagonals (0, 2) and (1, 3), both of squared length 2.
    assert farthest_pair(np.array([[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]])) == (1, 3)


def test_points_that_all_coincide_give_the_last_pair() -> None:
    assert farthest_pair(np.full((4, 2), 7.0)) == (2, 3)
    assert farthest_pair(np.full((300, 2), 7.0)) == (298, 299)


def test_of_coincident_ends_the_last_are_taken() -> None:
    ends = [[0.0, 0.0], [9.0, 0.0], [0.0, 0.0], [9.0, 0.0]]
    assert farthest_pair(np.array(ends)) == (2, 3)
    inner = [[4.0, 0.5]] * 200
    assert farthest_pair(np.array([*ends, *inner])) == (2, 3)


@pytest.mark.parametrize("count", [65, 128, 129, 500])
def test_points_on_a_circle_are_all_on_the_rim(count: int) -> None:
    angles = 2.0 * math.pi * np.arange(count) / count
    circle = np.column_stack([np.cos(angles), np.sin(angles)])
    assert rim(circle).tolist() == list(range(count))
    assert farthest_pair(circle) == farthest_pair_of_all(circle)


def test_points_on_a_line_keep_their_ends() -> None:
    line = np.column_stack([np.arange(300.0), 3.0 * np.arange(300.0)])
    assert farthest_pair(line) == (0, 299)


def test_the_rim_of_many_points_is_short() -> None:
    points = np.random.default_rng(5).uniform(size=(5000, 2))
    assert len(rim(points)) < 60


@given(st.lists(st.tuples(st.integers(-9, 9), st.integers(-9, 9)), min_size=2, max_size=90))
@settings(max_examples=60, deadline=None)
def test_the_pair_is_that_of_exact_arithmetic(points: List[Point]) -> None:
    array = np.array(points, dtype=np.float64)
    assert farthest_pair(array) == farthest_pair_of_all(array) == last_of_all(points)


@given(st.integers(0, 2**32 - 1), st.integers(65, 400), st.sampled_from([0, 3, 1000]))
@settings(max_examples=40, deadline=None)
def test_the_rim_loses_no_pair(seed: int, count: int, side: int) -> None:
    generator = np.random.default_rng(seed)
    points = generator.uniform(size=(count, 2)) if not side else generator.integers(0, side, (count, 2)).astype(float)
    assert farthest_pair(points) == farthest_pair_of_all(points)
