"""Statistics of the experiments, against published tables and numbers worked out by hand."""

from __future__ import annotations

import math
from typing import Optional

import pytest
from team_measures.statistics.estimates import Estimate, estimated_mean, estimated_share
from team_measures.statistics.quantiles import quantile
from team_measures.statistics.student import inner_probability, two_sided_quantile
from team_measures.statistics.tables import rounded


@pytest.mark.parametrize(
    ("freedom", "t"),
    [(1, 12.706), (2, 4.303), (3, 3.182), (4, 2.776), (9, 2.262), (10, 2.228), (30, 2.042), (49, 2.010), (120, 1.980)],
)
def test_student_s_quantiles_are_those_of_the_printed_tables(freedom: int, t: float) -> None:
    assert two_sided_quantile(0.95, freedom) == pytest.approx(t, abs=5e-4)


def test_student_s_distribution_of_one_and_two_degrees_has_closed_forms() -> None:
    # One: 2/pi atan(t), so 1/2 at t = 1. Two: t / sqrt(2 + t^2), so 1/sqrt(3) at t = 1.
    assert inner_probability(1.0, 1) == pytest.approx(0.5)
    assert inner_probability(1.0, 2) == pytest.approx(1 / math.sqrt(3))
    assert inner_probability(0.0, 7) == 0.0


def test_a_mean_s_interval_is_t_standard_errors_to_either_side() -> None:
    # Mean 5, squared deviations 9 + 1 + 1 + 9 = 20, s = sqrt(20 / 3), s / 2 = 1.29099; t of 3 degrees is 3.18245.
    found = estimated_mean([2.0, 4.0, 6.0, 8.0])

    assert found is not None
    assert found.value == 5.0
    assert found.high - 5.0 == pytest.approx(3.18245 * 1.29099, abs=1e-4)
    assert 5.0 - found.low == pytest.approx(found.high - 5.0)
    assert found.number == 4


def test_a_sample_of_one_has_no_width_and_an_empty_one_no_mean() -> None:
    assert estimated_mean([3.0]) == Estimate(3.0, 3.0, 3.0, 1)
    assert estimated_mean([]) is None


def test_where_something_always_happened_it_is_still_not_certain() -> None:
    # Wilson for n of n: low = n / (n + z^2), which is 50 / 53.8415.
    found = estimated_share(50, 50)

    assert found is not None
    assert (found.value, found.high) == (1.0, 1.0)
    assert found.low == pytest.approx(50 / (50 + 1.959964**2), abs=1e-6)


def test_a_share_s_interval_is_wilson_s() -> None:
    # 5 of 10: centre 1/2; half z / (1 + z^2/n) * sqrt(1/4n + z^2/4n^2) = 1.41612 * sqrt(0.025 + 0.0096036).
    found = estimated_share(5, 10)

    assert found is not None
    assert found.low == pytest.approx(0.5 - 1.959964 / 1.384146 * math.sqrt(0.0346036), abs=1e-5)
    assert found.low + found.high == pytest.approx(1.0)
    assert estimated_share(0, 0) is None


@pytest.mark.parametrize(("share", "value"), [(0.0, 1.0), (0.25, 3.0), (0.5, 4.0), (0.9, 8.4), (1.0, 10.0)])
def test_a_quantile_lies_on_the_straight_line_between_neighbours(share: float, value: float) -> None:
    # 1, 3, 4, 6, 10 stand at places 0 to 4; a share of 0.9 is place 3.6, so 6 + 0.6 x 4.
    assert quantile([10.0, 1.0, 4.0, 6.0, 3.0], share) == pytest.approx(value)


def test_an_empty_sample_has_no_quantile() -> None:
    assert quantile([], 0.5) is None


@pytest.mark.parametrize(("value", "shown"), [(None, "None"), (-0.0004, "0.0"), (0.0, "0.0"), (-1.0049, "-1.0")])
def test_what_rounds_to_nothing_has_no_sign(value: Optional[float], shown: str) -> None:
    assert str(rounded(value)) == shown
