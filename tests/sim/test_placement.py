from __future__ import annotations

import math
from dataclasses import replace

import pytest
from hypothesis import given
from hypothesis import strategies as st

from rqt_mrta_py.hooks import PlacedRobot
from rqt_mrta_py.model import Arena, Obstacle, Pose
from rqt_mrta_py.sim.placement import placement_problems
from rqt_mrta_py.sim.robot_models import DIFF_DRIVE

ARENA = Arena(-5.0, -4.0, 5.0, 4.0)
ROUND = replace(DIFF_DRIVE, radius=0.2)
BOX = Obstacle("crate", Pose(1.0, 1.0), (0.6, 0.4, 0.3))
POST = Obstacle("post", Pose(-1.0, 1.0), (0.5, 0.5, 0.3), "cylinder")


def robots(*starts):
    return [PlacedRobot(f"robot{index}", ROUND, Pose(*start)) for index, start in enumerate(starts, 1)]


def problems(*starts, obstacles=(), arena=ARENA):
    return list(placement_problems(arena, obstacles, robots(*starts)))


def test_placement_of_robots_apart_is_fine():
    assert problems((0, 0), (4.8, 3.8), (0.4, 0.0), obstacles=[BOX, POST]) == []


def test_placement_in_the_wall_names_robot_pose_and_wall():
    assert problems((4.9, 0, 0.5)) == [
        "robot robot1: start pose (4.9, 0, 0.5) overlaps the wall by 0.1 m; keep its radius of 0.2 m away from it"
    ]


def test_placement_outside_the_arena_names_robot_pose_and_arena():
    assert problems((0, -7)) == [
        "robot robot1: start pose (0, -7, 0) lies outside the arena (x -5 to 5, y -4 to 4); its radius is 0.2 m"
    ]


def test_placement_in_obstacles_names_them():
    remedy = "keep its radius of 0.2 m away from it"
    assert problems((1.45, 1.0), (-1.0, 1.4), obstacles=[BOX, POST]) == [
        f"robot robot1: start pose (1.45, 1, 0) overlaps obstacle crate by 0.05 m; {remedy}",
        f"robot robot2: start pose (-1, 1.4, 0) overlaps obstacle post by 0.05 m; {remedy}",
    ]


def test_placement_in_the_middle_of_a_box_is_an_overlap():
    (problem,) = problems((1.0, 1.0), obstacles=[BOX])
    assert "overlaps obstacle crate by 0.4 m" in problem  # radius and half the shorter side


def test_placement_beside_a_turned_box_goes_by_its_true_outline():
    turned = Obstacle("crate", Pose(0.0, 0.0, math.pi / 4), (2.0, 0.2, 0.3))
    assert problems((0.5, -0.5), obstacles=[turned]) == []
    assert len(problems((0.6, 0.6), obstacles=[turned])) == 1


def test_placement_off_the_corner_of_a_box_goes_by_the_corner():
    corner = (1.3, 1.2)
    assert problems((corner[0] + 0.145, corner[1] + 0.145), obstacles=[BOX]) == []
    assert len(problems((corner[0] + 0.135, corner[1] + 0.135), obstacles=[BOX])) == 1


def test_placement_of_robots_on_each_other_names_both():
    assert problems((0, 0), (0.3, 0), (1, -1)) == [
        "robot robot2: start pose (0.3, 0, 0) overlaps robot1 by 0.1 m; keep them apart"
    ]


def test_placement_tells_everything_at_once():
    found = problems((4.9, 0), (1.0, 1.0), (1.0, 1.1), (math.nan, 0), obstacles=[BOX])
    assert [problem.split(":")[0] for problem in found] == [
        "robot robot1",
        "robot robot2",
        "robot robot3",
        "robot robot4",
        "robot robot3",
    ]
    assert found[3] == "robot robot4: start pose must be finite (got (nan, 0, 0))"


@pytest.mark.parametrize(
    ("arena", "message"),
    [
        (Arena(0.0, 0.0, 0.0, 1.0), "arena: must reach from a lower to a higher finite x and y"),
        (Arena(0.0, 0.0, 1.0, -1.0), "arena: must reach from a lower to a higher finite x and y"),
        (Arena(0.0, 0.0, math.inf, 1.0), "arena: must reach from a lower to a higher finite x and y"),
        (Arena(0.0, 0.0, 1.0, 1.0, wall_height=0.0), r"arena: wall_height must be above 0 m (got 0.0)"),
    ],
)
def test_placement_in_an_arena_that_is_none_speaks_of_the_arena_only(arena, message):
    (problem,) = problems((9.0, 9.0), arena=arena)
    assert problem.startswith(message)


@pytest.mark.parametrize(
    ("change", "message"),
    [
        ({"size": (0.0, 1.0, 1.0)}, "obstacle crate: size must be above 0 m, at most 1e+06 m (got (0.0, 1.0, 1.0))"),
        ({"pose": Pose(math.inf, 0.0)}, "obstacle crate: pose must be finite (got (inf, 0, 0))"),
        ({"shape": "star"}, "obstacle crate: no shape 'star'; give box or cylinder"),
    ],
)
def test_placement_among_obstacles_that_are_none_speaks_of_the_obstacles(change, message):
    assert problems((0, 0), obstacles=[replace(BOX, **change)]) == [message]


@given(
    st.floats(-3.0, 3.0),
    st.floats(-3.0, 3.0),
    st.floats(-3.2, 3.2),
    st.floats(0.1, 2.0),
    st.floats(0.1, 2.0),
)
def test_placement_agrees_with_the_nearest_of_many_points_of_a_box(x, y, yaw, length, width):
    box = Obstacle("crate", Pose(0.0, 0.0, yaw), (length, width, 0.3))
    steps = [index / 40 - 0.5 for index in range(41)]
    nearest = min(
        math.hypot(
            math.cos(yaw) * length * a - math.sin(yaw) * width * b - x,
            math.sin(yaw) * length * a + math.cos(yaw) * width * b - y,
        )
        for a in steps
        for b in steps
    )
    spacing = 2.0 / 40
    overlaps = bool(problems((x, y), obstacles=[box]))
    if nearest < 0.2 - 1e-6:
        assert overlaps
    elif nearest > 0.2 + spacing:
        assert not overlaps


def test_placement_of_thousands_on_one_spot_names_a_few_and_counts_the_rest():
    crowd = [(0.0, 0.0)] * 5000
    found = problems(*crowd)
    assert len(found) == 4999
    assert "overlaps robot1 by 0.4 m, robot2 by 0.4 m, robot3 by 0.4 m and 4996 more" in found[-1]


def test_placement_of_what_is_too_far_or_too_large_to_be_computed_is_refused():
    far = Obstacle("moon", Pose(3.8e8, 0.0), (3.5e6, 3.5e6, 1.0))
    assert problems((0, 0), obstacles=[far]) == [
        "obstacle moon: must lie within 1e+06 m of the origin (got pose (3.8e+08, 0, 0))",
        "obstacle moon: size must be above 0 m, at most 1e+06 m (got (3500000.0, 3500000.0, 1.0))",
    ]
    assert problems((0, 0), arena=Arena(-5.0, -4.0, 5.0, 1e300)) == [
        "arena: must lie within 1e+06 m of the origin (got min_x, min_y, max_x, max_y = (-5.0, -4.0, 5.0, 1e+300))"
    ]
