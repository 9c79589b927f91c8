from __future__ import annotations

import math

import pytest
from hypothesis import given
from hypothesis import strategies as st

from rqt_mrta_py.sim.schedule import Schedule, first_tick_at


def due(rate, control_rate, ticks):
    schedule = Schedule(rate, control_rate)
    return [tick for tick in range(ticks) if schedule.is_due(tick)]


def test_schedule_of_half_the_control_rate_is_due_every_other_tick():
    assert due(10.0, 20, 9) == [0, 2, 4, 6, 8]


def test_schedule_of_the_control_rate_is_due_every_tick():
    assert due(20.0, 20, 4) == [0, 1, 2, 3]


def test_schedule_spreads_a_rate_that_does_not_divide_as_evenly_as_ticks_allow():
    assert due(8.0, 20, 21) == [0, 3, 5, 8, 10, 13, 15, 18, 20]


def test_schedule_takes_rates_below_one_and_fractions():
    assert due(0.5, 20, 100) == [0, 40, 80]
    assert due(2.5, 20, 30) == [0, 8, 16, 24]
    assert due(1.0 / 3.0, 3, 20) == [0, 9, 18]


@given(st.integers(1, 120), st.floats(0.01, 1.0), st.integers(1, 3000))
def test_schedule_keeps_its_rate_without_drift(control_rate, share, ticks):
    rate = max(0.01, share * control_rate)
    moments = due(rate, control_rate, ticks)
    assert abs(len(moments) - ticks * rate / control_rate) <= 1.0 + ticks / control_rate * 1e-6
    gaps = {later - earlier for earlier, later in zip(moments, moments[1:])}
    assert not gaps or max(gaps) - min(gaps) <= 1


def test_schedule_of_less_than_once_in_a_mission_is_due_at_first():
    """A rate below a millionth of one was never due."""
    assert due(1e-9, 20, 3000) == [0]


@pytest.mark.parametrize("rate", [0.0, -1.0, 20.5, math.nan, math.inf])
def test_schedule_refuses_a_rate_that_ticks_cannot_keep(rate):
    with pytest.raises(ValueError, match=r"rate must be above 0, at most the control rate of 20 Hz \(got"):
        Schedule(rate, 20)


@pytest.mark.parametrize(
    ("time", "control_rate", "tick"),
    [(0.0, 20, 0), (0.01, 20, 1), (0.05, 20, 1), (0.051, 20, 2), (60.0, 20, 1200), (1.1, 20, 22), (0.7, 10, 7)],
)
def test_first_tick_at_a_time_is_on_it_or_the_next_after_it(time, control_rate, tick):
    """1.1 * 20 is a little more than 22 in floats; the event still belongs to tick 22."""
    assert first_tick_at(time, control_rate) == tick


@given(st.integers(0, 10**7), st.integers(1, 120))
def test_first_tick_at_the_time_of_a_tick_is_that_tick(tick, control_rate):
    assert first_tick_at(tick / control_rate, control_rate) == tick
