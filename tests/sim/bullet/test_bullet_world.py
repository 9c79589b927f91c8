"""What BulletWorld does beyond the contract of worlds."""

from __future__ import annotations

import math
from dataclasses import replace

import numpy as np
import pytest

from rqt_mrta_py.errors import SimError
from rqt_mrta_py.hooks import Body, Contact
from rqt_mrta_py.model import Arena, Obstacle, Pose, Twist
from rqt_mrta_py.sim.bullet import BulletWorld
from rqt_mrta_py.sim.robot_models import DIFF_DRIVE, SMALL_DIFF_DRIVE
from tests.sim.worlds import TICK, crowd_setup, run, setup

WIDE = Arena(-3.0, -3.0, 5.0, 3.0)


@pytest.fixture
def world():
    built = BulletWorld()
    yield built
    built.close()


@pytest.mark.parametrize("control_rate", [1, 7, 10, 20, 24, 30, 60, 120, 1000])
def test_robot_drives_alike_whatever_the_control_rate(world, control_rate):
    world.reset(setup(Pose(0.0, 0.0), tick=1.0 / control_rate))
    world.command("r0", "base", Twist(0.4, 0.0, 0.0))
    for _ in range(control_rate):
        world.step()
    assert world.poses()[0, 0] == pytest.approx(0.38, abs=0.01)


@pytest.mark.parametrize("model", [DIFF_DRIVE, SMALL_DIFF_DRIVE], ids=lambda model: model.name)
def test_robot_drives_and_turns_as_it_is_told_whatever_its_size(world, model):
    """Within 2 %, over two seconds after one to get going; a robot that stands creeps by less than 1 mm/s."""
    world.reset(setup(Pose(-1.0, 0.0), Pose(0.0, 1.0), Pose(0.0, -1.0), model=model))
    world.command("r0", "base", Twist(vx=0.2))
    world.command("r1", "base", Twist(wz=1.0))
    run(world, 1.0)
    before = world.poses().copy()
    run(world, 2.0)
    moved = world.poses() - before
    assert moved[0] == pytest.approx([0.4, 0.0, 0.0], abs=0.008)
    assert moved[1] == pytest.approx([0.0, 0.0, 2.0], abs=0.04)
    assert moved[2] == pytest.approx([0.0, 0.0, 0.0], abs=0.002)


def test_poses_do_not_depend_on_how_often_they_are_asked_for(world):
    """They are read from the engine when somebody asks, which must leave it as it was."""

    def drive(asked_every):
        world.reset(crowd_setup())
        for tick in range(60):
            for index in range(5):
                world.command(f"r{index}", "base", Twist(0.4, 0.0, math.sin(0.1 * tick + index)))
            world.step()
            if tick % asked_every == 0:
                world.poses()
        return world.poses()

    np.testing.assert_array_equal(drive(1), drive(60))


def test_world_that_is_closed_tells_no_poses(world):
    world.reset(setup(Pose(1.0, 0.0)))
    world.close()
    with pytest.raises(SimError, match=r"^world bullet: not built yet or closed; call reset first$"):
        world.poses()


def test_tick_that_is_no_time_is_refused_showing_it(world):
    with pytest.raises(SimError) as caught:
        world.reset(setup(Pose(0.0, 0.0), tick=-0.05))
    assert str(caught.value) == "world bullet: a tick must last a finite time above 0 s (got -0.05)"


def test_more_robots_than_it_can_step_are_refused_before_any_is_built(world):
    with pytest.raises(SimError, match=r"at most 4000 robots are accepted \(got 4001\); world planar takes more"):
        world.reset(setup(*(Pose(float(index), 0.0) for index in range(4001))))


@pytest.mark.parametrize("max_speed", [0.5, 3.0])
def test_robot_at_full_speed_gets_no_deeper_into_a_wall_than_in_one_step(world, max_speed):
    """A tick of a fast robot is divided into more steps; at 40 a second, it would be 75 mm deep."""
    world.reset(setup(Pose(-2.0, 0.0), model=replace(DIFF_DRIVE, max_speed=max_speed), arena=WIDE))
    world.command("r0", "base", Twist(max_speed, 0.0, 0.0))
    deepest = 0.0
    for _ in range(round(9.0 / max_speed / TICK)):
        world.step()
        deepest = max(deepest, float(world.poses()[0, 0]) + DIFF_DRIVE.length / 2 - WIDE.max_x)
    assert 0.0 < deepest < 0.0125


