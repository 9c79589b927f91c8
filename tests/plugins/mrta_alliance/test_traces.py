"""How values over time are kept and thinned."""

from __future__ import annotations

import math
from typing import List, Optional, Sequence, Tuple

import pytest
from hypothesis import given
from hypothesis import strategies as st
from mrta_alliance.file_names import FileNames
from mrta_alliance.traces import Slope, Steps, thinned

ALWAYS = (-math.inf, math.inf)


def points(told: Tuple[Sequence[float], Sequence[float]]) -> List[Tuple[float, Optional[float]]]:
    """Write NaN as None, for NaN is unequal to itself."""
    return [(time, None if math.isnan(value) else value) for time, value in zip(*told)]


def slope(*told: Tuple[float, float]) -> Slope:
    made = Slope()
    for time, value in told:
        made.add(time, value)
    return made


def steps(*told: Tuple[float, float]) -> Steps:
    made = Steps()
    for time, value in told:
        made.add(time, value)
    return made


def test_a_slope_keeps_its_peaks_and_falls() -> None:
    kept = slope((0.0, 1.0), (0.2, 30.0), (0.4, 0.0), (0.6, 1.5))
    assert points(kept.between(*ALWAYS)) == [(0.0, 1.0), (0.2, 30.0), (0.4, 0.0), (0.6, 1.5)]


def test_a_slope_that_stands_still_keeps_both_ends_only() -> None:
    kept = slope(*[(0.2 * n, 30.0) for n in range(6)], (1.2, 0.0))
    assert points(kept.between(*ALWAYS)) == [(0.0, 30.0), (1.0, 30.0), (1.2, 0.0)]


def test_nothing_is_drawn_across_a_silence_of_more_than_two_seconds() -> None:
    assert points(slope((0.0, 1.0), (2.0, 2.0), (4.1, 3.0)).between(*ALWAYS)) == [
        *((0.0, 1.0), (2.0, 2.0)),
        (2.0, None),
        (4.1, 3.0),
    ]
    assert points(steps((0.0, 1.0), (2.0, 1.0), (4.1, 1.0)).between(*ALWAYS)) == [
        *((0.0, 1.0), (2.0, None)),
        *((4.1, 1.0), (4.1, 1.0)),
    ]


def test_steps_keep_changes_and_when_they_were_last_told() -> None:
    kept = steps((0.0, 0.0), (0.2, 0.0), (0.4, 1.0), (0.6, 0.0), (0.8, 0.0))
    assert points(kept.between(*ALWAYS)) == [(0.0, 0.0), (0.4, 1.0), (0.6, 0.0), (0.8, 0.0)]


def test_a_window_begins_with_the_value_that_holds_by_then() -> None:
    kept = steps((0.0, 0.0), (1.0, 1.0), (2.0, 1.0), (3.0, 0.0))
    assert points(kept.between(1.5, 2.5)) == [(1.5, 1.0), (2.5, 1.0)]
    assert points(kept.between(-5.0, -1.0)) == []


def test_time_that_runs_backwards_stands_still() -> None:
    assert points(slope((5.0, 1.0), (0.0, 2.0)).between(*ALWAYS)) == [(5.0, 1.0), (5.0, 2.0)]
    assert points(steps((5.0, 1.0), (0.0, 2.0)).between(*ALWAYS)) == [(5.0, 1.0), (5.0, 2.0), (5.0, 2.0)]


def test_few_points_are_not_thinned() -> None:
    few = ((0.0, 1.0), (5.0, 6.0))
    assert thinned(few, 8) is few


def test_thinning_keeps_every_peak_and_reset_of_a_long_mission() -> None:
    """A sawtooth of 50 teeth, 200 points each: all 30s and all 0s that fall after them are there."""
    times = tuple(0.1 * n for n in range(10_000))
    values = tuple(30.0 * (n % 200) / 199 for n in range(10_000))
    kept_times, kept = thinned((times, values), 800)
    assert len(kept) <= 1000
    peaks = [time for time, value in zip(kept_times, kept) if value == 30.0]
    falls = [time for time, value in zip(kept_times, kept) if value == 0.0]
    assert peaks == [times[n] for n in range(199, 10_000, 200)]
    assert falls == [times[n] for n in range(0, 10_000, 200)]


VALUES = st.lists(st.floats(-10.0, 10.0) | st.just(math.nan), min_size=9, max_size=200)


@given(VALUES, st.integers(8, 40))
def test_thinning_keeps_ends_extremes_breaks_and_order(values: List[float], most: int) -> None:
    times = tuple(float(number) for number in range(len(values)))
    kept = points(thinned((times, tuple(values)), most))
    told = points((times, values))
    assert set(kept) <= set(told)
    assert [time for time, _ in kept] == sorted({time for time, _ in kept})
    assert {told[0], told[-1], *(point for point in told if point[1] is None)} <= set(kept)
    known = [value for _, value in told if value is not None]
    shown = [value for _, value in kept if value is not None]
    assert (min(known, default=0.0), max(known, default=0.0)) == (min(shown, default=0.0), max(shown, default=0.0))


@pytest.mark.parametrize(
    ("wanted", "name"),
    [
        ("/robot1/wander", "robot1-wander"),
        ("robot1", "robot1"),
        ("..", "__"),
        ("", "_"),
        ("märz $x\n", "m_rz__x_"),
        ("x" * 500, "x" * 120),
    ],
)
def test_names_of_files_hold_nothing_that_could_harm(wanted: str, name: str) -> None:
    assert FileNames().unique(wanted) == name


def test_names_of_files_differ_even_where_case_does_not_count() -> None:
    names = FileNames()
    assert [names.unique(each) for each in ("a b", "a_b", "A_B", "a_b_2")] == ["a_b", "a_b_2", "A_B_3", "a_b_2_2"]
