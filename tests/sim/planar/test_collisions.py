"""Push-out: what PlanarWorld promises of robots, bodies, obstacles and walls that meet."""

from __future__ import annotations

import math
from dataclasses import replace

import numpy as np
import pytest
from hypothesis import example, given, settings
from hypothesis import strategies as st

from rqt_mrta_py.hooks import Body, Contact, PlacedRobot, WorldSetup
from rqt_mrta_py.model import Arena, Obstacle, Pose, Twist
from rqt_mrta_py.sim.planar import PlanarWorld
from rqt_mrta_py.sim.robot_models import DIFF_DRIVE, OMNI_DRIVE
from tests.sim.planar import polygons
from tests.sim.worlds import ARENA, TICK, run, setup

FRONT = DIFF_DRIVE.length / 2
SIDE = 0.18
BLOCK = Body("block", (0.3, 0.0, 0.1), 0.0, (0.2, 0.2, 0.2), 0.5)
DEEPEST = 2e-4
"""How deep a robot may end in a wall or an obstacle [m]; what it was built for is half of it."""


@pytest.fixture
def world():
    return PlanarWorld()


def drive(world, seconds, *twists):
    for index, twist in enumerate(twists):
        world.command(f"r{index}", "base", twist)
    run(world, seconds)


def test_robot_slides_along_a_wall_that_it_drives_against_askew(world):
    world.reset(setup(Pose(0.0, 2.7, math.pi / 6)))
    drive(world, 2.0, Twist(0.5, 0.0, 0.0))
    x, y, yaw = world.poses()[0]
    assert yaw == pytest.approx(math.pi / 6)
    assert x > 0.4
    # The hull's corner at (0.15, 0.11) reaches highest, unless the wheel at (0, 0.18) does.
    reach = max(0.15 * math.sin(yaw) + 0.11 * math.cos(yaw), 0.18 * math.cos(yaw))
    assert y == pytest.approx(3.0 - reach, abs=1e-5)


def test_robot_stops_in_a_corner_touching_both_walls(world):
    world.reset(setup(Pose(2.5, 2.5, math.pi / 4)))
    drive(world, 3.0, Twist(0.5, 0.0, 0.0))
    reach = (0.15 + 0.11) * math.sqrt(0.5)
    np.testing.assert_allclose(world.poses()[0, :2], [3.0 - reach, 3.0 - reach], atol=1e-5)
    assert world.contacts() == (Contact("r0", "wall"),)


def test_robot_beside_a_wall_is_pushed_off_by_its_own_turn(world):
    """Side on there are 0.18 m to the wheel; turned by 1 rad the rear corner reaches farther."""
    world.reset(setup(Pose(0.0, 3.0 - SIDE)))
    drive(world, 0.5, Twist(0.0, 0.0, 2.0))
    _, y, yaw = world.poses()[0]
    corners = [y + math.sin(yaw) * a + math.cos(yaw) * b for a in (0.15, -0.15) for b in (0.11, -0.11)]
    assert max(corners) <= 3.0 + 1e-5
    assert y < 3.0 - SIDE - 1e-3


def test_robot_between_walls_that_are_too_near_to_turn_stands(world):
    world.reset(setup(Pose(0.0, 0.0, math.pi / 2), arena=Arena(-0.181, -2.0, 0.181, 2.0)))
    drive(world, 2.0, Twist(0.2, 0.0, 1.0))
    x, y, yaw = world.poses()[0]
    outline = polygons.robot(x, y, yaw)
    assert max(abs(px) for px, _ in outline) < 0.181 + DEEPEST