@pytest.mark.parametrize("frozen", [False, True])
def test_robot_that_stood_long_enough_to_rest_obeys_at_once(world, frozen):
    world.reset(setup(Pose(0.0, 0.0)))
    world.freeze("r0", frozen)
    run(world, 6.0)
    world.freeze("r0", False)
    world.command("r0", "base", Twist(0.01, 0.0, 0.0))
    run(world, 10.0)
    assert world.poses()[0, 0] == pytest.approx(0.1, abs=0.005)


def test_robot_that_rests_gives_way_to_a_push_and_is_touched(world):
    world.reset(setup(Pose(0.0, 0.0), Pose(-1.5, 0.0)))
    run(world, 6.0)
    world.command("r1", "base", Twist(0.4, 0.0, 0.0))
    run(world, 5.0)
    assert world.poses()[0, 0] > 0.1
    assert world.contacts() == (Contact("r0", "r1"),)
    world.command("r1", "base", Twist())
    run(world, 6.0)
    before = world.poses()
    run(world, 5.0)
    np.testing.assert_array_equal(world.poses(), before)


def test_body_that_a_resting_robot_holds_or_loses_goes_its_way(world):
    world.reset(setup(Pose(0.0, 0.0)))
    world.add_body(Body("block", (0.3, 0.0, 0.4), 0.0, (0.1, 0.1, 0.1), 0.2))
    world.attach("r0", "block")
    run(world, 6.0)
    assert world.bodies()["block"].position[2] == pytest.approx(0.4, abs=0.02)
    world.detach("block")
    run(world, 2.0)
    assert world.bodies()["block"].position[2] == pytest.approx(0.05, abs=0.01)


def test_robots_and_loose_bodies_stand_on_one_floor_each(world):
    """Both once stood on both floors, which doubled the contacts and the time they take."""
    world.reset(setup(Pose(0.0, 0.0)))
    world.add_body(Body("block", (1.0, 0.0, 0.1), 0.0, (0.2, 0.2, 0.2), 0.5))
    run(world, 1.0)
    engine = world._engine
    stood_on = {}
    for _, first, second, *_ in engine.bullet.getContactPoints(physicsClientId=engine.client):
        name, floor = (first, second) if first in world._names else (second, first)
        stood_on.setdefault(world._names[name], set()).add(floor)
    assert {name: len(floors) for name, floors in stood_on.items()} == {"r0": 1, "block": 1}
    assert stood_on["r0"] != stood_on["block"]


def test_loose_bodies_lie_still_flat_and_on_one_another(world):
    """On a plane, Bullet once let them turn by themselves and sink by a third of their height."""
    world.reset(setup(Pose(2.0, 0.0)))
    bodies = [
        Body("flat", (0.0, 0.0, 0.05), 0.3, (0.3, 0.2, 0.1), 0.5),
        Body("below", (1.0, 0.0, 0.1), 0.3, (0.2, 0.2, 0.2), 0.5),
        Body("above", (1.0, 0.0, 0.3), 0.6, (0.2, 0.2, 0.2), 0.5),
    ]
    for body in bodies:
        world.add_body(body)
    run(world, 5.0)
    for body, state in zip(bodies, world.bodies().values()):
        np.testing.assert_allclose(state.position, body.position, atol=5e-3)
        flat = (0.0, 0.0, math.sin(body.yaw / 2), math.cos(body.yaw / 2))
        np.testing.assert_allclose(state.orientation, flat, atol=5e-3)


@pytest.mark.parametrize("sensor_height", [0.03, 0.07, 0.12, 0.2])
def test_robot_looks_past_its_own_wheels_and_casters(world, sensor_height):
    """The wall is 0.3 m high: seen from every height, through whatever of the robot is in the way."""
    model = replace(DIFF_DRIVE, sensor_height=sensor_height)
    world.reset(setup(Pose(0.0, 0.0), model=model))
    bearings = np.linspace(-math.pi, math.pi, 72, endpoint=False)
    across = 3.0 / np.maximum(np.abs(np.cos(bearings)), np.abs(np.sin(bearings)))
    np.testing.assert_allclose(world.ranges(["r0"], bearings, 10.0)[0], across, atol=3e-3)


