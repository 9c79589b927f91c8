from __future__ import annotations

import math
from itertools import combinations

import pytest
from hypothesis import given
from hypothesis import strategies as st

from rqt_mrta_py.config.packages.layout import lay_out
from rqt_mrta_py.model import Arena

COORDINATES = st.floats(-50.0, 50.0).map(lambda value: round(value, 2))


@given(st.integers(1, 30), st.integers(0, 30), st.lists(st.tuples(COORDINATES, COORDINATES), max_size=5))
def test_everybody_is_inside_and_a_metre_from_everybody_else(
    robots: int, tasks: int, taken: list[tuple[float, float]]
) -> None:
    layout = lay_out(robots, tasks, taken)
    assert (len(layout.starts), len(layout.places)) == (robots, tasks)
    placed = [(pose.x, pose.y) for pose in (*layout.starts, *layout.places)]
    for x, y in [*placed, *taken]:
        assert layout.arena.min_x + 0.5 <= x <= layout.arena.max_x - 0.5
        assert layout.arena.min_y + 0.5 <= y <= layout.arena.max_y - 0.5
    for one, other in combinations(placed, 2):
        assert math.dist(one, other) >= 1.0
    for one in placed:
        assert all(math.dist(one, other) >= 1.0 for other in taken)


def test_two_robots_and_a_task_stand_on_six_by_six_metres() -> None:
    """Nine cells of 2 m: two below, the task in the far corner."""
    layout = lay_out(2, 1)
    assert layout.arena == Arena(-3.0, -3.0, 3.0, 3.0)
    assert [(pose.x, pose.y) for pose in layout.starts] == [(-2.0, -2.0), (0.0, -2.0)]
    assert [(pose.x, pose.y) for pose in layout.places] == [(2.0, 2.0)]


def test_a_given_arena_is_filled_more_densely() -> None:
    layout = lay_out(3, 1, (), Arena(0.0, 0.0, 2.0, 2.0))
    assert [(pose.x, pose.y) for pose in layout.starts] == [(0.5, 0.5), (1.5, 0.5), (0.5, 1.5)]


def test_a_given_arena_without_room_is_refused() -> None:
    with pytest.raises(ValueError, match="has no room for 5 robots and 0 places"):
        lay_out(5, 0, (), Arena(0.0, 0.0, 2.0, 2.0))
