"""The free floor of an arena, against hand calculation and against looking at every cell and place one by one."""

from __future__ import annotations

import math
from typing import List, Set, Tuple

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from team_measures.floor import Floor

from rqt_mrta_py.model import Arena, Obstacle, Pose

ROOM = Arena(-1.0, -1.0, 1.0, 1.0)


def test_an_empty_room_of_2_by_2_metres_has_64_cells() -> None:
    assert Floor(ROOM, ()).free_cells == 64


def cells_near(floor: Floor, places: List[Tuple[float, float]], reach: float) -> Set[int]:
    """Give the cells' numbers, rows along x after one another."""
    near = np.zeros(floor.shape, dtype=bool)
    patch = floor.free_in(floor.near(places, reach))
    near[patch.rows, patch.columns] = patch.cells
    return set(np.flatnonzero(near).tolist())


@pytest.mark.parametrize(
    ("obstacle", "taken"),
    [
        # Cells have their centres at odd multiples of 0.125 m: within 0.5 m of the origin lie 4 a side.
        (Obstacle("box", Pose(0.0, 0.0), (1.0, 1.0, 0.5)), 16),
        (Obstacle("long", Pose(0.0, 0.0), (1.0, 0.5, 0.5)), 8),
        (Obstacle("turned", Pose(0.0, 0.0, math.pi / 2), (1.0, 0.5, 0.5)), 8),
        # By 45 degrees: |x + y| and |x - y| up to 0.707 m; centres (in eighths) with |x| + |y| <= 5.66.
        (Obstacle("diamond", Pose(0.0, 0.0, math.pi / 4), (1.0, 1.0, 0.5)), 12),
        # Centres (in eighths) with x^2 + y^2 <= 16: (1, 1), (1, 3), (3, 1) in each quarter.
        (Obstacle("pillar", Pose(0.0, 0.0), (1.0, 1.0, 0.5), "cylinder"), 12),
    ],
    ids=lambda value: value.id if isinstance(value, Obstacle) else str(value),
)
def test_cells_whose_centres_lie_in_an_obstacle_are_not_free(obstacle: Obstacle, taken: int) -> None:
    assert Floor(ROOM, (obstacle,)).free_cells == 64 - taken


def test_a_turned_box_takes_the_cells_along_its_own_axis() -> None:
    upright = Floor(ROOM, (Obstacle("turned", Pose(0.0, 0.0, math.pi / 2), (1.0, 0.5, 0.5)),))
    assert cells_near(upright, [(0.0, 0.4)], 0.2) == set()
    assert cells_near(upright, [(0.4, 0.0)], 0.2) != set()


def test_what_is_left_beyond_the_last_cell_with_its_centre_inside_does_not_count() -> None:
    """1.6 m hold six whole cells and 0.1 m, 1.7 m a seventh centre."""
    assert Floor(Arena(0.0, 0.0, 1.6, 0.25), ()).free_cells == 6
    assert Floor(Arena(0.0, 0.0, 1.7, 0.25), ()).free_cells == 7


def test_a_place_covers_the_cells_whose_centres_are_within_reach() -> None:
    """From a corner of cells, in eighths: (1, 1), (1, 3), (3, 1) in each quarter lie within 0.5 m."""
    assert len(cells_near(Floor(ROOM, ()), [(0.0, 0.0)], 0.5)) == 12
    assert len(cells_near(Floor(ROOM, ()), [(1.0, 1.0)], 0.5)) == 3
    assert len(cells_near(Floor(ROOM, ()), [(0.0, 0.0), (0.0, 0.0), (1.0, 1.0)], 0.5)) == 15
    assert len(cells_near(Floor(ROOM, ()), [], 0.5)) == 0


def test_nobody_fills_the_memory_with_a_huge_arena() -> None:
    """1000 km by 1000 km in a million cells of 1 km."""
    floor = Floor(Arena(-5e5, -5e5, 5e5, 5e5), ())
    assert floor.free_cells == 1_000_000
    assert len(cells_near(floor, [(500.0, 500.0)], 1.0)) == 1


@settings(max_examples=40, deadline=None)
@given(
    st.lists(st.tuples(st.floats(-2.0, 2.0), st.floats(-2.0, 2.0)), max_size=6),
    st.floats(0.05, 1.5),
    st.sampled_from([(), (Obstacle("box", Pose(0.3, -0.2, 0.7), (0.9, 0.4, 0.5)),)]),
)
def test_near_cells_are_those_found_one_by_one(
    places: List[Tuple[float, float]], reach: float, obstacles: Tuple[Obstacle, ...]
) -> None:
    floor = Floor(ROOM, obstacles)
    near = cells_near(floor, places, reach)
    free = cells_near(
        floor, [(-1.0 + 0.125 + 0.25 * i, -1.0 + 0.125 + 0.25 * j) for i in range(8) for j in range(8)], 0.01
    )
    for i in range(8):
        for j in range(8):
            x, y = -0.875 + 0.25 * i, -0.875 + 0.25 * j
            apart = min((math.hypot(x - px, y - py) for px, py in places), default=math.inf)
            if abs(apart - reach) > 1e-9:
                assert (8 * i + j in near) == (8 * i + j in free and apart < reach)