def test_robot_driven_into_a_narrowing_gap_stays_out_of_both_sides(world):
    walls = [
        Obstacle("left", Pose(0.9, 0.35, -0.2), (1.6, 0.1, 0.3)),
        Obstacle("right", Pose(0.9, -0.35, 0.2), (1.6, 0.1, 0.3)),
    ]
    world.reset(setup(Pose(-0.5, 0.05), obstacles=walls))
    for tick in range(200):
        drive(world, TICK, Twist(0.5, 0.0, 1.5 * math.sin(0.3 * tick)))
    x, y, yaw = world.poses()[0]
    # Half the gap is 0.35 - 0.05 / cos(0.2) - 0.7 tan(0.2) = 0.157 m at x = 1.6: less than the wheels need.
    assert 1.0 < x < 1.6
    hull = polygons.robot(x, y, yaw)
    for wall in walls:
        box = polygons.box(wall.pose.x, wall.pose.y, wall.pose.yaw, 1.6 - 2 * DEEPEST, 0.1 - 2 * DEEPEST)
        assert polygons.common(hull, box) == []


@pytest.mark.parametrize("speed", [0.5, 5.0, 20.0])
def test_nothing_is_so_thin_that_a_robot_passes_through(world, speed):
    fast = replace(DIFF_DRIVE, max_speed=speed)
    world.reset(setup(Pose(-1.0, 0.0), obstacles=[Obstacle("sheet", Pose(0.0, 0.0), (1e-3, 2.0, 0.3))], model=fast))
    drive(world, 3.0, Twist(speed, 0.0, 0.0))
    assert world.poses()[0, 0] == pytest.approx(-FRONT - 5e-4, abs=1e-5)


def test_robots_push_each_other_by_their_masses(world):
    heavy = replace(DIFF_DRIVE, name="heavy", mass=3 * DIFF_DRIVE.mass)
    robots = (PlacedRobot("r0", heavy, Pose(-0.15, 0.0)), PlacedRobot("r1", DIFF_DRIVE, Pose(0.1, 0.0)))
    world.reset(WorldSetup(ARENA, (), robots, TICK))
    run(world, 0.1)
    # 0.05 m too near: a quarter of it is the heavy one's to give.
    np.testing.assert_allclose(world.poses()[:, 0], [-0.15 - 0.0125, 0.1 + 0.0375], atol=1e-6)


def test_robots_that_start_in_the_very_same_place_come_apart_in_a_defined_way(world):
    poses = []
    for _ in range(2):
        world.reset(setup(*[Pose(0.0, 0.0)] * 6))
        run(world, 3.0)
        poses.append(world.poses())
    np.testing.assert_array_equal(*poses)
    for index, (x, y, yaw) in enumerate(poses[0]):
        for other in poses[0][:index]:
            shared = polygons.common(polygons.robot(x, y, yaw), polygons.robot(*other))
            assert polygons.area(shared) < 0.002 * 0.3


def test_row_of_robots_against_a_wall_holds_the_last_one_off(world):
    """The first stands with its back to the wall, and so do those behind it: none is pressed into the next."""
    world.reset(setup(*(Pose(2.8 - 0.4 * index, 0.0) for index in range(4))))
    drive(world, 4.0, *[Twist(0.5, 0.0, 0.0)] * 4)
    expected = [3.0 - FRONT - 0.3 * index for index in range(4)]
    np.testing.assert_allclose(world.poses()[:, 0], expected, atol=5e-3)


def test_body_against_a_wall_stops_the_robot_that_pushes_it(world):
    world.reset(setup(Pose(2.0, 0.0)))
    world.add_body(replace(BLOCK, position=(2.5, 0.0, 0.1)))
    drive(world, 4.0, Twist(0.5, 0.0, 0.0))
    assert world.bodies()["block"].position[0] == pytest.approx(2.9, abs=1e-3)
    assert world.poses()[0, 0] == pytest.approx(2.8 - FRONT, abs=5e-3)
    assert world.contacts() == (Contact("block", "r0"), Contact("block", "wall"))


def test_body_glides_no_further_than_it_is_pushed(world):
    world.reset(setup(Pose(0.0, 0.0)))
    world.add_body(BLOCK)
    drive(world, 1.0, Twist(0.5, 0.0, 0.0))
    drive(world, 1.0, Twist())
    rests = world.bodies()["block"].position
    run(world, 2.0)
    assert world.bodies()["block"].position == rests


