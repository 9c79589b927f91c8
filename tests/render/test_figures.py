"""Figures as pictures: what they must show, what must not stop them."""

from __future__ import annotations

import math
from dataclasses import replace
from typing import List, Optional, Tuple

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from rqt_mrta_py.errors import RenderError
from rqt_mrta_py.hooks import Chart, Figure, Line, LineStyle
from rqt_mrta_py.render.figures import draw_figure, figure_png
from rqt_mrta_py.render.figures.colours import line_colours
from rqt_mrta_py.render.figures.legend import legend_rows
from rqt_mrta_py.render.figures.limits import bar_width, horizontal_limits, most_ticks, vertical_limits
from rqt_mrta_py.render.figures.page import FigurePage
from rqt_mrta_py.render.palette import RED, TASK_COLOURS
from rqt_mrta_py.render.times import ticks
from tests.conftest import require_module

RISE = Line("rise", (0.0, 1.0, 2.0), (0.0, 1.0, 2.0))


def figure(*charts: Chart) -> Figure:
    return Figure("name", "Title", "t [s]", charts)


def chart(*lines: Line, bottom: Optional[float] = None, top: Optional[float] = None) -> Chart:
    return Chart(lines, "y [1]", bottom=bottom, top=top)


def bars(label: str, *heights: float) -> Line:
    return Line(label, tuple(map(float, range(len(heights)))), heights, style=LineStyle.BARS)


def test_a_figure_is_1600_pixels_wide_and_higher_with_more_charts() -> None:
    one, two = draw_figure(figure(chart(RISE))), draw_figure(figure(chart(RISE), chart(RISE)))
    assert (one.shape[1], two.shape[1]) == (1600, 1600)
    assert two.shape[0] > one.shape[0]


def test_equal_figures_are_equal_files_without_date_or_software() -> None:
    require_module("PIL.Image")
    from io import BytesIO

    from PIL import Image

    content = figure_png(figure(chart(RISE)))
    assert figure_png(replace(figure(chart(RISE)))) == content
    assert Image.open(BytesIO(content)).info == {}


def test_lines_stay_within_their_chart_and_have_their_colour() -> None:
    page = FigurePage.of(figure(chart(Line("a", (0.0, 1.0), (5.0, 5.0), colour=1), bottom=0.0, top=10.0)))
    image = page.picture()
    (place,) = page.places
    row = image[round(place.centre[1])]
    blue_green_red = TASK_COLOURS[1][::-1]
    (columns,) = np.nonzero((row == blue_green_red).all(axis=1))
    assert place.left < columns.min() < columns.max() < place.right
    assert len(columns) > 0.95 * place.width


def test_thresholds_are_red() -> None:
    threshold = Line("Threshold", (0.0, 1.0), (1.0, 1.0), style=LineStyle.DASHED, colour=Line.REFERENCE)
    assert line_colours(figure(chart(RISE, threshold)))[0][1] == RED


def test_lines_of_one_label_share_a_colour_and_those_without_one_have_their_own() -> None:
    a, b, bare = (Line(label, (0.0,), (0.0,)) for label in ("a", "b", ""))
    blue, vermillion, purple, sky = TASK_COLOURS[:4]
    assert line_colours(figure(chart(a, b), chart(b, bare, a, bare))) == (
        (blue, vermillion),
        (vermillion, purple, blue, sky),
    )


def test_a_colour_that_is_asked_for_goes_to_all_lines_of_the_label_and_to_no_other() -> None:
    asked, a, b = Line("a", (0.0,), (0.0,), colour=0), Line("a", (0.0,), (0.0,)), Line("b", (0.0,), (0.0,))
    assert line_colours(figure(chart(b), chart(a), chart(asked))) == (
        (TASK_COLOURS[1],),
        (TASK_COLOURS[0],),
        (TASK_COLOURS[0],),
    )


def test_the_legend_names_each_line_once_above_all_charts() -> None:
    page = FigurePage.of(figure(chart(RISE, Line("fall", (0.0,), (1.0,))), chart(RISE)))
    assert [key.words for row in page.legend for key in row] == ["rise", "fall"]
    assert page.places[0].top >= 52.0 + 22.0 * len(page.legend)


def test_a_legend_without_room_says_how_many_more_there_are() -> None:
    many = figure(chart(*(Line(f"a rather long name of line {number}", (0.0,), (0.0,)) for number in range(200))))
    rows = legend_rows(many, line_colours(many), 100.0, 1500.0)
    assert len(rows) == 4
    named = sum(map(len, rows)) - 1
    assert rows[-1][-1].words == f"+{200 - named} more"


