"""Lines that monitor panels collect."""

from __future__ import annotations

import math
from typing import List, Optional, Tuple

import pytest
from hypothesis import given
from hypothesis import strategies as st

from rqt_mrta_py.hooks import Curve, CurveGroup, CurveTrace, TeamTraces, nice_top
from rqt_mrta_py.model import ApplicationRobot, ApplicationSpec, ArchitectureSpec, Mission, Task, Taxonomy

MISSION = Mission(
    ApplicationSpec("app", "App", robots=(ApplicationRobot("b"), ApplicationRobot("a", ("mow",)))),
    ArchitectureSpec("someone", "Someone's", Taxonomy()),
    (Task("rake", "anything"), Task("mow", "anything")),
)


@pytest.mark.parametrize(("falls", "strokes"), [(True, 1), (False, 2)])
def test_a_fall_is_a_line_or_a_new_stroke(falls: bool, strokes: int) -> None:
    trace = CurveTrace(10.0, falls=falls)
    for time, value in ((0.0, 1.0), (1.0, 3.0), (2.0, 0.5)):
        trace.add(time, value)
    values = trace.curve("x", 0.0, 2.0).values
    assert sum(map(math.isnan, values)) == strokes - 1
    assert [value for value in values if not math.isnan(value)] == [1.0, 3.0, 0.5]


def test_no_line_is_drawn_across_a_longer_silence() -> None:
    trace = CurveTrace(2.0)
    for time in (0.0, 2.0, 4.5):
        trace.add(time, 1.0)
    curve = trace.curve("x", 0.0, 10.0)
    assert curve.times == (0.0, 2.0, 4.5, 4.5)
    assert [math.isnan(value) for value in curve.values] == [False, False, True, False]


@given(st.lists(st.tuples(st.floats(0.0, 3.0), st.floats(0.0, 9.0)), max_size=1500), st.floats(0.0, 50.0))
def test_a_curve_never_runs_backwards_nor_out_of_the_time_asked_for_and_is_never_long(
    steps: List[Tuple[float, float]], start: float
) -> None:
    trace, now = CurveTrace(2.9), 0.0
    for step, value in steps:
        now += step
        trace.add(now, value)
    curve = trace.curve("x", start, start + 500.0)
    assert list(curve.times) == sorted(curve.times)
    assert all(start <= time <= start + 500.0 for time in curve.times)
    breaks = sum(map(math.isnan, curve.values))
    assert len(curve.times) <= 400 + 3 * breaks + 2


def test_traces_of_a_team_begin_with_its_own_tasks_and_strangers_join_at_the_end() -> None:
    traces = TeamTraces(MISSION, lambda: CurveTrace(1.0))
    traces.of("z", "cook").add(1.0, 4.0)
    groups = traces.groups(0.0, 9.0)
    found = [(group.label, [curve.label for curve in group.curves]) for group in groups]
    assert found == [("b", ["rake", "mow"]), ("a", ["mow"]), ("z", ["cook"])]
    assert groups[2].curves[0].values == (4.0,)


@pytest.mark.parametrize(
    ("largest", "top"), [(None, 1.0), (0.3, 1.0), (1.1, 2.0), (2.0, 2.0), (3.0, 5.0), (7.0, 10.0), (51.0, 100.0)]
)
def test_the_axis_ends_at_one_two_or_five_times_a_power_of_ten(largest: Optional[float], top: float) -> None:
    values = () if largest is None else (0.0, math.nan, largest)
    group = CurveGroup("a", (Curve("x", tuple(map(float, range(len(values)))), values),))
    assert nice_top((group,)) == top
