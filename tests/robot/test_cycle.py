from __future__ import annotations

import math
from fractions import Fraction
from typing import List

import pytest
from hypothesis import given
from hypothesis import strategies as st

from rqt_mrta_py.robot.cycle import Cycle


def steps(cycle: Cycle, last: int) -> List[int]:
    """Give the ticks up to the last on which steps fall."""
    ticks = [cycle.after(-1)]
    while ticks[-1] <= last:
        ticks.append(cycle.after(ticks[-1]))
    return ticks[:-1]


@pytest.mark.parametrize(
    ("rate", "control_rate", "ticks"),
    [
        (10.0, 20, [0, 2, 4, 6, 8]),
        # k * 20 / 7.5 = 0, 2.67, 5.33, 8, 10.67
        (7.5, 20, [0, 3, 6, 8]),
        # k * 20 / 3 = 0, 6.67
        (3.0, 20, [0, 7]),
        (20.0, 20, list(range(10))),
        (50.0, 20, list(range(10))),
    ],
)
def test_cycle_steps_at_the_tick_that_reaches_a_step(rate: float, control_rate: int, ticks: List[int]) -> None:
    assert steps(Cycle(rate, control_rate), 9) == ticks


def test_cycle_takes_a_tenth_of_a_hertz_for_exactly_that() -> None:
    # 0.1 is no binary fraction.
    assert steps(Cycle(0.1, 20), 2000) == list(range(0, 2001, 200))


def test_cycle_goes_on_after_skipped_ticks_where_it_would_have_been() -> None:
    cycle = Cycle(10.0, 20)
    assert [cycle.after(tick) for tick in (0, 1, 101, 102)] == [2, 2, 102, 104]


@given(st.fractions(min_value=Fraction(1, 50), max_value=40, max_denominator=50), st.integers(1, 40))
def test_cycle_follows_the_ceiling_formula(rate: Fraction, control_rate: int) -> None:
    expected = {math.ceil(k * control_rate / rate) for k in range(200)} if rate < control_rate else set(range(60))
    assert steps(Cycle(float(rate), control_rate), 59) == sorted(tick for tick in expected if tick < 60)


@pytest.mark.parametrize("rate", [0.0, -1.0, math.nan, math.inf])
def test_cycle_refuses_a_rate_that_is_none(rate: float) -> None:
    with pytest.raises(ValueError, match=r"a rate of .* Hz; it must be a finite number above 0"):
        Cycle(rate, 20)


def test_cycle_refuses_a_control_rate_that_is_none() -> None:
    with pytest.raises(ValueError, match="a control rate of 0 Hz; it must be above 0"):
        Cycle(1.0, 0)
