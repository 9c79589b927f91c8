from __future__ import annotations

import pytest
from hypothesis import given
from hypothesis import strategies as st

from rqt_mrta_py.render.times import Axis, TimeAxis, mission_span, number, seconds, ticks, whole_seconds
from tests.render import views


@pytest.mark.parametrize(
    ("time", "words"), [(0.0, "0.0 s"), (62.04, "62.0 s"), (899.9, "899.9 s"), (3725.0, "1:02:05 h"), (-3.0, "-3.0 s")]
)
def test_seconds_reads_as_people_read_it(time: float, words: str) -> None:
    assert seconds(time) == words


def test_whole_seconds_rounds_down() -> None:
    assert [whole_seconds(time) for time in (0.0, 61.999, 62.0)] == ["0 s", "61 s", "62 s"]


def test_number_writes_no_needless_digits() -> None:
    assert [number(value) for value in (0.0, -0.0, 40.0, 0.5, 1.25)] == ["0", "0", "40", "0.5", "1.25"]


def test_axis_places_values_in_proportion_and_keeps_within_its_ends() -> None:
    axis = Axis(10.0, 20.0, 100.0, 300.0)
    assert [axis(value) for value in (10.0, 15.0, 20.0, 5.0, 99.0)] == [100.0, 200.0, 300.0, 100.0, 300.0]


def test_time_axis_labels_mission_time_not_the_streams_clock() -> None:
    axis = TimeAxis(1.0, 181.0, 0.0, 900.0, zero=1.0)
    assert axis.unit == "s"
    assert axis.ticks(7) == tuple((1.0 + 30.0 * k, str(30 * k)) for k in range(7))


def test_time_axis_changes_to_minutes_and_hours() -> None:
    assert TimeAxis(0.0, 3600.0, 0.0, 1.0).unit == "min"
    assert TimeAxis(0.0, 3600.0, 0.0, 1.0).ticks(7)[1] == (600.0, "10")
    assert TimeAxis(0.0, 86400.0, 0.0, 1.0).unit == "h"
    last_minute = TimeAxis(1741.0, 1801.0, 0.0, 1.0, zero=1.0)
    assert [label for _, label in last_minute.ticks(4)] == ["29:00", "29:20", "29:40", "30:00"]
    assert [label for _, label in TimeAxis(1741.0, 1801.0, 0.0, 1.0, zero=1.0).ticks(3)] == ["29", "29.5", "30"]


@pytest.mark.parametrize("days", [11, 30, 400])
def test_time_axis_labels_are_round_in_the_unit_of_the_labels(days: int) -> None:
    """Labels of missions of many days were round in seconds, so 2.77778 in hours, and ran into each other."""
    axis = TimeAxis(0.0, days * 86400.0, 0.0, 1.0)
    assert axis.unit == "h"
    assert all(label.isdecimal() for _, label in axis.ticks(11))


@pytest.mark.parametrize("high", [4.2, 4.4, 4.9])
def test_one_tick_alone_is_not_left_where_two_can_be(high: float) -> None:
    """Axes up to 4.5 had 0 alone, and so no scale."""
    assert ticks(0.0, high, 3) == (0.0, 2.0, 4.0)


@given(st.floats(-1e4, 1e4), st.floats(1e-3, 1e6), st.integers(2, 15))
def test_ticks_are_few_and_lie_in_the_range(low: float, span: float, most: int) -> None:
    found = ticks(low, low + span, most)
    assert len(found) <= most
    assert all(low - 1e-6 * span <= value <= low + span * (1 + 1e-6) for value in found)


@given(st.floats(0.0, 1e9), st.floats(0.5, 1e7), st.integers(2, 15))
def test_time_ticks_are_few_and_lie_in_the_range(start: float, span: float, most: int) -> None:
    found = TimeAxis(start, start + span, 0.0, 100.0, start).ticks(most)
    assert 1 <= len(found) <= most
    assert all(start - 1e-6 * span <= time <= start + span * (1 + 1e-6) for time, _ in found)


def test_mission_span_is_the_planned_one_where_it_is_known() -> None:
    assert mission_span(views.patrol(91.0)) == (views.START, views.START + 180.0)


def test_mission_span_without_a_plan_holds_the_time_gone_and_moves_in_steps() -> None:
    assert mission_span(views.single(11.5))[1] == mission_span(views.single(13.0))[1]
    for now in (1.0, 11.0, 40.0, 200.0):
        start, end = mission_span(views.single(now))
        assert start == views.START
        assert end >= now
