"""Pictures of diagrams and plans hold what they are about."""

from __future__ import annotations

import math
from typing import Any, List

import pytest
from block_construction.execution.planners import plan_build
from block_construction.pictures.bars import Handling, handling_bars
from block_construction.pictures.curves import tried_figure
from block_construction.pictures.isometric import isometric_drawing, project
from block_construction.pictures.levels import level_drawing
from block_construction.pictures.noise_curve import NoisyBuilds, noise_curve
from block_construction.pictures.ways import plan_drawing

from rqt_mrta_py.app.guard import checked_drawing
from rqt_mrta_py.hooks import Area, Drawing, LineStyle, Stroke, Words
from rqt_mrta_py.render.text import Style, text_width
from tests.plugins.block_construction.builds import RING_BLOCKS, problem

pytest.importorskip("scipy", reason="SciPy finds ways")


def shapes(drawing: Drawing, kind: Any) -> List[Any]:
    return [shape for panel in drawing.panels for shape in panel.shapes if isinstance(shape, kind)]


def test_each_level_shows_the_bodies_of_its_blocks_with_their_numbers() -> None:
    """A body of two units is 12 cm by 7 cm, in the middle of a slot of 16 cm by 8 cm."""
    diagram = problem([[2, 2, 1], [1, 0, 1], [1, 1, 1]], [*RING_BLOCKS, (1, 1, 2, 2)]).diagram
    drawing = checked_drawing("test", level_drawing(diagram))
    assert [panel.title for panel in drawing.panels] == ["level 1: 4 blocks", "level 2: 1 block"]
    assert [words.text for words in shapes(drawing, Words)] == ["1", "2", "3", "4", "5"]
    upper = [shape for shape in drawing.panels[1].shapes if isinstance(shape, Area)][-1]
    corners = [(0.02, 0.005), (0.14, 0.005), (0.14, 0.075), (0.02, 0.075)]
    assert [value for point in upper.points for value in point] == pytest.approx(sum(corners, ()))
    # Both of its ends lie on the ends of the block below.
    assert "2 connection faults" in drawing.title
    assert drawing.key[-1][1] == "connection fault with the level above"


def test_a_single_cell_is_seen_as_three_faces_and_nine_lines() -> None:
    drawing = checked_drawing("test", isometric_drawing(problem([[1]], [(1, 1, 1, 1)]).diagram))
    assert len(shapes(drawing, Area)) == 3
    lines = {frozenset(shape.points) for shape in shapes(drawing, Stroke)}
    assert len(lines) == 9
    assert project((1, 0, 0)) == pytest.approx((math.sqrt(0.75), 0.5))
    assert project((0, 0, 1)) == (0.0, 1.0)


def test_faces_between_blocks_are_not_drawn() -> None:
    """Of two cells side by side each has three faces to the eye, but one between them is hidden."""
    drawing = isometric_drawing(problem([[1, 1]], [(1, 1, 1, 2)]).diagram)
    assert len(shapes(drawing, Area)) == 5
    both = isometric_drawing(problem([[1, 1]], [(1, 1, 1, 1), (2, 1, 1, 1)]).diagram)
    # Two blocks have an edge between them, on top and in front, seen from both.
    assert len(shapes(both, Stroke)) == len(shapes(drawing, Stroke)) + 4


def test_each_group_of_a_plan_has_a_panel_with_its_ways() -> None:
    plan = plan_build("exact", problem([[2, 2, 1], [1, 0, 1], [1, 1, 1]], [*RING_BLOCKS, (1, 1, 2, 2)])).plan
    drawing = checked_drawing("test", plan_drawing(plan))
    assert [panel.title for panel in drawing.panels] == [
        "layer 1, level 1: steps 1 to 4",
        "layer 1, level 2: step 5",
    ]
    strokes = shapes(drawing, Stroke)
    assert len(strokes) == 2 * len(plan.steps)
    driven = sum(math.dist(a, b) for stroke in strokes for a, b in zip(stroke.points, stroke.points[1:]))
    assert driven == pytest.approx(plan.cost.total)