def test_things_at_different_heights_pass_each_other(world):
    world.reset(setup(Pose(-0.5, 0.0), obstacles=[Obstacle("low", Pose(0.0, 1.0), (0.4, 0.4, 0.2))]))
    world.add_body(replace(BLOCK, id="shelf", position=(0.0, 0.0, 0.5)))
    world.add_body(replace(BLOCK, id="lintel", position=(0.0, 1.0, 0.35)))
    drive(world, 2.0, Twist(0.5, 0.0, 0.0))
    assert world.poses()[0, 0] > 0.4
    assert world.bodies()["shelf"].position == (0.0, 0.0, 0.5)
    assert world.bodies()["lintel"].position == (0.0, 1.0, 0.35)


def test_blocks_stacked_to_the_rounding_lie_still(world):
    """0.3 - 0.1 is a little less than 0.1 + 0.1."""
    world.reset(setup(Pose(-2.0, 0.0)))
    world.add_body(replace(BLOCK, id="lower", position=(0.0, 0.0, 0.1)))
    world.add_body(replace(BLOCK, id="upper", position=(0.05, 0.0, 0.3)))
    run(world, 1.0)
    assert [state.position[0] for state in world.bodies().values()] == [0.0, 0.05]


def test_carried_body_stops_its_robot_at_a_wall_and_touches_it(world):
    world.reset(setup(Pose(2.0, 0.0)))
    world.add_body(replace(BLOCK, position=(2.3, 0.0, 0.1)))
    world.attach("r0", "block")
    drive(world, 3.0, Twist(0.5, 0.0, 0.0))
    assert world.bodies()["block"].position[0] == pytest.approx(2.9, abs=1e-5)
    assert world.poses()[0, 0] == pytest.approx(2.6, abs=1e-5)
    assert world.contacts() == (Contact("block", "wall"),)


def test_carried_body_keeps_off_what_it_is_swung_against(world):
    world.reset(setup(Pose(0.0, 0.0), obstacles=[Obstacle("post", Pose(0.35, 0.35), (0.2, 0.2, 0.5), "cylinder")]))
    world.add_body(BLOCK)
    world.attach("r0", "block")
    drive(world, 3.0, Twist(0.0, 0.0, 1.0))
    body = world.bodies()["block"]
    yaw = 2 * math.atan2(body.orientation[2], body.orientation[3])
    block = polygons.box(body.position[0], body.position[1], yaw, 0.2, 0.2)
    assert polygons.common(polygons.disc(0.35, 0.35, 0.1 - DEEPEST), block) == []


def test_frozen_carrier_moves_neither_itself_nor_its_body(world):
    world.reset(setup(Pose(0.0, 0.0), Pose(0.9, 0.0, math.pi)))
    world.add_body(BLOCK)
    world.attach("r0", "block")
    world.freeze("r0", True)
    drive(world, 3.0, Twist(0.5, 0.0, 0.0), Twist(0.5, 0.0, 0.0))
    assert world.poses()[0].tolist() == [0.0, 0.0, 0.0]
    assert world.bodies()["block"].position == (0.3, 0.0, 0.1)
    assert world.poses()[1, 0] == pytest.approx(0.4 + FRONT, abs=2e-3)
    assert world.contacts() == (Contact("block", "r1"),)


def test_body_let_go_inside_a_robot_is_pushed_out(world):
    world.reset(setup(Pose(0.0, 0.0)))
    world.add_body(replace(BLOCK, position=(0.2, 0.0, 0.1)))
    world.attach("r0", "block")
    run(world, 0.5)
    assert world.bodies()["block"].position == (0.2, 0.0, 0.1)
    world.detach("block")
    run(world, 0.5)
    assert world.bodies()["block"].position[0] - world.poses()[0, 0] == pytest.approx(FRONT + 0.1, abs=2e-3)


