from __future__ import annotations

import math
from typing import List, Optional, Sequence, Tuple

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from rqt_mrta_py.hooks import Heard
from rqt_mrta_py.supervisor.clocks.leads import LeadWatch, Verdict, tolerance_of


def judged(leads: Sequence[Tuple[float, float]], tolerance: float = 1.0) -> Tuple[LeadWatch, List[Optional[Verdict]]]:
    """Feed leads, each with its receipt; the ordinal of a message is its place."""
    watch = LeadWatch(tolerance)
    verdicts = []
    for ordinal, (receipt, lead) in enumerate(leads):
        verdicts.append(watch.judge(receipt, lead, Heard("/t", "", receipt, {}, ordinal=ordinal)))
        if verdicts[-1] is Verdict.OFF:
            watch.tell()
    return watch, verdicts


@pytest.mark.parametrize(("timeout", "tolerance"), [(2.0, 1.0), (3.0, 1.5), (1.0, 0.5), (0.2, 0.5), (0.0, 0.5)])
def test_half_the_timeout_is_tolerated_and_half_a_second_at_least(timeout: float, tolerance: float) -> None:
    assert tolerance_of(timeout) == tolerance


def test_stamps_are_off_when_three_messages_over_the_tolerance_agree() -> None:
    watch, verdicts = judged([(10.0, 0.0), (10.5, 5.0), (11.0, 5.1), (11.4, 4.9), (11.5, 5.0)])
    assert verdicts == [None, None, None, None, Verdict.OFF]
    # The middle one of 5.1, 4.9 and 5.0.
    assert (watch.off, watch.lead, watch.first.ordinal, watch.newest.ordinal) == (True, 5.0, 1, 4)


def test_messages_of_one_moment_are_not_enough() -> None:
    watch, verdicts = judged([(10.0, -1.5), (10.0, -1.6), (10.0, -1.7), (10.1, -1.4), (10.2, -0.2), (11.5, -1.5)])
    assert verdicts == [None] * 6
    assert not watch.off


def test_two_messages_are_not_enough_however_far_apart() -> None:
    assert judged([(10.0, 9.0), (60.0, 9.0)])[1] == [None, None]


def test_what_is_exactly_tolerated_is_calm() -> None:
    watch, verdicts = judged([(1.0, 1.0), (2.0, -1.0), (3.0, 1.0), (4.0, -1.0)])
    assert verdicts == [None] * 4
    assert watch.calm


def test_to_and_fro_agrees_on_nothing() -> None:
    assert judged([(float(second), 5.0 * (-1) ** second) for second in range(20)])[1] == [None] * 20


def test_stamps_are_right_again_when_three_messages_over_the_tolerance_are_within_half_of_it() -> None:
    off = [(float(second), 3.0) for second in range(3)]
    watch, verdicts = judged([*off, (3.0, 0.8), (4.0, 0.4), (4.5, 0.6), (5.0, 0.4), (5.5, -0.3), (6.0, 0.1)])
    # At 4.5 s it is doubtful again, but far less than was told: the middle one of 3.0, 0.8 and 0.6.
    assert verdicts[2:] == [Verdict.OFF, None, None, Verdict.OFF, None, None, Verdict.RIGHT]
    assert (watch.off, watch.calm, watch.right.ordinal) == (False, True, 6)


def test_what_grows_is_told_again_at_a_quarter_more_and_a_tolerance_more() -> None:
    # Half a second each second, as a clock that is slewed: the middle one lags by one message.
    watch, verdicts = judged([(float(second), -0.5 * second) for second in range(21)])
    told = [second for second, verdict in enumerate(verdicts) if verdict is Verdict.OFF]
    # Middle leads: 2.0 at 5; more than 1.0 further are 3.5 at 8 and 5.0 at 11; more than a quarter further 6.5 at 14
    # and 8.5 at 18.
    assert told == [5, 8, 11, 14, 18]
    assert watch.lead == -9.5


def test_the_first_message_stays_the_first_through_doubts() -> None:
    watch, _ = judged([(0.0, 0.0), *[(float(second), 3.0) for second in range(1, 5)], (5.0, 0.0), (6.0, 30.0)])
    assert (watch.first.ordinal, watch.newest.ordinal, watch.off) == (1, 6, True)


@pytest.mark.parametrize("odd", [math.nan, math.inf, -math.inf])
def test_stamps_that_are_no_numbers_are_passed_over(odd: float) -> None:
    assert judged([(float(second), odd) for second in range(9)])[1] == [None] * 9


leads = st.lists(
    st.tuples(st.sampled_from([0.0, 0.1, 0.5, 1.0, 3.0]), st.floats(-20.0, 20.0, allow_nan=False)), max_size=60
)


@settings(deadline=None)
@given(leads)
def test_verdicts_alternate_and_follow_from_what_was_received(steps: Sequence[Tuple[float, float]]) -> None:
    time, timed = 0.0, []
    for wait, lead in steps:
        time += wait
        timed.append((time, lead))
    watch, verdicts = judged(timed)
    off = False
    for ordinal, verdict in enumerate(verdicts):
        if verdict is Verdict.OFF:
            off = True
            assert abs(timed[ordinal][1]) > 0.5
        elif verdict is Verdict.RIGHT:
            assert off
            off = False
            assert abs(timed[ordinal][1]) <= 20.0
    assert watch.off is off


@settings(deadline=None)
@given(st.lists(st.floats(-1.0, 1.0), min_size=1, max_size=40))
def test_nothing_within_the_tolerance_is_ever_off(within: Sequence[float]) -> None:
    assert set(judged([(float(second), lead) for second, lead in enumerate(within)])[1]) == {None}
