"""Equations 3.1 to 3.12 against values calculated by hand (the calculation stands beside each value)."""

from __future__ import annotations

import math

import pytest
from hypothesis import given
from hypothesis import strategies as st
from mrta_alliance import equations
from mrta_alliance.equations import Announcements


def heard(*times: float, patience: float = 60.0, noticed: float = -1.0) -> Announcements:
    return Announcements(times, times[0] if noticed < 0.0 else noticed, patience)


@pytest.mark.parametrize(
    ("feedback", "possible", "expected"),
    [(True, True, True), (True, False, False), (False, True, False), (False, False, False)],
)
def test_applicable_needs_both_sensors_and_task(feedback: bool, possible: bool, expected: bool) -> None:
    assert equations.applicable(feedback, possible) is expected


@pytest.mark.parametrize(
    ("others", "expected"), [((), False), ((False, False), False), ((True, False), True), ((True, True), True)]
)
def test_inhibited_by_any_other_active_set(others: tuple, expected: bool) -> None:
    """With two others active the original's single toggled flag says False."""
    assert equations.inhibited(others) is expected


@pytest.mark.parametrize(
    ("after", "until", "expected"),
    [
        (4.0, 6.0, True),  # 5.0 lies inside
        (5.0, 6.0, False),  # the window is open at its beginning
        (4.0, 5.0, True),  # and closed at its end
        (5.5, 8.0, True),  # 7.5 lies inside, 5.0 before
        (5.5, 7.0, False),  # between the two messages
        (7.5, 9.0, False),  # after the last
        (0.0, -3.0, False),  # a window that ends before time began is empty
    ],
)
def test_received_looks_into_a_window_open_at_its_beginning(after: float, until: float, expected: bool) -> None:
    assert equations.received((5.0, 7.5), after, until) is expected


def test_received_is_false_before_the_first_message() -> None:
    assert equations.received((), 0.0, 100.0) is False


def test_received_meets_instants_of_this_century_exactly() -> None:
    """1510520000.2 + 2.0 and 1510520002.2 differ as floats, by less than the tolerance."""
    assert equations.received((1510520000.2,), 1510520002.2 - 2.0, 1510520002.2) is False
    assert equations.received((1510520000.2,), 1510520002.0 - 2.0, 1510520002.0) is True


@pytest.mark.parametrize(
    ("first", "expected"),
    [
        (9.9, True),  # within (9.8, 10.0]
        (10.0, True),
        (9.8, False),  # belongs to the cycle before
        (3.0, False),  # known for long
    ],
)
def test_reset_strikes_in_the_cycle_of_the_first_message(first: float, expected: bool) -> None:
    assert equations.reset([heard(first)], 9.8, 10.0) is expected


def test_reset_strikes_once_for_each_other_robot() -> None:
    """k = 1 known since 3.0, k = 2 new: exists k."""
    assert equations.reset([heard(3.0, 9.9), heard(9.9)], 9.8, 10.0) is True
    assert equations.reset([heard(3.0, 9.9), heard(9.7, 9.9)], 9.8, 10.0) is False
    assert equations.reset([], 9.8, 10.0) is False


def test_reset_is_not_lost_for_a_message_received_at_the_moment_of_the_cycle_before() -> None:
    """Received at 9.8, just after the cycle of 9.8 was through: taken in at 10.0."""
    assert equations.reset([heard(9.8, noticed=10.0)], 9.8, 10.0) is True


@pytest.mark.parametrize(("now", "expected"), [(39.9, False), (44.8, False), (44.9, True)])
def test_active_for_needs_more_than_the_delay(now: float, expected: bool) -> None:
    """Active since 4.8 with D = 40: true after 44.8, not at it."""
    assert equations.active_for(40.0, 4.8, now) is expected


@pytest.mark.parametrize(
    ("now", "times", "expected"),
    [
        (20.0, (19.5,), False),  # active for 15 s: psi = 20 not passed, whoever is heard
        (26.0, (25.5,), True),  # active for 21 s > psi, another heard 0.5 s ago
        (26.0, (24.0,), False),  # active for 21 s > psi, but the other silent for tau = 2 s
        (26.0, (), False),  # nobody heard
        (45.2, (), True),  # active for 40.2 s > lambda = 40: gives up, alone or not
    ],
)
def test_acquiescent_by_yielding_and_by_giving_up(now: float, times: tuple, expected: bool) -> None:
    others = [Announcements(times, times[0], 60.0)] if times else []
    answer = equations.acquiescent(others, 5.0, now, timeout=2.0, yielding_delay=20.0, giving_up_delay=40.0)
    assert answer is expected


