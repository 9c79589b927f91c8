from __future__ import annotations

from itertools import accumulate
from typing import List, Tuple

from hypothesis import given
from hypothesis import strategies as st

from rqt_mrta_py.render.report.thinning import corners

STEPS = st.lists(st.tuples(st.sampled_from((0.0, 0.1, 1.0, 7.0)), st.floats(-100, 100), st.floats(-100, 100)))


def test_a_straight_line_needs_its_ends_only() -> None:
    assert corners([0.0, 1.0, 2.0, 3.0], ([0.0, 2.0, 4.0, 6.0],), (0.01,)) == [0, 3]


def test_a_corner_stays() -> None:
    assert corners([0.0, 1.0, 2.0, 3.0, 4.0], ([0.0, 0.0, 0.0, 5.0, 10.0],), (0.01,)) == [0, 2, 4]


def test_both_sides_of_a_step_at_one_moment_stay() -> None:
    assert corners([0.0, 1.0, 1.0, 2.0], ([0.0, 0.0, 1.0, 1.0],), (0.01,)) == [0, 1, 2, 3]


def test_one_column_that_bends_is_enough() -> None:
    assert corners([0.0, 1.0, 2.0], ([0.0, 0.0, 0.0], [0.0, 9.0, 0.0]), (0.5, 0.5)) == [0, 1, 2]


def test_few_points_all_stay() -> None:
    assert [corners([float(n) for n in range(count)], ([1.0] * count,), (1.0,)) for count in range(3)] == [
        [],
        [0],
        [0, 1],
    ]


@given(STEPS)
def test_no_point_is_farther_from_the_lines_than_the_tolerance(steps: List[Tuple[float, float, float]]) -> None:
    times = list(accumulate(step[0] for step in steps))
    columns = ([step[1] for step in steps], [step[2] for step in steps])
    chosen = corners(times, columns, (5.0, 20.0))
    assert chosen[:1] == [0][: len(steps)]
    assert chosen[-1:] == [len(steps) - 1][: len(steps)]
    for before, after in zip(chosen, chosen[1:]):
        assert before < after
        for at in range(before + 1, after):
            share = (times[at] - times[before]) / (times[after] - times[before])
            for column, tolerance in zip(columns, (5.0, 20.0)):
                line = column[before] + share * (column[after] - column[before])
                assert abs(line - column[at]) <= tolerance * (1 + 1e-9) + 1e-9


@given(STEPS)
def test_one_column_has_the_corners_of_two_that_are_alike(steps: List[Tuple[float, float, float]]) -> None:
    times, column = list(accumulate(step[0] for step in steps)), [step[1] for step in steps]
    assert corners(times, (column,), (5.0,)) == corners(times, (column, column), (5.0, 5.0))
