from __future__ import annotations

from typing import List, Tuple

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from rqt_mrta_py.supervisor.clocks.estimate import median_deviation, promptest, quantile, robust_line


def line_of(points: List[Tuple[float, float]], origin: float = 0.0) -> Tuple[float, float]:
    places, values = np.array(points, np.float64).T
    line = robust_line(places, values, origin)
    return line.value, line.slope


def test_a_line_through_points_of_one_line_is_that_line() -> None:
    assert line_of([(0.0, 1.0), (1.0, 3.0), (3.0, 7.0)], origin=2.0) == (5.0, 2.0)


def test_one_point_in_four_may_be_anywhere() -> None:
    # Slopes by hand: three of 1, and 97, 48.5 and 97/3 to the point that is off; their median is (1 + 97/3) / 2 = 50/3.
    value, slope = line_of([(0.0, 0.0), (1.0, 1.0), (2.0, 2.0), (3.0, 97.0)])
    assert slope == pytest.approx((1.0 + 97.0 / 3.0) / 2.0)
    # With two more on the line ten of fifteen slopes are 1.
    assert line_of([(0.0, 0.0), (1.0, 1.0), (2.0, 2.0), (3.0, 97.0), (4.0, 4.0), (5.0, 5.0)]) == (0.0, 1.0)
    assert value < 0.0


def test_a_line_is_level_where_there_is_one_place() -> None:
    assert line_of([(1.0, 4.0)]) == (4.0, 0.0)
    assert line_of([(1.0, 4.0), (1.0, 8.0), (1.0, 5.0)]) == (5.0, 0.0)


def test_a_line_tells_its_values() -> None:
    line = robust_line(np.array([0.0, 2.0]), np.array([1.0, 2.0]), 0.0)
    assert list(line.at(np.array([0.0, 4.0]))) == [1.0, 3.0]


@settings(deadline=None)
@given(
    st.floats(-100.0, 100.0),
    st.floats(-1.0, 1.0),
    st.lists(st.integers(0, 1000), min_size=8, max_size=40, unique=True),
    st.floats(-1e6, 1e6),
)
def test_a_quarter_of_odd_points_moves_no_line(value: float, slope: float, places: List[int], odd: float) -> None:
    points = [(float(place), value + slope * place) for place in places]
    for index in range(len(points) // 8):
        points[index] = (points[index][0], odd)
    found_value, found_slope = line_of(points)
    assert found_slope == pytest.approx(slope, abs=1e-6)
    assert found_value == pytest.approx(value, abs=1e-3)


def test_the_promptest_of_each_window_is_found() -> None:
    windows, leads = np.array([1, 0, 1, 0, 2]), np.array([-5, -3, -2, -3, -9])
    assert list(promptest(windows, leads)) == [1, 2, 4]


@pytest.mark.parametrize(("share", "value"), [(0.01, 1), (0.25, 1), (0.26, 2), (0.5, 2), (0.95, 4), (1.0, 4)])
def test_quantiles_are_values_that_occur(share: float, value: int) -> None:
    assert quantile(np.array([4, 2, 1, 3]), share) == value


def test_the_deviation_is_the_middle_one() -> None:
    # Median 3; they differ by 2, 1, 0, 1 and 97.
    assert median_deviation(np.array([1.0, 2.0, 3.0, 4.0, 100.0])) == 1.0
