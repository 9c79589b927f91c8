from __future__ import annotations

import math

import numpy as np
import pytest
from hypothesis import assume, given, settings
from hypothesis import strategies as st

from rqt_mrta_py.model import Obstacle, Pose
from rqt_mrta_py.sim.planar.footprints import Placed, placed_obstacles, robot_footprints
from rqt_mrta_py.sim.planar.overlap import overlap
from rqt_mrta_py.sim.robot_models import DIFF_DRIVE, OMNI_DRIVE
from tests.sim.planar import polygons

THE_FIRST = np.array([0])


def edges_of(model, yaw):
    """Give the half edges of one robot at the origin."""
    return Placed(robot_footprints([model]), np.array([[0.0], [0.0], [yaw]])).half_edges(THE_FIRST)


def measure(yaw, obstacle):
    """Measure a diff_drive at the origin against an obstacle: depth, and the way that the robot comes free."""
    placed = placed_obstacles([obstacle])
    edges = edges_of(DIFF_DRIVE, yaw)
    depth, away = overlap(placed.poses[:2], edges, placed.half_edges(THE_FIRST), placed.footprints.rounding)
    return depth[0], away[:, 0]


@pytest.mark.parametrize(
    ("yaw", "obstacle", "depth", "away"),
    [
        # Half the robot's length and half the box reach 0.15 + 0.25 of the 0.38 to its centre.
        (0.0, Obstacle("ahead", Pose(0.38, 0.0), (0.5, 0.5, 1.0)), 0.02, (-1.0, 0.0)),
        (0.0, Obstacle("behind", Pose(-0.43, 0.0), (0.5, 0.5, 1.0)), -0.03, (1.0, 0.0)),
        # At the sides the wheels reach 0.18.
        (0.0, Obstacle("beside", Pose(0.0, 0.41), (0.5, 0.5, 1.0)), 0.02, (0.0, -1.0)),
        (math.pi / 2, Obstacle("ahead", Pose(0.0, 0.38), (0.5, 0.5, 1.0)), 0.02, (0.0, -1.0)),
        # A box on its corner: half its diagonal is 0.5.
        (
            0.0,
            Obstacle("corner", Pose(0.64, 0.0, math.pi / 4), (math.sqrt(0.5), math.sqrt(0.5), 1.0)),
            0.01,
            (-1.0, 0.0),
        ),
        (0.0, Obstacle("post", Pose(0.34, 0.05), (0.4, 0.4, 1.0), "cylinder"), 0.01, (-1.0, 0.0)),
        # From the robot's corner at (0.15, 0.11) to the post's centre it is 0.1 at 0.8, 0.6.
        (0.0, Obstacle("post at the corner", Pose(0.23, 0.17), (0.21, 0.21, 1.0), "cylinder"), 0.005, (-0.8, -0.6)),
        (0.0, Obstacle("post off the corner", Pose(0.23, 0.17), (0.19, 0.19, 1.0), "cylinder"), -0.005, (-0.8, -0.6)),
    ],
    ids=lambda value: getattr(value, "id", None),
)
def test_overlap_is_what_is_calculated_by_hand(yaw, obstacle, depth, away):
    measured, way = measure(yaw, obstacle)
    assert measured == pytest.approx(depth, abs=1e-12)
    np.testing.assert_allclose(way, away, atol=1e-12)


def outline(obstacle, push=(0.0, 0.0)):
    x, y = obstacle.pose.x - push[0], obstacle.pose.y - push[1]
    if obstacle.shape == "cylinder":
        return polygons.disc(x, y, obstacle.size[0] / 2)
    return polygons.box(x, y, obstacle.pose.yaw, *obstacle.size[:2])


sizes = st.floats(0.02, 0.6)
turns = st.floats(-math.pi, math.pi)
obstacles = st.builds(
    lambda x, y, yaw, length, width, shape: Obstacle(
        "thing", Pose(x, y, yaw), (length, width if shape == "box" else length, 1.0), shape
    ),
    *[st.floats(-0.5, 0.5)] * 2,
    turns,
    sizes,
    sizes,
    st.sampled_from(["box", "cylinder"]),
)


@settings(max_examples=60, deadline=None)
@given(turns, obstacles)
def test_overlap_tells_in_from_out_and_its_way_leads_out_and_no_shorter_one_does(yaw, obstacle):
    depth, away = measure(yaw, obstacle)
    assume(abs(depth) > 1e-4)
    hull = polygons.robot(0.0, 0.0, yaw)
    assert (polygons.area(polygons.common(outline(obstacle), hull)) > 1e-12) == (depth > 0.0)
    if depth > 0.0:
        free = polygons.common(outline(obstacle, away * (depth + 1e-5)), hull)
        assert polygons.area(free) < 1e-12
        for turn in np.linspace(0.0, 2 * math.pi, 8, endpoint=False):
            push = 0.98 * depth * np.array([math.cos(turn), math.sin(turn)])
            assert polygons.area(polygons.common(outline(obstacle, push), hull)) > 1e-14


@pytest.mark.parametrize("model", [DIFF_DRIVE, OMNI_DRIVE], ids=lambda model: model.name)
def test_robot_fits_into_the_circle_that_starts_are_checked_with(model):
    footprint = robot_footprints([model])
    assert footprint.radius[0] <= model.radius
    assert footprint.half_size[:, 0].tolist() == [model.length / 2, model.width / 2]


def test_omni_drive_touches_as_the_box_of_its_body():
    assert np.abs(edges_of(OMNI_DRIVE, 0.0)).sum(axis=1)[:, 0].tolist() == [0.15, 0.15]
