from __future__ import annotations

import math
from typing import List, Sequence, Tuple

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from rqt_mrta_py.model import Arena, Obstacle, Pose
from rqt_mrta_py.robot import GridNavigator
from rqt_mrta_py.robot.navigation import OccupancyGrid

ROOM = Arena(0.0, 0.0, 12.0, 8.0)
RADIUS = 0.2
# From y = 0 to y = 6, so that the only way past is above it.
WALL = Obstacle("wall", Pose(6.0, 3.0), (0.4, 6.0, 1.0))


def length(start: Pose, way: Sequence[Pose]) -> float:
    points = [start, *way]
    return sum(one.distance(other) for one, other in zip(points, points[1:]))


def gap(obstacle: Obstacle, x: float, y: float) -> float:
    """Give the distance from a point to an obstacle's edge, worked out in its own frame [m]."""
    cos, sin = math.cos(obstacle.pose.yaw), math.sin(obstacle.pose.yaw)
    dx, dy = x - obstacle.pose.x, y - obstacle.pose.y
    if obstacle.shape == "cylinder":
        return math.hypot(dx, dy) - obstacle.size[0] / 2
    along, across = cos * dx + sin * dy, cos * dy - sin * dx
    return math.hypot(max(abs(along) - obstacle.size[0] / 2, 0), max(abs(across) - obstacle.size[1] / 2, 0))


def between(start: Pose, way: Sequence[Pose]) -> List[Tuple[float, float]]:
    """List points every few centimetres along a way."""
    points = [start, *way]
    return [
        (one.x + part / 50 * (other.x - one.x), one.y + part / 50 * (other.y - one.y))
        for one, other in zip(points, points[1:])
        for part in range(51)
    ]


def test_path_over_free_floor_is_the_straight_line() -> None:
    way = GridNavigator(ROOM, radius=RADIUS).path(Pose(1.03, 1.07), Pose(11.02, 7.01, 1.5))
    assert way == (Pose(11.02, 7.01, 1.5),)


def test_path_goes_around_a_wall_by_the_short_way() -> None:
    start, goal = Pose(4.0, 1.0), Pose(8.0, 1.0)
    way = GridNavigator(ROOM, (WALL,), radius=RADIUS).path(start, goal)
    assert way is not None
    # Around both upper corners at 0.3 m, by hand: from (4, 1) to (5.5, 6.3) is 5.51 m, then 1 m, then the same down.
    assert length(start, way) == pytest.approx(2 * math.hypot(1.5, 5.3) + 1.0, abs=0.35)
    assert all(gap(WALL, x, y) >= RADIUS for x, y in between(start, way))
    assert [pose.yaw for pose in way[:-1]] == pytest.approx(
        [math.atan2(other.y - one.y, other.x - one.x) for one, other in zip(way, way[1:])]
    )


def test_path_is_none_where_the_map_is_closed() -> None:
    closed = Obstacle("wall", Pose(6.0, 4.0), (0.4, 8.0, 1.0))
    navigator = GridNavigator(ROOM, (closed,), radius=RADIUS)
    assert navigator.path(Pose(4.0, 1.0), Pose(8.0, 1.0)) is None
    assert navigator.cost_field(Pose(8.0, 1.0)).at(Pose(4.0, 1.0)) is None


def test_path_changes_with_an_obstacle_added_later() -> None:
    navigator = GridNavigator(ROOM, radius=RADIUS)
    start, goal = Pose(4.0, 1.0), Pose(8.0, 1.0)
    before = navigator.cost_field(goal).at(start)
    navigator.add_obstacle(WALL)
    after = navigator.cost_field(goal).at(start)
    assert before == pytest.approx(4.0, abs=0.15)
    assert after is not None
    assert after > 11.0
    assert len(navigator.path(start, goal) or ()) > 1


def test_path_heeds_passing_obstacles_until_they_are_replaced() -> None:
    navigator = GridNavigator(ROOM, radius=RADIUS)
    start, goal = Pose(2.05, 4.05), Pose(10.05, 4.05)
    navigator.observe([(Pose(6.0, 4.0), 0.5)])
    way = navigator.path(start, goal)
    assert way is not None
    assert all(math.hypot(x - 6.0, y - 4.0) >= 0.5 + RADIUS - 0.08 for x, y in between(start, way))
    assert navigator.cost_field(goal).at(start) == pytest.approx(8.0)
    navigator.observe([])
    assert navigator.path(start, goal) == (goal,)


def test_path_ends_at_the_nearest_free_place_within_reach() -> None:
    box = Obstacle("box", Pose(6.0, 4.0), (1.0, 1.0, 1.0))
    way = GridNavigator(ROOM, (box,), radius=RADIUS).path(Pose(2.0, 4.0), Pose(5.6, 4.0, 0.3))
    assert way is not None
    # The box begins at x = 5.5; a centre is free from 5.2 down, and the last such one is in the cell [5.1, 5.2).
    assert way[-1].x == pytest.approx(5.15)
    assert way[-1].yaw == 0.3
    large = Obstacle("large", Pose(6.0, 4.0), (4.0, 4.0, 1.0))
    assert GridNavigator(ROOM, (large,), radius=RADIUS).path(Pose(2.0, 4.0), Pose(6.0, 4.0)) is None


def test_path_leads_out_of_the_inflation_first() -> None:
    start = Pose(0.1, 4.05)
    way = GridNavigator(ROOM, radius=RADIUS).path(start, Pose(6.05, 4.05))
    assert way == (Pose(pytest.approx(0.35), pytest.approx(4.05), pytest.approx(0.0)), Pose(6.05, 4.05))