@pytest.mark.parametrize("max_range", [1.0, 0.08005])
def test_robot_sees_nothing_where_only_its_own_wheel_is_near_enough(world, max_range):
    """The wheel begins 0.08 m to the side; a ray that ends just inside it has nothing to look on for."""
    world.reset(setup(Pose(0.0, 0.0), model=replace(DIFF_DRIVE, sensor_height=0.05)))
    assert np.isposinf(world.ranges(["r0"], np.array([math.pi / 2]), max_range)[0]).all()


def test_more_rays_than_one_call_takes_are_cast_all_the_same(world):
    world.reset(setup(Pose(0.0, 0.0)))
    measured = world.ranges(["r0"], np.zeros(20000), 10.0)[0]
    assert measured.shape == (20000,)
    np.testing.assert_allclose(measured, 3.0, atol=2e-3)


def test_robot_does_not_see_what_is_lower_than_its_range_finder(world):
    low = Obstacle("kerb", Pose(1.0, 0.0), (0.2, 0.2, 0.05))
    world.reset(setup(Pose(0.0, 0.0), obstacles=[low]))
    assert world.ranges(["r0"], np.zeros(1), 10.0)[0][0] == pytest.approx(3.0, abs=2e-3)


def test_wheels_turn_alike_on_the_spot(world):
    """A solver that stopped too early let one wheel turn 4 % slower, the other 9 % faster."""
    world.reset(setup(Pose(0.0, 0.0)))
    world.command("r0", "base", Twist(0.0, 0.0, 1.0))
    run(world, 2.0)
    engine, body = world._engine, world._robots["r0"].body
    states = engine.bullet.getJointStates(body, (0, 1), physicsClientId=engine.client)
    expected = 1.0 * DIFF_DRIVE.track / 2 / DIFF_DRIVE.wheel_radius
    assert states[0][1] == pytest.approx(-expected, rel=0.01)
    assert states[1][1] == pytest.approx(expected, rel=0.01)


def test_restored_state_leads_to_the_same_poses_bit_by_bit(world):
    """It does only with deterministicOverlappingPairs, which no other outcome here shows."""

    def scuffle():
        poses = []
        for tick in range(360):
            for index in range(9):
                world.command(f"r{index}", "base", Twist(0.5 * math.sin(0.04 * tick + index), 0.0, math.cos(index)))
            world.step()
            poses.append(world.poses().tobytes())
        return poses

    world.reset(setup(*(Pose(0.35 * (i % 3) - 0.35, 0.35 * (i // 3) - 0.35, 2.4 * i) for i in range(9)), tick=1 / 120))
    scuffle()
    engine = world._engine
    state = engine.bullet.saveState(physicsClientId=engine.client)
    first = scuffle()
    engine.bullet.restoreState(state, physicsClientId=engine.client)
    assert scuffle() == first


def test_floor_comes_after_the_walls_and_can_be_seen(world):
    """A plane that is the first body, and has no visual shape, crashes rendering by EGL."""
    world.reset(setup())
    engine = world._engine
    kinds = [
        engine.bullet.getCollisionShapeData(body, -1, physicsClientId=engine.client)[0][2]
        for body in range(engine.bullet.getNumBodies(physicsClientId=engine.client))
    ]
    assert kinds.index(engine.bullet.GEOM_PLANE) > 0
    (visual,) = engine.bullet.getVisualShapeData(kinds.index(engine.bullet.GEOM_PLANE), physicsClientId=engine.client)
    assert visual[2] == engine.bullet.GEOM_BOX


def test_robots_keep_their_wheels_on_the_floor_in_a_long_scuffle(world):
    starts = [Pose(0.45 * (i % 3) - 0.45, 0.45 * (i // 3) - 0.45, 2.4 * i) for i in range(9)]
    world.reset(setup(*starts))
    for tick in range(400):
        for index in range(9):
            world.command(f"r{index}", "base", Twist(0.5 * math.sin(0.05 * tick + index), 0.0, 2.0 * math.cos(index)))
        world.step()
    engine = world._engine
    for robot in world._robots.values():
        (_, _, z), quaternion = engine.bullet.getBasePositionAndOrientation(robot.body, physicsClientId=engine.client)
        roll, pitch, _ = engine.bullet.getEulerFromQuaternion(quaternion)
        assert z == pytest.approx(0.09, abs=0.02)
        assert abs(roll) < 0.15
        assert abs(pitch) < 0.15
