"""Ranges against rays followed one by one, edge by edge."""

from __future__ import annotations

import math
from dataclasses import replace

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from rqt_mrta_py.hooks import Body, PlacedRobot, WorldSetup
from rqt_mrta_py.model import Arena, Obstacle, Pose, Twist
from rqt_mrta_py.sim.planar import PlanarWorld, sight
from rqt_mrta_py.sim.robot_models import DIFF_DRIVE
from tests.sim.planar import polygons
from tests.sim.worlds import setup

ARENA = Arena(-3.0, -2.0, 3.0, 2.0)
poses = st.builds(Pose, st.floats(-2.8, 2.8), st.floats(-1.8, 1.8), st.floats(-math.pi, math.pi))
sizes = st.tuples(st.floats(0.05, 1.5), st.floats(0.05, 1.5), st.sampled_from([0.05, 0.4]))


def followed(own, bearing, max_range, starts, obstacles):
    """Follow one ray in the plane of the range finder, 0.12 m high; what it begins inside is not seen."""
    origin, direction = (starts[own].x, starts[own].y), starts[own].yaw + bearing
    outside = polygons.box(0.0, 0.0, 0.0, 6.0, 4.0)
    distances = [polygons.ray_to_polygon(origin, direction, outside)]
    for index, start in enumerate(starts):
        box = polygons.box(start.x, start.y, start.yaw, DIFF_DRIVE.length, DIFF_DRIVE.width)
        if index != own and not is_inside(origin, box):
            distances.append(polygons.ray_to_polygon(origin, direction, box))
    for obstacle in obstacles:
        place, (length, width, height) = obstacle.pose, obstacle.size
        if height < DIFF_DRIVE.sensor_height:
            continue
        if obstacle.shape == "box":
            box = polygons.box(place.x, place.y, place.yaw, length, width)
            if not is_inside(origin, box):
                distances.append(polygons.ray_to_polygon(origin, direction, box))
        elif math.hypot(place.x - origin[0], place.y - origin[1]) > length / 2:
            distances.append(polygons.ray_to_circle(origin, direction, (place.x, place.y), length / 2))
    nearest = min(distances)
    return nearest if nearest <= max_range else math.inf


def is_inside(point, polygon):
    pairs = zip(polygon, [*polygon[1:], polygon[0]])
    return all((bx - ax) * (point[1] - ay) - (by - ay) * (point[0] - ax) >= 0 for (ax, ay), (bx, by) in pairs)


@settings(max_examples=60, deadline=None)
@given(
    st.lists(poses, min_size=1, max_size=4),
    st.lists(st.tuples(poses, sizes, st.sampled_from(["box", "cylinder"])), max_size=4),
    st.floats(0.3, 8.0),
)
def test_ranges_are_those_of_rays_followed_one_by_one(starts, things, max_range):
    obstacles = [
        Obstacle(f"o{index}", pose, (size[0], size[0] if shape == "cylinder" else size[1], size[2]), shape)
        for index, (pose, size, shape) in enumerate(things)
    ]
    world = PlanarWorld()
    world.reset(setup(*starts, obstacles=obstacles, arena=ARENA))
    bearings = np.linspace(-math.pi, math.pi, 24, endpoint=False) + 0.01
    measured = world.ranges([f"r{index}" for index in range(len(starts))], bearings, max_range)
    expected = np.array(
        [[followed(own, bearing, max_range, starts, obstacles) for bearing in bearings] for own in range(len(starts))]
    )
    off = ~np.isclose(measured, expected, atol=1e-9)
    # A ray that grazes a corner, or ends on a surface, may be taken either way: a hair beside it, it is not.
    for robot, ray in zip(*np.nonzero(off)):
        aside = [
            followed(robot, bearings[ray] + hair, reach, starts, obstacles)
            for hair in (-1e-7, 1e-7)
            for reach in (max_range * (1 - 1e-7), max_range * (1 + 1e-7))
        ]
        assert any(math.isclose(measured[robot, ray], near, abs_tol=1e-4) for near in aside)


