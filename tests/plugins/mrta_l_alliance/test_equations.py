"""The rules of L-ALLIANCE against hand calculation."""

from __future__ import annotations

from typing import List, Optional, Tuple

import pytest
from hypothesis import given
from hypothesis import strategies as st
from mrta_l_alliance.equations import (
    Category,
    category,
    exploration_delay,
    fast_delay,
    giving_up_delay,
    growth,
    is_bored,
    learned_influence,
    task_time,
    waiting_time,
)

SECONDS = st.floats(0.1, 1e4)


@pytest.mark.parametrize(
    ("times", "least", "expected"),
    [
        ([], 0.25, None),
        ([20.0], 0.0, 20.0),
        ([20.0], 0.25, 25.0),
        ([10.0, 14.0], 0.0, 12.0 + 8.0**0.5),
        ([10.0, 14.0], 0.25, 15.0),
        ([10.0, 20.0, 30.0], 0.25, 30.0),
    ],
    ids=["nothing known", "one trial", "one trial, a quarter", "the deviation", "at least a quarter", "ten"],
)
def test_task_time_is_the_mean_and_one_deviation(times: List[float], least: float, expected: Optional[float]) -> None:
    """The deviation of a sample: 10 and 14 give the root of 8, which is below a quarter of 12; 10, 20, 30 give 10."""
    assert task_time(times, 1.0, least) == (None if expected is None else pytest.approx(expected))


@given(st.lists(SECONDS, min_size=1), st.floats(0.0, 3.0), st.floats(0.0, 1.0))
def test_task_time_is_never_below_the_mean(times: List[float], deviations: float, least: float) -> None:
    time = task_time(times, deviations, least)
    assert time is not None
    assert time >= sum(times) / len(times) * (1.0 - 1e-9)


@pytest.mark.parametrize(
    ("own", "others", "wins_ties", "expected"),
    [
        (None, [], True, Category.UNKNOWN),
        (None, [40.0], True, Category.SECOND),
        (30.0, [], False, Category.FIRST),
        (30.0, [40.0, 31.0], False, Category.FIRST),
        (30.0, [40.0, 29.0], True, Category.SECOND),
        (30.0, [30.0], True, Category.FIRST),
        (30.0, [30.0], False, Category.SECOND),
    ],
)
def test_a_task_is_of_the_first_category_for_the_quickest(
    own: Optional[float], others: List[float], wins_ties: bool, expected: Category
) -> None:
    assert category(own, others, wins_ties=wins_ties) is expected


@pytest.mark.parametrize(("own", "first", "second"), [(20.0, 6.0, 1.0), (30.0, 3.5, 3.5), (40.0, 1.0, 6.0)])
def test_the_longest_task_of_the_first_category_and_the_shortest_of_the_second_come_first(
    own: float, first: float, second: float
) -> None:
    """Times from 20 to 40 s onto delays from 1 to 6 s: a quarter of a second a second."""
    scale = {"low": 20.0, "high": 40.0, "min_delay": 1.0, "max_delay": 6.0}
    assert fast_delay(Category.FIRST, own, **scale) == pytest.approx(first)
    assert fast_delay(Category.SECOND, own, **scale) == pytest.approx(second)


def test_a_task_with_nothing_to_be_ordered_against_comes_at_once() -> None:
    for kind in (Category.FIRST, Category.SECOND):
        assert fast_delay(kind, 20.0, low=20.0, high=20.0, min_delay=1.0, max_delay=6.0) == 1.0


@given(st.sampled_from([Category.FIRST, Category.SECOND]), SECONDS, st.tuples(SECONDS, SECONDS), SECONDS, SECONDS)
def test_a_delay_keeps_within_its_ends(
    kind: Category, own: float, scale: Tuple[float, float], least: float, further: float
) -> None:
    delay = fast_delay(kind, own, low=scale[0], high=sum(scale), min_delay=least, max_delay=least + further)
    assert least * (1.0 - 1e-9) <= delay <= (least + further) * (1.0 + 1e-9)


def test_what_was_tried_least_is_explored_first() -> None:
    """Delays from 1 to 6 s, two attempts at most: a step of 5/3 s for each attempt, and chance within a step."""
    delays = [exploration_delay(attempts, 2, chance, 1.0, 6.0) for attempts, chance in ((0, 0.0), (0, 0.6), (1, 0.0))]
    assert delays == pytest.approx([1.0, 2.0, 1.0 + 5.0 / 3.0])
    assert exploration_delay(2, 2, 0.999, 1.0, 6.0) < 6.0


def test_motivation_reaches_the_threshold_in_the_time_asked_for() -> None:
    """30 in 10 s at 5 Hz: 50 cycles of 0.6."""
    assert growth(30.0, 10.0, 5.0) == pytest.approx(0.6)


def test_a_robot_gives_up_after_some_task_times() -> None:
    assert giving_up_delay(25.0, 3.0) == 75.0


@pytest.mark.parametrize(
    ("own", "others", "expected"),
    [(40.0, [10.0, 15.0], 30.0), (40.0, [38.0], 6.0), (None, [10.0], 6.0), (40.0, [], 6.0)],
    ids=["what the quickest would save", "at least the delay", "its own time unknown", "nobody else known"],
)
def test_a_robot_waits_for_a_quicker_one_while_that_may_pay(
    own: Optional[float], others: List[float], expected: float
) -> None:
    assert waiting_time(6.0, own, others) == expected


def test_a_robot_is_bored_once_it_has_been_idle_long_enough() -> None:
    assert [is_bored(100.0, now, 6.0) for now in (105.8, 106.0, 106.2)] == [False, True, True]


def test_only_boredom_lets_motivation_grow_for_what_others_are_better_at() -> None:
    influence = {(kind, bored): learned_influence(kind, bored) for kind in Category for bored in (False, True)}
    assert [key for key, grows in influence.items() if not grows] == [(Category.SECOND, False)]
