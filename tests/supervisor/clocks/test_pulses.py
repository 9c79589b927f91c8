from __future__ import annotations

import math
from typing import Iterable

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from rqt_mrta_py.hooks import Heard
from rqt_mrta_py.supervisor.clocks.pulses import Pulse


def said(time: float) -> Heard:
    return Heard("/t", "", time, {})


def pulse_of(times: Iterable[float], timeout: float = 2.0) -> Pulse:
    pulse = Pulse("robot1", "/t", timeout)
    for time in times:
        pulse.hear(time, said(time))
    return pulse


def test_five_beats_make_a_pulse_that_is_missed_after_the_timeout() -> None:
    pulse = pulse_of([1.0, 1.5, 2.0, 2.5])
    assert pulse.due == math.inf
    assert pulse.hear(3.0, said(3.0))
    assert (pulse.period, pulse.due, pulse.last.receipt) == (0.5, 5.0, 3.0)


def test_a_slow_pulse_is_missed_after_three_periods() -> None:
    assert pulse_of([0.0, 10.0, 20.0, 30.0, 40.0]).due == 70.0


def test_topics_for_each_task_that_are_said_together_are_one_beat() -> None:
    times = [start + part for start in (0.0, 4.0, 8.0, 12.0, 16.0) for part in (0.0, 0.01, 0.02)]
    pulse = pulse_of(times)
    assert pulse.period == 4.0
    assert pulse.due == pytest.approx(28.02)


def test_a_gap_does_not_change_the_period() -> None:
    pulse = pulse_of([0.0, 0.5, 1.0, 1.5, 2.0])
    pulse.silent = True
    assert pulse.due == math.inf
    assert pulse.hear(62.0, said(62.0))
    pulse.silent = False
    assert not pulse.hear(62.5, said(62.5))
    assert (pulse.period, pulse.due) == (0.5, 64.5)


def test_a_robot_that_says_that_it_is_busy_need_not_say_that_it_is_idle() -> None:
    pulse = pulse_of([0.0, 0.5, 1.0, 1.5, 2.0])
    for time in (2.5, 3.5, 30.0):
        assert not pulse.hear_busy(time, time + 3.0, said(time))
    assert (pulse.due, pulse.last.receipt) == (33.0, 30.0)
    # Idle again: the time at work is no period.
    pulse.hear(31.0, said(31.0))
    assert pulse.period == pytest.approx(3.0 / 5)


def test_a_robot_that_says_both_is_missed_though_it_says_that_it_is_busy() -> None:
    pulse = pulse_of([0.0, 0.5, 1.0, 1.5, 2.0])
    news = []
    for time in (2.0, 3.0, 4.0, 5.0):
        news.append(pulse.hear_busy(time, time + 2.0, said(time)))
        pulse.hear(time + 0.5, said(time + 0.5))
    # An idle message between two busy ones, three times.
    assert news == [False, False, False, True]
    pulse.hear_busy(6.0, 8.0, said(6.0))
    assert (pulse.due, pulse.last.receipt) == (7.5, 5.5)


def test_to_be_busy_ends_a_gap_of_a_robot_that_does_not_say_both() -> None:
    pulse = pulse_of([0.0, 0.5, 1.0, 1.5, 2.0])
    pulse.silent = True
    assert pulse.hear_busy(9.0, 11.0, said(9.0))


@settings(deadline=None)
@given(st.lists(st.floats(0.01, 1.9), min_size=6, max_size=50))
def test_nobody_is_missed_who_speaks_within_the_timeout(waits: Iterable[float]) -> None:
    pulse, time = Pulse("robot1", "/t", 2.0), 0.0
    for wait in waits:
        time += wait
        assert pulse.due > time
        pulse.hear(time, said(time))


@settings(deadline=None)
@given(st.floats(0.2, 50.0), st.integers(5, 30), st.floats(0.1, 10.0))
def test_a_steady_pulse_has_its_period_and_is_missed_by_the_rule(period: float, beats: int, timeout: float) -> None:
    times = [number * period for number in range(beats)]
    pulse = pulse_of(times, timeout)
    if period >= timeout * 0.05:
        assert pulse.period == pytest.approx(period)
        assert pulse.due == pytest.approx(times[-1] + max(timeout, 3 * period), abs=1e-8)


@settings(max_examples=200, deadline=None)
@given(
    st.lists(st.sampled_from([0.0, 0.01, 0.03, 0.0999999999, 0.1, 0.1000000001, 0.4, 1.7, 30.0]), max_size=40),
    st.integers(1, 7),
    st.booleans(),
    st.sampled_from([0.0, 1.7e9 + 0.123456789]),
)
def test_messages_heard_together_count_as_heard_one_by_one(
    gaps: list[float], together: int, both: bool, start: float
) -> None:
    """Of a topic that has been heard regularly: what comes within 0.1 s, as the timeout is 2 s, is one beat."""
    known = [start + 0.4 * number for number in range(8)]
    times = [known[-1]]
    for gap in gaps:
        times.append(times[-1] + gap)
    one, many = pulse_of(known), pulse_of(known)
    if both:
        for pulse in (one, many):
            for time in known:
                pulse.hear(time, said(time))
                pulse.hear_busy(time, time + 2.0, said(time))
    assert one.says_both is both
    for time in times:
        one.hear(time, said(time))
    for first in range(0, len(times), together):
        part = times[first : first + together]
        many.hear_together(part, said(part[-1]))
    assert (many.due, many.period, many.last) == (one.due, one.period, one.last)


def test_a_pulse_that_quickens_is_missed_earlier_and_says_so() -> None:
    """Periods of 2 s, then of 0.5 s: three of the mean of 2, 2, 2, 2, 0.5 s are 5.1 s after the last, not 6 s."""
    pulse = pulse_of([0.0, 2.0, 4.0, 6.0, 8.0])
    assert (pulse.due, pulse.is_steady) == (14.0, False)
    assert pulse.hear(8.5, said(8.5))
    assert pulse.due == 13.6
    assert pulse.hear(8.55, said(8.55)) is False