def test_a_legend_without_names_takes_no_room() -> None:
    assert FigurePage.of(figure(chart(Line("", (0.0,), (0.0,))))).legend == []


@pytest.mark.parametrize(
    ("values", "limits"),
    [
        ((3.0, 10.0), (0.0, 10.6)),
        ((8.0, 10.0), (7.88, 10.12)),
        ((-1.0, 1.0), (-1.12, 1.12)),
        ((0.0, 0.0), (-0.5, 0.5)),
        ((math.nan, math.inf), (0.0, 1.06)),
    ],
)
def test_the_vertical_axis_holds_all_values_and_zero_where_it_is_near(
    values: Tuple[float, ...], limits: Tuple[float, float]
) -> None:
    assert vertical_limits(chart(Line("", (0.0, 1.0), values))) == pytest.approx(limits)


def test_intervals_have_room_too() -> None:
    line = Line("", (0.0,), (5.0,), (-10.0,), (10.0,))
    assert vertical_limits(chart(line)) == pytest.approx((-11.2, 11.2))


def test_a_chart_gets_the_ends_it_asks_for() -> None:
    assert vertical_limits(chart(RISE, bottom=-0.1, top=1.1)) == (-0.1, 1.1)
    assert vertical_limits(chart(RISE, bottom=5.0)) == (5.0, 10.0)


def test_bars_of_a_chart_stand_side_by_side_upon_zero() -> None:
    """Two lines share four fifths of the distance of 1 between two places."""
    shown = chart(bars("a", 8.0, 9.0), bars("b", 8.0, 10.0))
    assert bar_width(shown) == pytest.approx(0.4)
    assert horizontal_limits(figure(Chart(shown.lines, "y", x_ticks=("p", "q")))) == pytest.approx((-0.5, 1.5))
    assert vertical_limits(shown)[0] == 0.0


def test_all_charts_share_one_horizontal_axis() -> None:
    early, late = Line("", (0.0, 1.0), (0.0, 0.0)), Line("", (5.0, 100.0), (0.0, 0.0))
    assert horizontal_limits(figure(chart(early), chart(late))) == pytest.approx((-1.0, 101.0))


def test_more_charts_than_a_picture_can_be_high_are_told() -> None:
    with pytest.raises(RenderError, match=r"^figure name: 500 charts make a picture 72\d\d\d pixels high"):
        draw_figure(figure(*[chart(RISE)] * 500))


FLOATS = st.floats(allow_nan=True, allow_infinity=True)


@st.composite
def lines(draw: st.DrawFn) -> Line:
    size = draw(st.integers(0, 4))

    def values() -> Tuple[float, ...]:
        return tuple(draw(st.lists(FLOATS, min_size=size, max_size=size)))

    interval = draw(st.booleans())
    return Line(
        draw(st.text(max_size=5)),
        tuple(sorted(values(), key=lambda value: (math.isnan(value), value))),
        values(),
        values() if interval else None,
        values() if interval else None,
        draw(st.sampled_from(LineStyle)),
        draw(st.none() | st.integers(-1, 30)),
    )


@settings(max_examples=12, deadline=None)
@given(st.lists(st.lists(lines(), max_size=3), max_size=3), st.text(max_size=8))
def test_whatever_the_values_are_a_picture_is_drawn(rows: List[List[Line]], words: str) -> None:
    charts = [Chart(tuple(row), words, words, (words,) if len(row) == 2 else None) for row in rows]
    assert draw_figure(Figure("any", words, words, tuple(charts))).shape[1] == 1600


@pytest.mark.parametrize("counts", [(1.0,), (1.0, 2.0), (1.0, 2.0, 3.0, 5.0), (1.0, 12.0), (1.0, 3.0, 50.0)])
def test_of_what_is_counted_only_whole_values_are_written_along_the_axis(counts: Tuple[float, ...]) -> None:
    def written(x: Tuple[float, ...]) -> List[float]:
        figure = Figure("robots", "Robots", "robots", (Chart((Line("a", x, (1.0,) * len(x)),), "m"),))
        return list(ticks(*horizontal_limits(figure), most_ticks(figure)))

    assert all(value == round(value) for value in written(counts))
    assert len(written(counts)) <= 13
    assert any(value != round(value) for value in written((1.0, 2.5)))