def test_slow_rate_reaches_the_threshold_in_as_many_cycles_as_the_patience_has_seconds() -> None:
    """30 / 60 = 0.5, as the recording of the original nodes shows."""
    assert equations.slow_rate(30.0, 60.0) == 0.5


@pytest.mark.parametrize(
    ("others", "expected"),
    [
        ([], 1.5),  # nobody: delta_fast
        ([heard(10.0, 70.0)], 1.5),  # first heard 60.1 s ago: phi = 60 is over
        ([heard(10.2, 70.0)], 0.5),  # first heard 59.9 s ago: theta / phi = 30 / 60
        ([heard(68.1)], 1.5),  # silent for tau = 2 s exactly: stopped
        ([heard(68.2)], 0.5),  # heard 1.9 s ago
        ([heard(69.0, patience=60.0), heard(69.5, patience=120.0)], 0.25),  # min(30 / 60, 30 / 120)
        ([heard(69.0, patience=120.0), heard(60.0, patience=600.0)], 0.25),  # the slowest of all is silent
        ([heard(69.0, patience=10.0)], 1.5),  # 30 / 10 = 3 is no slow rate: the fast one bounds it
    ],
)
def test_impatience_is_the_slowest_of_those_on_the_task(others: list, expected: float) -> None:
    """At t = 70.1 with tau = 2, theta = 30, delta_fast = 1.5."""
    assert equations.impatience(others, 70.1, 2.0, 30.0, 1.5) == expected


@pytest.mark.parametrize(
    ("conditions", "expected"),
    [
        ((True, False, False, False), 13.5),  # 12 + 1.5
        ((False, False, False, False), 0.0),
        ((True, True, False, False), 0.0),
        ((True, False, True, False), 0.0),
        ((True, False, False, True), 0.0),
    ],
)
def test_motivation_grows_unless_one_condition_strikes(conditions: tuple, expected: float) -> None:
    value = equations.motivation(
        12.0,
        1.5,
        is_applicable=conditions[0],
        is_inhibited=conditions[1],
        is_reset=conditions[2],
        is_acquiescent=conditions[3],
        threshold=30.0,
    )
    assert value == expected


def grown(previous: float, growth: float) -> float:
    return equations.motivation(
        previous,
        growth,
        is_applicable=True,
        is_inhibited=False,
        is_reset=False,
        is_acquiescent=False,
        threshold=30.0,
    )


def test_motivation_reaches_the_threshold_after_twenty_cycles_of_1_5() -> None:
    """20 x 1.5 = 30, as /robot1 patrol in the recording; no further than the threshold."""
    value = 0.0
    activity = []
    for _ in range(22):
        value = grown(value, 1.5)
        activity.append(equations.active(value, 30.0))
    assert activity == [False] * 19 + [True] * 3
    assert value == 30.0


@given(previous=st.floats(0.0, 30.0), growth=st.floats(0.0, 1e6))
def test_motivation_stays_between_zero_and_the_threshold(previous: float, growth: float) -> None:
    assert previous <= grown(previous, growth) <= 30.0


@given(times=st.lists(st.floats(0.0, 1e4), max_size=20).map(sorted), cut=st.floats(0.0, 1e4))
def test_received_counts_every_message_on_one_side_of_a_cut(times: list, cut: float) -> None:
    """Half-open windows that meet neither lose a message nor count it twice."""
    before = [time for time in times if equations.received((time,), -1.0, cut)]
    after = [time for time in times if equations.received((time,), cut, 2e4)]
    assert before + after == times


@pytest.mark.parametrize(
    ("value", "growth", "expected"),
    [
        (0.0, 1.5, 4.0),  # 30 / (1.5 x 5)
        (12.0, 0.5, 7.2),  # 18 / (0.5 x 5)
        (28.5, 1.5, 0.2),  # one cycle
        (30.0, 1.5, 0.0),  # active
    ],
)
def test_time_to_activation_is_what_is_left_over_the_growth_per_second(
    value: float, growth: float, expected: float
) -> None:
    """Equation 3.10 with theta = 30 and rho = 5 Hz."""
    assert equations.time_to_activation(value, growth, 30.0, 5.0, is_blocked=False) == pytest.approx(expected)


def test_time_to_activation_in_normalised_form() -> None:
    """Equation 3.12: (1 - 0.4) / (0.05 x 5)."""
    assert equations.time_to_activation(0.4, 0.05, 1.0, 5.0, is_blocked=False) == pytest.approx(2.4)


@pytest.mark.parametrize(("growth", "blocked"), [(1.5, True), (0.0, False)])
def test_time_to_activation_is_undefined_where_motivation_does_not_grow(growth: float, blocked: bool) -> None:
    assert math.isnan(equations.time_to_activation(0.0, growth, 30.0, 5.0, is_blocked=blocked))
