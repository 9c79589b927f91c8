from __future__ import annotations

import math

import numpy as np
from hypothesis import example, given
from hypothesis import strategies as st
from hypothesis.extra.numpy import arrays

from rqt_mrta_py.sim.planar.cells import Cells, laid_out

places = st.floats(-50.0, 50.0)
points = st.integers(0, 12).flatmap(lambda count: arrays(np.float64, (2, count), elements=places))


@given(points, points, st.floats(0.0, 120.0))
@example(np.zeros((2, 3)), np.zeros((2, 1)), 0.1)
@example(np.array([[0.0, 1e-12], [0.0, 0.0]]), np.array([[0.0], [0.0]]), 1e-6)
def test_near_gives_every_pair_within_reach_once_by_query(indexed, asked, reach):
    query, point = Cells(*indexed).near(*asked, reach)
    pairs = list(zip(query.tolist(), point.tolist()))
    assert len(pairs) == len(set(pairs))
    assert query.tolist() == sorted(query.tolist())
    within = {
        (i, j)
        for i, (x, y) in enumerate(asked.T)
        for j, (u, v) in enumerate(indexed.T)
        if math.hypot(x - u, y - v) < reach - 1e-9
    }
    assert within <= set(pairs)


def test_near_leaves_out_what_is_far():
    x, y = (axis.ravel().astype(np.float64) for axis in np.meshgrid(np.arange(40), np.arange(40)))
    query, _ = Cells(x, y).near(np.array([20.0]), np.array([20.0]), 2.0)
    assert query.size < 80


def test_near_reaches_any_distance():
    x = np.array([0.0, 1.0])
    query, point = Cells(x, x).near(x, x, np.inf)
    assert list(zip(query, point)) == [(0, 0), (0, 1), (1, 0), (1, 1)]


def test_lists_of_unequal_lengths_are_laid_out_one_after_the_other():
    for counts, lists, places in (
        ([2, 0, 3], [0, 0, 2, 2, 2], [0, 1, 0, 1, 2]),
        ([0, 1, 0, 0], [1], [0]),
        ([0, 0], [], []),
        ([], [], []),
    ):
        laid = laid_out(np.array(counts, dtype=np.intp))
        assert [numbers.tolist() for numbers in laid] == [lists, places]