def test_carriers_keep_their_bodies_when_an_earlier_one_is_removed(world):
    world.reset(setup(Pose(0.0, 0.0), Pose(0.0, 1.0)))
    world.add_body(replace(BLOCK, id="first", position=(2.0, 2.0, 0.1)))
    world.add_body(replace(BLOCK, id="second", position=(0.3, 1.0, 0.1)))
    world.attach("r1", "second")
    world.remove_body("first")
    drive(world, 1.0, Twist(), Twist(0.4, 0.0, 0.0))
    x = world.poses()[1, 0]
    assert x > 0.3
    assert world.bodies()["second"].position[0] == pytest.approx(x + 0.3)


twists = st.builds(
    Twist,
    *[st.one_of(st.floats(-0.6, 0.6), st.sampled_from([1e300, -1e300, 0.5, -0.5])) for _ in range(2)],
    st.floats(-3, 3),
)
starts = st.lists(
    st.builds(Pose, st.floats(-1.2, 1.2), st.floats(-1.2, 1.2), st.floats(-math.pi, math.pi)), min_size=1, max_size=5
)
things = st.lists(
    st.tuples(
        st.builds(Pose, st.floats(-1.4, 1.4), st.floats(-1.4, 1.4), st.floats(-math.pi, math.pi)),
        st.floats(0.02, 0.8),
        st.floats(0.02, 0.8),
        st.sampled_from(["box", "cylinder"]),
    ),
    max_size=4,
)
YARD = Arena(-1.5, -1.5, 1.5, 1.5)


@settings(max_examples=40, deadline=None)
@given(starts, things, st.lists(st.lists(twists, min_size=5, max_size=5), min_size=1, max_size=5), st.booleans())
@example(
    [Pose(-1.08, 0.0), Pose(0.0, 0.0), Pose(0.0, 0.0, 0.35), Pose(0.0, 0.5), Pose(0.0, 0.0)],
    [
        (Pose(-0.105, 0.0), 0.5, 0.5, "cylinder"),
        (Pose(0.0, 0.0), 0.02, 0.02, "box"),
        (Pose(0.5, 0.0), 0.16, 0.38, "box"),
        (Pose(0.0, 0.0, 1.79), 0.8, 0.14, "box"),
    ],
    [[*[Twist()] * 4, Twist(0.48, 0.0, 0.0)]],
    False,
)
def test_whatever_the_commands_no_robot_gets_into_a_wall_or_an_obstacle(starts, things, commands, sideways):
    """What starts in some may still be in these, but never deeper, and in no others.

    In the example a robot that started in three came out of the one that it was deepest in by way of others.
    """
    obstacles = [
        Obstacle(f"o{index}", pose, (length, length if shape == "cylinder" else width, 0.4), shape)
        for index, (pose, length, width, shape) in enumerate(things)
    ]
    model = OMNI_DRIVE if sideways else DIFF_DRIVE
    world = PlanarWorld()
    world.reset(setup(*starts, obstacles=obstacles, arena=YARD, model=model))
    allowed = depths_in_fixed(world.poses(), obstacles, model).clip(min=0.0) + DEEPEST
    for row in commands:
        for index in range(len(starts)):
            world.command(f"r{index}", "base", row[index])
        for _ in range(20):
            world.step()
            assert (depths_in_fixed(world.poses(), obstacles, model) <= allowed).all()


def depths_in_fixed(poses, obstacles, model):
    """Give how deep each robot is in each wall and obstacle, 0 or less where it is not."""
    return np.array([depths_of_one(pose, obstacles, model) for pose in poses])


def depths_of_one(pose, obstacles, model):
    x, y, yaw = pose
    hull = polygons.robot(x, y, yaw) if model is DIFF_DRIVE else polygons.box(x, y, yaw, 0.3, 0.3)
    depths = [max(sign * corner[axis] for corner in hull) - 1.5 for axis in (0, 1) for sign in (1, -1)]
    for obstacle in obstacles:
        place, (length, width, _) = obstacle.pose, obstacle.size
        if obstacle.shape == "cylinder":
            depths.append(polygons.depth_in_disc(hull, (place.x, place.y), length / 2))
        else:
            depths.append(polygons.depth_in_polygon(hull, polygons.box(place.x, place.y, place.yaw, length, width)))
    return depths
