"""Areas and lanes against drawings; that lanes leave nothing unseen for any area."""

from __future__ import annotations

import math
from typing import List, Tuple

import pytest
from basic_behaviours.area import Circle, Lane, Rectangle, from_nearer_end, lanes
from hypothesis import given
from hypothesis import strategies as st

from rqt_mrta_py.model import Pose


def points(laid: Tuple[Lane, ...]) -> List[List[Tuple[float, float]]]:
    return [[(round(place.x, 6), round(place.y, 6)) for place in lane] for lane in laid]


def test_lanes_of_a_rectangle_lie_along_its_longer_side_and_turn_round() -> None:
    # 2 m across: two lanes 1 m apart at half a metre from the sides, ending half a metre before the ends.
    assert points(lanes(Rectangle(Pose(1.0, 2.0), 4.0, 2.0), 1.5)) == [
        [(-0.5, 1.5), (2.5, 1.5)],
        [(2.5, 2.5), (-0.5, 2.5)],
    ]


def test_lanes_of_an_upright_rectangle_stand_upright() -> None:
    assert points(lanes(Rectangle(Pose(0.0, 0.0), 1.0, 3.0), 1.0)) == [[(0.0, -1.0), (0.0, 1.0)]]


def test_lanes_of_a_circle_end_where_it_ends() -> None:
    # 2 m across, three lanes 2/3 m apart: sqrt(1 - 4/9) - 1/3 = 0.412023 and 1 - 1/3 from the middle.
    assert points(lanes(Circle(Pose(0.0, 0.0), 1.0), 0.7)) == [
        [(-0.412023, -0.666667), (0.412023, -0.666667)],
        [(0.666667, 0.0), (-0.666667, 0.0)],
        [(-0.412023, 0.666667), (0.412023, 0.666667)],
    ]


def test_a_lane_that_is_too_short_to_drive_along_is_one_place() -> None:
    assert points(lanes(Rectangle(Pose(1.0, 1.0), 1.0, 1.0), 2.0)) == [[(1.0, 1.0)]]


sides = st.floats(0.2, 20.0)


@given(
    st.one_of(
        st.builds(Rectangle, st.just(Pose(0.0, 0.0)), sides, sides), st.builds(Circle, st.just(Pose(0.0, 0.0)), sides)
    ),
    st.floats(0.3, 5.0),
    st.floats(-1.0, 1.0),
    st.floats(-1.0, 1.0),
)
def test_no_place_is_farther_from_a_lane_than_half_a_spacing_and_the_end(
    area: object, spacing: float, along: float, across: float
) -> None:
    """Half a spacing to the side and half a spacing beyond the end, so less than 0.71; in a circle a little more."""
    assert isinstance(area, (Rectangle, Circle))
    size = (area.radius, area.radius) if isinstance(area, Circle) else (area.length / 2.0, area.width / 2.0)
    place = Pose(along * size[0], across * size[1])
    if not area.contains(place):
        return
    laid = lanes(area, spacing)
    nearest = min(to_segment(place, lane[0], lane[-1]) for lane in laid)
    apart = laid[1][0].distance(laid[0][-1]) if len(laid) > 1 else 0.0
    assert nearest <= max(spacing, apart) * 1.2


def to_segment(place: Pose, start: Pose, end: Pose) -> float:
    length = start.distance(end)
    if length == 0.0:
        return place.distance(start)
    along = ((place.x - start.x) * (end.x - start.x) + (place.y - start.y) * (end.y - start.y)) / length
    part = min(max(along / length, 0.0), 1.0)
    return math.hypot(start.x + part * (end.x - start.x) - place.x, start.y + part * (end.y - start.y) - place.y)


def test_lanes_are_driven_from_the_end_that_is_nearer() -> None:
    laid = lanes(Rectangle(Pose(0.0, 0.0), 4.0, 2.0), 1.0)
    assert from_nearer_end(laid, Pose(-5.0, -5.0)) == laid
    turned = from_nearer_end(laid, Pose(-5.0, 5.0))
    assert points(turned) == [[(-1.5, 0.5), (1.5, 0.5)], [(1.5, -0.5), (-1.5, -0.5)]]


@pytest.mark.parametrize(
    ("place", "inside"), [(Pose(2.0, 1.0), True), (Pose(2.01, 0.0), False), (Pose(0.0, -1.01), False)]
)
def test_a_rectangle_contains_its_border(place: Pose, inside: bool) -> None:
    assert Rectangle(Pose(0.0, 0.0), 4.0, 2.0).contains(place) is inside


@pytest.mark.parametrize(("place", "inside"), [(Pose(0.0, 1.0), True), (Pose(0.8, 0.7), False)])
def test_a_circle_contains_its_border(place: Pose, inside: bool) -> None:
    assert Circle(Pose(0.0, 0.0), 1.0).contains(place) is inside
