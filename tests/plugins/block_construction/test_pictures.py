"""Pictures of diagrams and plans hold what they are about."""

from __future__ import annotations

import math
from typing import Any, List

import pytest
from block_construction.execution.planners import plan_build
from block_construction.pictures.curves import tried_figure
from block_construction.pictures.isometric import isometric_drawing, project
from block_construction.pictures.levels import level_drawing
from block_construction.pictures.ways import plan_drawing

from rqt_mrta_py.app.guard import checked_drawing
from rqt_mrta_py.hooks import Area, Drawing, Stroke, Words
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
        "layer 1, level 2: steps 5 to 5",
    ]
    strokes = shapes(drawing, Stroke)
    assert len(strokes) == 2 * len(plan.steps)
    driven = sum(math.dist(a, b) for stroke in strokes for a, b in zip(stroke.points, stroke.points[1:]))
    assert driven == pytest.approx(plan.cost.total)


def test_what_was_tried_is_drawn_with_the_least_so_far() -> None:
    (chart,) = tried_figure("cost", "t", (5, 3, 4), "cost").charts
    assert [(line.x, line.y) for line in chart.lines] == [((1, 2, 3), (5, 3, 4)), ((1, 2, 3), (5, 3, 3))]
    (chart,) = tried_figure("cost", "t", tuple(range(2000, 0, -1)), "cost").charts
    mean, least = chart.lines
    assert (mean.label, mean.x[0], mean.y[0], mean.low and mean.low[0]) == ("mean of 3", 3.0, 1999.0, 1998.0)
    assert (least.x[-1], least.y[-1]) == (2000.0, 1.0)