def test_numbers_of_supply_places_have_room_in_pictures_of_four_columns() -> None:
    """Plans name places by their numbers; pictures of four groups and more left them out."""
    plan = plan_build("exact", problem([[2, 2, 1], [1, 0, 1], [1, 1, 1]], [*RING_BLOCKS, (1, 1, 2, 2)])).plan
    places = [each for each in shapes(plan_drawing(plan), Words) if each.text[1:2] == ":"]
    assert places
    for place in places:
        # An arena of 2.2 m is 363 pixels wide in such a picture.
        assert place.room * 363.0 / 2.2 > text_width("4: 1,2,3", Style(place.size))


def test_what_was_tried_is_drawn_with_the_least_so_far() -> None:
    (chart,) = tried_figure("cost", "t", (5, 3, 4), "cost").charts
    assert [(line.x, line.y) for line in chart.lines] == [((1, 2, 3), (5, 3, 4)), ((1, 2, 3), (5, 3, 3))]
    (chart,) = tried_figure("cost", "t", tuple(range(2000, 0, -1)), "cost").charts
    mean, least = chart.lines
    assert mean.label == "mean of 3, with least and greatest"
    assert (mean.x[0], mean.y[0], mean.low and mean.low[0]) == (3.0, 1999.0, 1998.0)
    assert (least.x[-1], least.y[-1]) == (2000.0, 1.0)


def test_how_sure_learners_are_is_drawn_below_what_they_tried() -> None:
    figure = tried_figure("cost", "t", (5, 3, 4, 3), "cost", (0.25, 0.5, 0.5, 0.75))
    assert figure.title == "t"
    cost, sure = figure.charts
    assert [line.x for line in cost.lines] == [(1, 2, 3, 4)] * 2
    (line,) = sure.lines
    assert (line.x, line.y) == ((1, 2, 3, 4), (0.25, 0.5, 0.5, 0.75))
    assert sure.y_label == "convergence [1]"


def test_bars_stand_by_structure_beside_the_sources() -> None:
    """Table 10: the tower took 36 and 48 minutes, 38.4 and 46.1 m."""
    rows = [("wall", 8.0, 12.0, 9.0, 10.0, None), ("tower", 34.0, 44.0, 36.0, 43.0, (36.0, 48.0, 38.4, 46.1))]
    figure = handling_bars([Handling(*row) for row in rows])
    minutes, metres = figure.charts
    assert minutes.x_ticks == metres.x_ticks == ("wall", "tower")
    assert (minutes.y_label, metres.y_label) == ("time [min]", "distance [m]")
    labels = ["fetching", "fetching, source", "placing", "placing, source"]
    for chart, tower in ((minutes, (34.0, 36.0, 44.0, 48.0)), (metres, (36.0, 38.4, 43.0, 46.1))):
        assert [line.label for line in chart.lines] == labels
        assert all(line.style is LineStyle.BARS for line in chart.lines)
        assert tuple(line.y[1] for line in chart.lines) == tower
    assert [math.isnan(line.y[0]) for line in minutes.lines] == [False, True, False, True]
    assert handling_bars(rows) == figure


def test_bars_without_anything_of_the_source_leave_no_room_for_it() -> None:
    (minutes, _) = handling_bars([Handling("wall", 8.0, 12.0, 9.0, 10.0)]).charts
    assert [line.label for line in minutes.lines] == ["fetching", "placing"]


def test_the_share_of_whole_builds_is_drawn_over_the_noise_in_centimetres() -> None:
    """Wilson's interval of 20 of 20 begins at 83.9 %, that of 10 of 20 goes from 29.9 to 70.1 %."""
    series = {"brief": [NoisyBuilds(0.02, 10, 20), NoisyBuilds(0.008, 20, 20)], "lasting": [NoisyBuilds(0.02, 0, 20)]}
    (chart,) = noise_curve("t", series).charts
    line, lasting = chart.lines
    assert line.x == pytest.approx((0.8, 2.0))
    assert line.y == pytest.approx((100.0, 50.0))
    assert line.low == pytest.approx((83.9, 29.9), abs=0.05)
    assert line.high == pytest.approx((100.0, 70.1), abs=0.05)
    assert (line.label, lasting.label) == ("brief", "lasting")
    assert (lasting.x, lasting.y) == (pytest.approx((2.0,)), (0.0,))
    assert chart.y_label == "builds that stand whole, of 20 each [%]"
