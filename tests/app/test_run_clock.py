from __future__ import annotations

import pytest

from rqt_mrta_py.app.run.clock import RunClock


@pytest.mark.parametrize(
    ("seconds", "rate", "tick"),
    [(180.0, 20, 3600), (1.1, 20, 22), (0.7, 10, 7), (1.01, 20, 21), (1 / 3, 3, 1)],
)
def test_a_duration_ends_at_its_tick_or_the_next_after_it(seconds: float, rate: int, tick: int) -> None:
    """1.1 x 20 is a little above 22 in floating point, which is no reason for a 23rd tick."""
    assert RunClock(rate).ticks(seconds) == tick


def test_mission_second_s_carries_stamp_s_plus_one() -> None:
    clock = RunClock(3)
    assert clock.stamp_ns(0) == 1_000_000_000
    assert clock.stamp_ns(1) == 1_333_333_333
    assert clock.stamp_ns(3) == 2_000_000_000
    assert clock.stamp(180 * 3) == 181.0
