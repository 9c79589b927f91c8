"""What robots have around them, against all pairs looked at one by one."""

from __future__ import annotations

import math

import numpy as np

from rqt_mrta_py.hooks import Body, PlacedRobot
from rqt_mrta_py.model import Obstacle, Pose
from rqt_mrta_py.sim.planar.crowd import Crowd
from rqt_mrta_py.sim.planar.footprints import placed_obstacles
from rqt_mrta_py.sim.planar.nearby import Nearby
from rqt_mrta_py.sim.planar.visible import Visible
from rqt_mrta_py.sim.robot_models import DIFF_DRIVE

OBSTACLES = [Obstacle("near", Pose(1.0, 1.0), (0.5, 0.4, 0.4)), Obstacle("low", Pose(0.5, 0.5), (0.5, 0.5, 0.05))]
RANGE = 2.0


def scene(*starts):
    crowd = Crowd([PlacedRobot(f"r{index}", DIFF_DRIVE, start) for index, start in enumerate(starts)])
    visible = Visible(crowd, placed_obstacles(OBSTACLES))
    visible.look_again()
    return crowd, visible, Nearby(visible, np.full(len(starts), DIFF_DRIVE.sensor_height))


def in_reach(pairs, visible, rows):
    """Give pairs of a robot's row and a thing's column of which something lies within the range."""
    x, y, _ = visible.poses
    own = visible.obstacles + rows[pairs.robot]
    is_in = (x[pairs.thing] - x[own]) ** 2 + (y[pairs.thing] - y[own]) ** 2 <= pairs.reach_squared
    return sorted(zip(rows[pairs.robot][is_in].tolist(), pairs.thing[is_in].tolist()))


def one_by_one(visible, rows):
    x, y, _ = visible.poses
    return sorted(
        (row, thing)
        for row in rows.tolist()
        for thing in range(visible.poses.shape[1])
        if thing not in (1, visible.obstacles + row)
        and math.hypot(x[thing] - x[2 + row], y[thing] - y[2 + row]) <= RANGE + visible.shapes.radius[thing]
    )


def test_robots_near_something_are_told_so_wherever_they_wander():
    random = np.random.default_rng(5)
    starts = [Pose(*place) for place in random.uniform(-4.0, 4.0, (30, 2))]
    crowd, visible, nearby = scene(*starts)
    rows = np.arange(0, 30, 2)
    way = random.uniform(-0.06, 0.06, (2, 30))
    kept = 0
    last = None
    for _ in range(60):
        pairs = nearby.pairs(rows, RANGE)
        assert in_reach(pairs, visible, rows) == one_by_one(visible, rows)
        kept += pairs is last
        last = pairs
        crowd.poses[:2] += way
        visible.forget()
        visible.look_again()
    assert 20 < kept < 59


def test_body_that_came_or_went_is_known_of_at_once():
    crowd, visible, nearby = scene(Pose(0.0, 0.0), Pose(10.0, 0.0))
    rows = np.array([0])
    assert in_reach(nearby.pairs(rows, RANGE), visible, rows) == [(0, 0)]
    crowd.add(Body("block", (-1.0, 0.0, 0.1), 0.0, (0.2, 0.2, 0.2), 0.5))
    visible.look_again()
    assert in_reach(nearby.pairs(rows, RANGE), visible, rows) == [(0, 0), (0, 4)]
    crowd.remove(2)
    visible.look_again()
    assert in_reach(nearby.pairs(rows, RANGE), visible, rows) == [(0, 0)]


def test_robots_and_ranges_that_take_turns_are_told_apart():
    _, visible, nearby = scene(Pose(0.0, 0.0), Pose(2.5, 0.0), Pose(4.0, 0.0))
    asked = [(np.array([0]), 2.0), (np.array([1, 2]), 2.0), (np.array([0]), 6.0)]
    first = [nearby.pairs(*each) for each in asked]
    assert all(nearby.pairs(*each) is pairs for each, pairs in zip(asked, first))
    # The robots at 2.5 m and 4 m see each other and no obstacle but, from the nearer one, that at (1, 1).
    assert [in_reach(pairs, visible, rows) for pairs, (rows, _) in zip(first, asked)] == [
        [(0, 0)],
        [(1, 0), (1, 4), (2, 3)],
        [(0, 0), (0, 3), (0, 4)],
    ]


def test_pairs_in_mind_are_bounded(monkeypatch):
    monkeypatch.setattr("rqt_mrta_py.sim.planar.nearby._MOST_KEPT", 3)
    _, _, nearby = scene(Pose(0.0, 0.0), Pose(0.0, 1.0), Pose(0.0, 2.0))
    first = nearby.pairs(np.array([0]), 2.0)
    assert first.robot.size == 3
    assert nearby.pairs(np.array([0]), 2.0) is first
    nearby.pairs(np.array([1]), 2.0)
    again = nearby.pairs(np.array([0]), 2.0)
    assert again is not first
    assert again.thing.tolist() == first.thing.tolist() == [0, 3, 4]
