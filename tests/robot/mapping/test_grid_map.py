"""A map from a few looks, worked out by hand; cells of 0.1 m on 2 m x 1 m of floor."""

from __future__ import annotations

import math

import numpy as np
import pytest

from rqt_mrta_py.model import Arena, Pose
from rqt_mrta_py.robot.mapping import GridMap

PLACE = Pose(0.55, 0.55, 0.0)


def fresh() -> GridMap:
    return GridMap(Arena(0.0, 0.0, 2.0, 1.0), resolution=0.1)


def look(grid_map: GridMap, distance: float, times: int = 1) -> None:
    """Look along the row that the robot stands in."""
    for _ in range(times):
        grid_map.look(PLACE, np.array([0.0]), np.array([distance]), reach=1.2)


def test_a_look_tells_of_cells_up_to_what_was_met_and_of_no_others() -> None:
    """From column 5 a ray of 1.0 m ends in column 15."""
    grid_map = fresh()
    look(grid_map, 1.0)
    assert grid_map.odds[5].tolist() == pytest.approx([0.0] * 5 + [-0.4] * 10 + [0.85] + [0.0] * 4)
    assert not np.delete(grid_map.odds, 5, axis=0).any()
    assert np.argwhere(grid_map.occupied).tolist() == [[5, 15]]
    assert grid_map.revision == 1


def test_where_nothing_is_met_all_cells_within_reach_are_free() -> None:
    """1.2 m from x = 0.55 m end at 1.75 m, in column 17; the same for what is met beyond reach."""
    for distance in (math.inf, 1.3):
        grid_map = fresh()
        look(grid_map, distance)
        assert grid_map.odds[5].tolist() == pytest.approx([0.0] * 5 + [-0.4] * 13 + [0.0] * 2)
        assert not grid_map.occupied.any()
        assert grid_map.revision == 0


def test_what_stood_somewhere_is_unlearnt_when_it_is_seen_free_again() -> None:
    """Ten hits are bounded to 3.5; 3.5 - 10 * 0.4 = -0.5 is not yet below -0.7, one look more is."""
    grid_map = fresh()
    look(grid_map, 1.0, times=10)
    look(grid_map, math.inf, times=10)
    assert grid_map.occupied[5, 15]
    look(grid_map, math.inf)
    assert not grid_map.occupied.any()
    assert grid_map.revision == 2


def test_of_one_look_a_cell_in_which_any_ray_ended_was_hit() -> None:
    """One ray ends in column 15; another, hardly turned, passes through it."""
    grid_map = fresh()
    grid_map.look(PLACE, np.array([0.0, 0.01]), np.array([1.0, 1.15]), reach=1.2)
    assert grid_map.odds[5, 15] == pytest.approx(0.85)


def test_walls_are_known_and_take_no_cells() -> None:
    """What is met 0.15 m from the wall in the north is the wall; what is met 0.25 m from it is not."""
    grid_map = fresh()
    grid_map.look(PLACE, np.array([math.pi / 2.0]), np.array([0.30]), reach=1.2)
    assert not grid_map.occupied.any()
    grid_map = fresh()
    grid_map.look(PLACE, np.array([math.pi / 2.0]), np.array([0.20]), reach=1.2)
    assert np.argwhere(grid_map.occupied).tolist() == [[7, 5]]


def test_rays_that_leave_the_floor_tell_of_the_floor() -> None:
    grid_map = fresh()
    grid_map.look(Pose(1.85, 0.55, 0.0), np.array([0.0]), np.array([1.0]), reach=1.2)
    assert grid_map.odds[5].tolist() == pytest.approx([0.0] * 18 + [-0.4] * 2)


def test_a_large_arena_has_larger_cells() -> None:
    """100 m x 100 m make a million cells of 0.1 m."""
    grid_map = GridMap(Arena(0.0, 0.0, 100.0, 100.0))
    assert grid_map.resolution == pytest.approx(0.1)
    assert grid_map.odds.shape == (1000, 1000)