def test_path_to_where_the_robot_stands_is_that_place() -> None:
    here = Pose(3.0, 3.0, 1.0)
    assert GridNavigator(ROOM, radius=RADIUS).path(here, here) == (here,)


def test_path_ends_in_the_middle_of_the_cell_when_start_is_next_to_a_blocked_goal() -> None:
    navigator = GridNavigator(ROOM, radius=RADIUS)
    way = navigator.path(Pose(0.38, 4.02), Pose(0.1, 4.05))
    assert way == (Pose(pytest.approx(0.35), pytest.approx(4.05), 0.0),)


def test_path_outside_the_floor_is_none() -> None:
    navigator = GridNavigator(ROOM, radius=RADIUS)
    assert navigator.path(Pose(1.0, 1.0), Pose(20.0, 1.0)) is None
    assert navigator.path(Pose(-3.0, 1.0), Pose(1.0, 1.0)) is None


PLACES = st.builds(Pose, st.floats(0.0, 6.0), st.floats(0.0, 4.0), st.floats(-3.0, 3.0))
OBSTACLES = st.builds(
    Obstacle,
    st.just("thing"),
    PLACES,
    st.tuples(st.floats(0.2, 2.0), st.floats(0.2, 2.0), st.just(1.0)),
    st.sampled_from(["box", "cylinder"]),
)


@settings(max_examples=60, deadline=None)
@given(st.lists(OBSTACLES, max_size=4), PLACES, PLACES)
def test_path_keeps_clear_and_costs_what_the_field_says(things: List[Obstacle], start: Pose, goal: Pose) -> None:
    navigator = GridNavigator(Arena(0.0, 0.0, 6.0, 4.0), things, radius=RADIUS, reach=0.3)
    way = navigator.path(start, goal)
    cost = navigator.cost_field(goal).at(start)
    assert (way is None) is (cost is None)
    if way is None or cost is None:
        return
    # The field counts from centre to centre; each end may lie up to its reach and half a cell's diagonal off.
    assert length(start, way) <= cost + 2 * (0.3 + 0.08)
    for x, y in between(way[0], way[1:]):
        assert 0.2 <= x <= 5.8
        assert 0.2 <= y <= 3.8
        assert all(gap(thing, x, y) >= RADIUS for thing in things)


@pytest.mark.parametrize(
    ("arena", "options", "message"),
    [
        (Arena(0.0, 0.0, 0.0, 8.0), {}, r"a length of 0\.0 m; it must be a finite number above 0"),
        (Arena(0.0, 0.0, 12.0, math.nan), {}, "a breadth of nan m"),
        (ROOM, {"resolution": 0.0}, r"a resolution of 0\.0 m"),
        (
            ROOM,
            {"resolution": 0.001},
            "at most 4000000 cells are accepted: make the arena smaller, or the cells larger",
        ),
        (ROOM, {"radius": -0.1}, r"a radius of -0\.1 m; it must be a finite number, 0 or above"),
        (ROOM, {"margin": math.inf}, "a margin of inf m"),
    ],
)
def test_navigator_refuses_what_makes_no_map(arena: Arena, options: dict, message: str) -> None:
    with pytest.raises(ValueError, match=message):
        GridNavigator(arena, **{"radius": RADIUS, **options})


def test_grid_covers_a_floor_that_is_no_multiple_of_the_resolution() -> None:
    grid = OccupancyGrid(Arena(-1.0, -1.0, 0.05, 0.0), 0.0, 0.0, 0.1)
    # 1.05 m in 11 cells of 0.0955 m; 1 m in 11 rows of them.
    assert grid.resolution == pytest.approx(1.05 / 11)
    assert (grid.width, grid.height) == (13, 13)
    assert grid.cell(-1.0, -1.0) == 13 + 1
    assert grid.cell(0.0499, -0.0001) == 11 * 13 + 11
    assert grid.cell(0.06, -0.5) is None
    assert grid.centre(13 + 1) == pytest.approx((-1.0 + 1.05 / 22, -1.0 + 1.05 / 22))


def test_grid_blocks_what_is_nearer_than_the_clearance() -> None:
    grid = OccupancyGrid(Arena(0.0, 0.0, 5.0, 5.0), 0.3, 0.2, 0.1)
    turned = Obstacle("box", Pose(2.5, 2.5, math.pi / 2), (2.0, 0.4, 1.0))
    grid.add_obstacles((turned,))
    free = {
        (x, y): not grid.known[grid.cell(x, y) or 0]
        for x, y in [(2.25, 3.25), (1.95, 2.55), (2.55, 3.75), (2.55, 3.85)]
    }
    # Turned by a quarter, it spans x 2.3..2.7 and y 1.5..3.5; with 0.3 m around it 2.0..3.0 and 1.2..3.8.
    assert free == {(2.25, 3.25): False, (1.95, 2.55): True, (2.55, 3.75): False, (2.55, 3.85): True}


def test_what_one_robot_learns_of_the_map_is_not_known_to_another():
    """Both hold one map, and the cost fields on it, until one of them learns more."""
    first, second = (GridNavigator(ROOM, radius=RADIUS) for _ in range(2))
    start, goal = Pose(4.0, 1.0), Pose(8.0, 1.0)
    assert first.cost_field(goal).at(start) == second.cost_field(goal).at(start)
    first.add_obstacle(WALL)
    first.observe([(Pose(6.0, 7.0), 0.9)])
    assert first.cost_field(goal).at(start) > 11.0
    assert first.path(start, goal) is None
    assert second.cost_field(goal).at(start) == pytest.approx(4.0, abs=0.15)
    assert second.path(start, goal) == (goal,)
