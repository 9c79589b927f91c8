"""What two clocks tell of each other, by hand."""

from __future__ import annotations

from typing import List

import pytest
from hypothesis import given
from hypothesis import strategies as st

from rqt_mrta_py.model.timing import ClockPair
from rqt_mrta_py.supervisor.clocks import clock_pairs


def test_messages_both_ways_bound_an_offset_by_their_latencies() -> None:
    """robot2 is 5 s ahead; what it sends takes 3 ms to robot1, what robot1 sends takes 8 ms to robot2."""
    (pair,) = clock_pairs({"robot1": {"robot2": 5.0 - 0.003}, "robot2": {"robot1": -5.0 - 0.008}})
    assert (pair.robot, pair.other) == ("robot1", "robot2")
    assert pair.at_least == pytest.approx(-5.008)
    assert pair.at_most == pytest.approx(-4.997)
    assert pair.at_most - pair.at_least == pytest.approx(0.003 + 0.008)


def test_one_way_bounds_nothing_on_the_other_side() -> None:
    assert clock_pairs({"robot1": {"robot1": 0.0, "robot2": 1.0}, "robot2": {"robot2": 0.0}}) == ()
    assert clock_pairs({"robot1": {"robot2": 1.0}}) == ()


def test_each_two_of_three_are_a_pair_in_their_order() -> None:
    agreeing = {"b": {"a": -0.5, "c": -0.5}, "a": {"b": -0.25, "c": -0.5}, "c": {"a": -0.5, "b": -0.5}}
    assert clock_pairs(agreeing) == (
        ClockPair("b", "a", -0.25, 0.5),
        ClockPair("b", "c", -0.5, 0.5),
        ClockPair("a", "c", -0.5, 0.5),
    )


SECONDS = st.integers(-(10**6), 10**6)
LATENCIES = st.lists(st.integers(0, 10**6), min_size=1, max_size=4)


@given(SECONDS, LATENCIES, LATENCIES)
def test_the_offset_always_lies_within(offset: int, there: List[int], back: List[int]) -> None:
    """In whole microseconds, so that nothing is rounded."""
    leads = {"a": {"b": max(-offset - each for each in back)}, "b": {"a": max(offset - each for each in there)}}
    (pair,) = clock_pairs(leads)
    assert pair.at_least <= offset <= pair.at_most
    assert pair.at_most - pair.at_least == min(there) + min(back)
