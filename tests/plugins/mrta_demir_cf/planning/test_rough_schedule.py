"""Eq. 1 of the paper and our rule for robots at the same distance, on hand-calculated teams."""

from __future__ import annotations

import re

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from mrta_demir_cf.planning import rough_schedule

ALL = np.ones(4, dtype=np.bool_)
LINE = np.array([[0.0, 0.0], [1.0, 0.0], [9.0, 0.0], [10.0, 0.0]])

places = st.lists(st.tuples(st.integers(0, 4), st.integers(0, 4)), max_size=12)


def test_a_target_belongs_to_the_robot_that_is_nearest() -> None:
    robots = np.array([[2.0, 0.0], [8.0, 0.0]])
    assert rough_schedule(0, robots, LINE, ALL).tolist() == [0, 1]
    assert rough_schedule(1, robots, LINE, ALL).tolist() == [2, 3]


def test_only_open_targets_count() -> None:
    robots = np.array([[2.0, 0.0], [8.0, 0.0]])
    assert rough_schedule(0, robots, LINE, np.array([False, True, True, True])).tolist() == [1]


def test_a_single_robot_counts_upon_everything() -> None:
    assert rough_schedule(0, np.array([[50.0, 50.0]]), LINE, ALL).tolist() == [0, 1, 2, 3]


@pytest.mark.parametrize(("robot", "expected"), [(0, [0]), (1, []), (2, [])])
def test_of_robots_at_the_same_distance_the_first_owns_the_target(robot: int, expected: list[int]) -> None:
    # Distances 5 by the triangle 3, 4, 5 and along both axes: as squares they are equal to the last bit.
    robots = np.array([[3.0, 4.0], [5.0, 0.0], [0.0, -5.0]])
    assert rough_schedule(robot, robots, np.array([[0.0, 0.0]]), np.array([True])).tolist() == expected


def test_of_robots_that_share_a_depot_the_first_owns_everything() -> None:
    robots = np.zeros((3, 2))
    assert [rough_schedule(robot, robots, LINE, ALL).tolist() for robot in range(3)] == [[0, 1, 2, 3], [], []]


def test_targets_that_coincide_belong_together() -> None:
    targets = np.array([[1.0, 1.0], [7.0, 7.0], [1.0, 1.0]])
    robots = np.array([[0.0, 0.0], [8.0, 8.0]])
    assert rough_schedule(0, robots, targets, ALL[:3]).tolist() == [0, 2]


def test_without_targets_there_is_no_schedule() -> None:
    empty = rough_schedule(0, np.zeros((1, 2)), np.zeros((0, 2)), np.zeros(0, dtype=np.bool_))
    assert empty.tolist() == []


def test_more_robots_than_are_looked_at_together_change_nothing() -> None:
    # Robots at 0, 10, 20 ... and targets 1 m to the right of each.
    robots = np.array([[10.0 * column, 0.0] for column in range(100)])
    targets = robots + [1.0, 0.0]
    everything = np.ones(100, dtype=np.bool_)
    assert [rough_schedule(robot, robots, targets, everything).tolist() for robot in range(100)] == [
        [robot] for robot in range(100)
    ]


@given(robots=places.filter(bool), targets=places)
def test_every_open_target_has_exactly_one_owner(robots: list[tuple[int, int]], targets: list[tuple[int, int]]) -> None:
    points = np.array(targets, dtype=np.float64).reshape(-1, 2)
    everything = np.ones(len(points), dtype=np.bool_)
    team = np.array(robots, dtype=np.float64)
    owned = [target for robot in range(len(team)) for target in rough_schedule(robot, team, points, everything)]
    assert sorted(owned) == list(range(len(points)))
    for robot in range(len(team)):
        for target in rough_schedule(robot, team, points, everything):
            gaps = [(x - points[target, 0]) ** 2 + (y - points[target, 1]) ** 2 for x, y in robots]
            assert robot == gaps.index(min(gaps))


@pytest.mark.parametrize(
    ("robot", "robots", "targets", "open", "message"),
    [
        (1, [[0, 0]], [[1, 1]], [True], "robot: is 1; give a row of robots, 0 <= robot < 1"),
        (-1, [[0, 0]], [[1, 1]], [True], "robot: is -1; give a row of robots, 0 <= robot < 1"),
        (0, [], [[1, 1]], [True], "robot: is 0; give a row of robots, 0 <= robot < 0"),
        (0, [[0, np.nan]], [[1, 1]], [True], "robots[0]: is [0.0, nan]; coordinates must be finite"),
        (0, [[0, 0]], [[1, 1], [np.inf, 0]], [True, True], "targets[1]: is [inf, 0.0]; coordinates must be finite"),
        (0, [[0, 0, 0]], [[1, 1]], [True], "robots: shape is (1, 3); give (n, 2), one place (x, y) in a row"),
        (0, [[0, 0]], [[1, 1]], [True, True], "open: shape is (2,) of bool; give (1,) of bool"),
        (0, [[0, 0]], [[1, 1]], [0], "open: shape is (1,) of int64; give (1,) of bool"),
    ],
)
def test_what_is_no_team_or_no_mask_is_refused(
    robot: int, robots: list[object], targets: list[object], open: list[object], message: str
) -> None:
    with pytest.raises(ValueError, match=f"^{re.escape(message)}$"):
        rough_schedule(robot, np.array(robots), np.array(targets), np.array(open))