def test_robot_sees_over_walls_and_things_that_are_lower_than_its_range_finder():
    tall = replace(DIFF_DRIVE, height=0.6, sensor_height=0.5)
    robots = (PlacedRobot("tall", tall, Pose(0.0, 0.0)), PlacedRobot("small", DIFF_DRIVE, Pose(1.0, 0.0)))
    world = PlanarWorld()
    world.reset(WorldSetup(Arena(-2.0, -2.0, 2.0, 2.0, wall_height=0.3), (), robots, 0.05))
    assert np.isposinf(world.ranges(["tall"], np.array([0.0, 1.0]), 10.0)).all()
    np.testing.assert_allclose(world.ranges(["small"], np.array([math.pi, 0.0]), 10.0)[0], [1.0 - 0.15, 1.0])


def test_robot_sees_what_it_carries_and_not_through_it():
    world = PlanarWorld()
    world.reset(setup(Pose(0.0, 0.0, math.pi / 2)))
    world.add_body(Body("block", (0.0, 0.3, 0.1), 0.0, (0.2, 0.2, 0.2), 0.5))
    world.attach("r0", "block")
    assert world.ranges(["r0"], np.zeros(1), 4.0)[0, 0] == pytest.approx(0.2)


def test_crowd_that_sees_all_of_itself_is_served_a_part_at_a_time(monkeypatch):
    starts = [Pose(0.6 * (i % 8) - 2.5, 0.6 * (i // 8) - 1.5, 0.3 * i) for i in range(40)]
    robots = [f"r{index}" for index in range(40)]
    world = PlanarWorld()
    world.reset(setup(*starts))
    bearings = np.linspace(-3.0, 3.0, 30)
    at_once = world.ranges(robots, bearings, 10.0)
    monkeypatch.setattr(sight, "_AT_ONCE", 200)
    np.testing.assert_array_equal(world.ranges(robots, bearings, 10.0), at_once)


def test_many_rays_and_bearings_that_repeat_are_served():
    world = PlanarWorld()
    world.reset(setup(Pose(0.0, 0.0), Pose(1.0, 0.0, math.pi)))
    bearings = np.repeat(np.array([0.0, 0.0, 2 * math.pi]), 5000)
    np.testing.assert_allclose(world.ranges(["r0", "r1"], bearings, 4.0), 0.85)


def test_robot_looks_along_a_face_that_it_stands_in_line_with():
    """A ray that never crosses the pair of faces that it runs along once divided by nothing."""
    side = Obstacle("side", Pose(1.0, 0.25), (0.5, 0.5, 0.5))
    world = PlanarWorld()
    world.reset(setup(Pose(0.0, 0.1), Pose(0.0, -0.5), obstacles=[side]))
    assert world.ranges(["r0"], np.zeros(1), 4.0)[0, 0] == pytest.approx(0.75)
    assert world.ranges(["r1"], np.zeros(1), 4.0)[0, 0] == pytest.approx(3.0)


def test_robots_that_have_moved_see_what_they_would_if_they_had_begun_there():
    """Which things may be seen is kept in mind from step to step."""
    random = np.random.default_rng(3)
    bearings = np.linspace(-math.pi, math.pi, 36, endpoint=False)
    box = Obstacle("box", Pose(0.1, 0.2, 0.4), (0.5, 0.4, 0.4))
    starts = [Pose(0.8 * (i % 6) - 2.1, 0.8 * (i // 6) - 1.5, 1.1 * i % 6.0 - 3.0) for i in range(24)]
    robots = [f"r{index}" for index in range(24)]
    world, anew = PlanarWorld(), PlanarWorld()
    world.reset(setup(*starts, obstacles=[box], arena=ARENA))
    for _ in range(80):
        for robot in robots:
            world.command(robot, "base", Twist(random.uniform(0.0, 0.5), 0.0, random.uniform(-1.0, 1.0)))
        world.step()
        moved = [Pose(*pose) for pose in world.poses().tolist()]
        anew.reset(setup(*moved, obstacles=[box], arena=ARENA))
        some = robots[:: random.integers(1, 3)]
        np.testing.assert_array_equal(world.ranges(some, bearings, 0.9), anew.ranges(some, bearings, 0.9))
