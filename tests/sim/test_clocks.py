from __future__ import annotations

import pytest
from hypothesis import given
from hypothesis import strategies as st

from rqt_mrta_py.sim.clocks import RobotClock


def test_clock_is_right_at_first():
    assert RobotClock().offset(1.0) == 0.0
    assert RobotClock().offset(1e6) == 0.0


def test_clock_set_forward_jumps():
    clock = RobotClock()
    clock.shift(2.0, 10.0)
    assert [clock.offset(now) for now in (10.0, 50.0)] == [2.0, 2.0]


def test_clock_set_back_runs_at_half_speed_until_it_is_right():
    clock = RobotClock()
    clock.shift(-2.0, 10.0)
    # It shows 10 at 10, 11 at 12, 12 at 14 and is there.
    assert [now + clock.offset(now) for now in (10.0, 12.0, 14.0, 15.0)] == [10.0, 11.0, 12.0, 13.0]


def test_clock_set_right_while_it_still_runs_slowly_jumps_forward():
    clock = RobotClock()
    clock.shift(-4.0, 10.0)
    clock.shift(0.0, 12.0)
    assert clock.offset(12.0) == 0.0


def test_clock_that_was_ahead_is_set_right_slowly():
    clock = RobotClock()
    clock.shift(3.0, 10.0)
    clock.shift(0.0, 20.0)
    assert [clock.offset(now) for now in (20.0, 22.0, 26.0, 30.0)] == [3.0, 2.0, 0.0, 0.0]


@pytest.mark.parametrize("rate", [1, 20, 1000])
@given(shifts=st.lists(st.tuples(st.integers(0, 60), st.floats(-1e6, 1e6)), max_size=6))
def test_clock_never_stands_nor_runs_backwards(rate, shifts):
    """It runs at half speed at least, whatever it is set to; and shows what it was set to in the end."""
    clock = RobotClock()
    shifts = sorted(shifts, key=lambda shift: shift[0])
    pending = iter([*shifts, (10**9, 0.0)])
    when, offset = next(pending)
    shown = None
    for tick in range(61):
        now = 1.0 + tick / rate
        while when == tick:
            clock.shift(offset, now)
            when, offset = next(pending)
        reading = now + clock.offset(now)
        if shown is not None:
            assert reading - shown >= 0.5 / rate - 1e-9
        shown = reading
    assert clock.offset(1e8) == (shifts[-1][1] if shifts else 0.0)
