"""What every world promises, whatever is behind it; of loose bodies in ``test_world_contract_of_bodies``."""

from __future__ import annotations

import math
import os
import subprocess
import sys
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from rqt_mrta_py.errors import SimError
from rqt_mrta_py.hooks import Body, Contact
from rqt_mrta_py.model import Arena, Obstacle, Pose, Twist
from rqt_mrta_py.sim.robot_models import DIFF_DRIVE
from tests.sim.worlds import TICK, WORLDS, crowd_hash, run, setup

FRONT = DIFF_DRIVE.length / 2
BLOCK = Body("block", (0.3, 0.0, 0.1), 0.0, (0.2, 0.2, 0.2), 0.5)


def test_world_puts_robots_at_their_starts_in_the_order_of_the_setup(world):
    starts = [Pose(1.0, -2.0, 3.0), Pose(-1.0, 0.5, -1.5)]
    world.reset(setup(*starts))
    assert world.poses().shape == (2, 3)
    assert world.poses().dtype == np.float64
    np.testing.assert_allclose(world.poses(), [[1.0, -2.0, 3.0], [-1.0, 0.5, -1.5]], atol=1e-9)


def test_world_without_robots_has_poses_of_no_rows(world):
    world.reset(setup())
    world.step()
    assert world.poses().shape == (0, 3)


def test_poses_are_the_callers_own(world):
    world.reset(setup(Pose(0.0, 0.0)))
    world.poses()[:] = 9.0
    np.testing.assert_allclose(world.poses(), [[0.0, 0.0, 0.0]], atol=1e-9)


@pytest.mark.parametrize("yaw", [0.0, 1.0, -2.5])
def test_robot_stays_where_it_is_without_a_command(world, yaw):
    """Wheels that the solver did not hold once let it creep by 6 mm/s."""
    world.reset(setup(Pose(0.0, 0.0, yaw)))
    run(world, 10.0)
    np.testing.assert_allclose(world.poses(), [[0.0, 0.0, yaw]], atol=2e-3)


def test_robot_turns_as_commanded_half_a_second_from_rest(world):
    """Casters at the height of the wheels once let it turn at a third of the rate."""
    world.reset(setup(Pose(0.0, 0.0)))
    world.command("r0", "base", Twist(0.4, 0.0, 0.6))
    run(world, 0.45)
    before = world.poses()[0]
    run(world, 0.10)
    x, y, yaw = world.poses()[0] - before
    assert yaw / 0.10 == pytest.approx(0.6, rel=0.02)
    assert math.hypot(x, y) / 0.10 == pytest.approx(0.4, rel=0.02)


@pytest.mark.parametrize("speed", [0.2, 0.5, -0.3])
def test_robot_drives_straight_at_the_commanded_speed(world, speed):
    world.reset(setup(Pose(0.0, 0.0, 0.5)))
    world.command("r0", "base", Twist(speed, 0.0, 0.0))
    run(world, 0.5)
    before = world.poses()[0]
    run(world, 2.0)
    x, y, yaw = world.poses()[0] - before
    assert math.cos(0.5) * x + math.sin(0.5) * y == pytest.approx(2.0 * speed, rel=0.005)
    assert math.cos(0.5) * y - math.sin(0.5) * x == pytest.approx(0.0, abs=0.01)
    assert yaw == pytest.approx(0.0, abs=0.01)


def test_robot_turns_on_the_spot_without_leaving_it(world):
    world.reset(setup(Pose(1.0, 1.0)))
    world.command("r0", "base", Twist(0.0, 0.0, 1.0))
    run(world, 3.0)
    x, y, yaw = world.poses()[0]
    assert math.hypot(x - 1.0, y - 1.0) < 0.02
    assert yaw == pytest.approx(3.0, rel=0.03)


def test_differential_drive_cannot_go_sideways(world):
    world.reset(setup(Pose(0.0, 0.0)))
    world.command("r0", "base", Twist(0.0, 0.5, 0.0))
    run(world, 1.0)
    np.testing.assert_allclose(world.poses(), [[0.0, 0.0, 0.0]], atol=2e-3)


def test_command_lasts_until_the_next_one(world):
    world.reset(setup(Pose(-2.0, 0.0)))
    world.command("r0", "base", Twist(0.4, 0.0, 0.0))
    run(world, 2.0)
    assert world.poses()[0, 0] > -1.3
    world.command("r0", "base", Twist())
    run(world, 0.5)
    before = world.poses()
    run(world, 1.0)
    np.testing.assert_allclose(world.poses(), before, atol=1e-3)


def test_wall_stops_a_robot(world):
    world.reset(setup(Pose(2.0, 0.0)))
    world.command("r0", "base", Twist(0.5, 0.0, 0.0))
    run(world, 4.0)
    assert world.poses()[0, 0] == pytest.approx(3.0 - FRONT, abs=0.01)
    assert world.contacts() == (Contact("r0", "wall"),)


@pytest.mark.parametrize("shape", ["box", "cylinder"])
def test_obstacle_stops_a_robot(world, shape):
    world.reset(setup(Pose(-1.0, 0.0), obstacles=[Obstacle("rock", Pose(0.5, 0.0), (0.6, 0.6, 0.4), shape)]))
    world.command("r0", "base", Twist(0.5, 0.0, 0.0))
    run(world, 4.0)
    assert world.poses()[0, 0] == pytest.approx(0.5 - 0.3 - FRONT, abs=0.01)
    assert world.contacts() == (Contact("r0", "rock"),)


def test_robots_that_meet_head_on_block_each_other(world):
    world.reset(setup(Pose(-0.5, 0.0, 0.0), Pose(0.5, 0.0, math.pi)))
    for robot in ("r0", "r1"):
        world.command(robot, "base", Twist(0.4, 0.0, 0.0))
    run(world, 3.0)
    poses = world.poses()
    assert math.hypot(*(poses[0] - poses[1])[:2]) > DIFF_DRIVE.width - 0.01
    assert poses[0, 0] == pytest.approx(0.0, abs=0.35)
    assert poses[1, 0] == pytest.approx(0.0, abs=0.35)
    assert Contact("r0", "r1") in world.contacts()


def test_nothing_touches_while_apart(world):
    world.reset(setup(Pose(-1.0, 0.0), Pose(1.0, 0.0)))
    run(world, 0.5)
    assert world.contacts() == ()


def test_contacts_name_each_pair_once_in_order(world):
    world.reset(setup(Pose(2.5, 0.0), Pose(2.0, 0.0), Pose(1.5, 0.0)))
    for robot in ("r2", "r1", "r0"):
        world.command(robot, "base", Twist(0.5, 0.0, 0.0))
    run(world, 3.0)
    contacts = world.contacts()
    assert list(contacts) == sorted(set(contacts))
    assert {Contact("r0", "r1"), Contact("r0", "wall"), Contact("r1", "r2")} <= set(contacts)
    assert all(contact.first < contact.second for contact in contacts)


def test_frozen_robot_ignores_its_commands(world):
    world.reset(setup(Pose(0.0, 0.0)))
    world.freeze("r0", True)
    world.command("r0", "base", Twist(0.5, 0.0, 1.0))
    run(world, 2.0)
    np.testing.assert_allclose(world.poses(), [[0.0, 0.0, 0.0]], atol=1e-3)


def test_frozen_robot_stops_at_once_from_full_speed(world):
    world.reset(setup(Pose(0.0, 0.0)))
    world.command("r0", "base", Twist(0.5, 0.0, 0.0))
    run(world, 1.0)
    before = world.poses()
    world.freeze("r0", True)
    run(world, 2.0)
    np.testing.assert_allclose(world.poses(), before, atol=0.03)


def test_frozen_robot_stands_still_under_a_push(world):
    world.reset(setup(Pose(0.0, 0.0, math.pi / 2), Pose(-0.8, 0.0), Pose(0.8, 0.05, math.pi)))
    world.freeze("r0", True)
    world.command("r1", "base", Twist(0.5, 0.0, 0.0))
    run(world, 4.0)
    assert Contact("r0", "r1") in world.contacts()
    world.command("r2", "base", Twist(0.5, 0.0, 0.0))
    run(world, 4.0)
    np.testing.assert_allclose(world.poses()[0], [0.0, 0.0, math.pi / 2], atol=2e-3)


def test_robot_obeys_its_newest_command_once_it_may_move_again(world):
    world.reset(setup(Pose(0.0, 0.0)))
    world.freeze("r0", True)
    world.freeze("r0", True)
    world.command("r0", "base", Twist(0.4, 0.0, 0.0))
    run(world, 1.0)
    world.freeze("r0", False)
    world.freeze("r0", False)
    run(world, 1.0)
    assert world.poses()[0, 0] == pytest.approx(0.4, abs=0.05)


def test_ranges_are_the_distances_calculated_by_hand(world):
    obstacles = [
        Obstacle("box", Pose(2.0, 1.0), (0.4, 0.6, 0.5), "box"),
        Obstacle("post", Pose(1.0, 2.5), (0.5, 0.5, 0.5), "cylinder"),
    ]
    world.reset(setup(Pose(1.0, 1.0, 0.0), Pose(-0.5, 1.0, 0.0), obstacles=obstacles))
    measured = world.ranges(["r0"], np.array([0.0, math.pi / 2, math.pi, -math.pi / 2]), 10.0)[0]
    expected = [
        2.0 - 0.2 - 1.0,  # near face of the box
        2.5 - 0.25 - 1.0,  # near side of the post
        1.5 - FRONT,  # front of the other robot
        1.0 + 3.0,  # wall below
    ]
    np.testing.assert_allclose(measured, expected, atol=3e-3)


def test_ranges_turn_with_the_robot(world):
    world.reset(setup(Pose(0.0, 0.0, math.pi / 4)))
    across = 3.0 * math.sqrt(2.0)
    measured = world.ranges(["r0"], np.array([0.0, math.pi / 4, math.pi / 2, -math.pi / 4]), 10.0)[0]
    np.testing.assert_allclose(measured, [across, 3.0, across, 3.0], atol=2e-3)


def test_ranges_meet_a_turned_box_on_its_face(world):
    box = Obstacle("box", Pose(1.0, 0.0, math.pi / 4), (0.4, 0.4, 0.5), "box")
    world.reset(setup(Pose(0.0, 0.0), obstacles=[box]))
    corner = 1.0 - 0.2 * math.sqrt(2.0)
    # Beside the corner the face recedes at 45 degrees: x + |y| of the face's points, seen from the corner, is fixed.
    bearing = 0.1
    expected = [corner, corner / (math.cos(bearing) - math.sin(bearing))]
    np.testing.assert_allclose(world.ranges(["r0"], np.array([0.0, bearing]), 10.0)[0], expected, atol=3e-3)


def test_ranges_are_infinite_where_nothing_is_near_enough(world):
    world.reset(setup(Pose(0.0, 0.0)))
    assert world.ranges(["r0"], np.array([0.0, math.pi / 4]), 3.1)[0][0] == pytest.approx(3.0, abs=2e-3)
    assert np.isposinf(world.ranges(["r0"], np.array([0.0, math.pi / 4]), 2.9)[0]).all()


def test_robot_does_not_see_itself(world):
    world.reset(setup(Pose(0.0, 0.0)))
    measured = world.ranges(["r0"], np.linspace(-math.pi, math.pi, 90), 2.0)[0]
    assert np.isposinf(measured).all()


def test_robot_still_sees_the_wall_that_it_touches(world):
    world.reset(setup(Pose(2.0, 0.0)))
    world.command("r0", "base", Twist(0.5, 0.0, 0.0))
    run(world, 4.0)
    assert world.ranges(["r0"], np.zeros(1), 4.0)[0][0] == pytest.approx(FRONT, abs=0.02)


def test_ranges_take_no_rays(world):
    world.reset(setup(Pose(0.0, 0.0)))
    assert world.ranges(["r0"], np.zeros(0), 4.0)[0].shape == (0,)


def test_ranges_of_several_robots_are_those_of_each_in_the_order_asked(world):
    rock = Obstacle("rock", Pose(0.5, 0.5, 0.3), (0.5, 0.3, 0.4))
    starts = [Pose(0.0, -1.0, 0.2), Pose(1.5, 1.0, 2.0), Pose(-1.0, 0.3, -1.0)]
    world.reset(setup(*starts, obstacles=[rock]))
    bearings = np.linspace(-3.0, 3.0, 25)
    alone = np.array([world.ranges([f"r{index}"], bearings, 4.0)[0] for index in range(3)])
    np.testing.assert_array_equal(world.ranges(["r2", "r0"], bearings, 4.0), alone[[2, 0]])
    assert world.ranges([], bearings, 4.0).shape == (0, 25)


def test_ranges_of_an_unknown_robot_are_refused_by_name(world):
    world.reset(setup(Pose(0.0, 0.0)))
    with pytest.raises(SimError, match="robot r7: not in this world; there are: r0"):
        world.ranges(["r0", "r7"], np.zeros(3), 4.0)


def test_ranges_do_not_change_what_they_are_given(world):
    world.reset(setup(Pose(0.0, 0.0), Pose(1.0, 0.0)))
    bearings = np.array([2.0, -9.0, 0.0])
    world.ranges(["r1", "r0"], bearings, 4.0)
    assert bearings.tolist() == [2.0, -9.0, 0.0]


def test_bearings_may_be_in_any_order_and_beyond_a_turn(world):
    world.reset(setup(Pose(1.0, 0.0), Pose(2.0, 0.0)))
    near, far = 1.0 - FRONT, 4.0
    measured = world.ranges(["r0"], np.array([2 * math.pi, math.pi, 0.0, -3 * math.pi, 0.0, -2 * math.pi]), 10.0)[0]
    np.testing.assert_allclose(measured, [near, far, near, far, near, near], atol=3e-3)


def test_robots_that_start_in_each_other_come_apart_and_stay_in_the_arena(world):
    world.reset(setup(Pose(0.0, 0.0), Pose(0.1, 0.05, 1.0), Pose(2.9, -1.0, 0.5)))
    run(world, 2.0)
    poses = world.poses()
    assert np.isfinite(poses).all()
    assert math.hypot(*(poses[0] - poses[1])[:2]) > DIFF_DRIVE.width - 0.01
    assert np.abs(poses[:, :2]).max() < 3.0 - DIFF_DRIVE.width / 2 + 0.01


@pytest.mark.parametrize(
    ("robot", "actuator", "value", "message"),
    [
        ("r7", "base", Twist(), r"robot r7: not in this world; there are: r0"),
        ("r0", "arm", 1.0, r"robot r0: no actuator 'arm'"),
        ("r0", "base", 1.0, r"robot r0: base takes a Twist of finite numbers \(got 1.0\)"),
        ("r0", "base", Twist(math.nan, 0.0, 0.0), r"robot r0: base takes a Twist of finite numbers"),
        ("r0", "base", Twist(0.0, 0.0, math.inf), r"robot r0: base takes a Twist of finite numbers"),
    ],
)
def test_command_that_makes_no_sense_is_refused(world, robot, actuator, value, message):
    world.reset(setup(Pose(0.0, 0.0)))
    with pytest.raises(SimError, match=message):
        world.command(robot, actuator, value)


def test_unknown_drive_is_refused_by_name(world):
    rail = replace(DIFF_DRIVE, name="tram", drive="rail")
    with pytest.raises(SimError, match=r"robot r0: .*cannot build drive 'rail' of model tram"):
        world.reset(setup(Pose(0.0, 0.0), model=rail))
    assert "drive:rail" not in world.capabilities
    assert "drive:differential" in world.capabilities


def test_id_given_twice_is_refused(world):
    rock = Obstacle("r0", Pose(1.0, 1.0), (0.2, 0.2, 0.2))
    with pytest.raises(SimError, match="robot r0: the id is taken"):
        world.reset(setup(Pose(0.0, 0.0), obstacles=[rock]))


def test_unknown_shape_is_refused_by_name(world):
    star = Obstacle("star", Pose(1.0, 1.0), (0.2, 0.2, 0.2), "star")
    with pytest.raises(SimError, match="obstacle star: no shape 'star'; give box or cylinder"):
        world.reset(setup(obstacles=[star]))


@pytest.mark.parametrize("tick", [0.0, -0.05, math.nan, math.inf])
def test_tick_that_is_no_time_is_refused(world, tick):
    with pytest.raises(SimError, match="tick"):
        world.reset(setup(Pose(0.0, 0.0), tick=tick))


def test_world_that_is_not_built_or_closed_says_so(world):
    for call in (world.step, world.contacts, world.bodies):
        with pytest.raises(SimError, match="call reset first"):
            call()
    world.reset(setup(Pose(0.0, 0.0)))
    world.close()
    world.close()
    for call in (world.step, world.contacts, world.bodies):
        with pytest.raises(SimError, match="call reset first"):
            call()


def test_world_can_be_built_again_after_it_was_closed(world):
    world.reset(setup(Pose(0.0, 0.0)))
    world.close()
    world.reset(setup(Pose(1.0, 0.0)))
    world.step()
    assert world.poses()[0, 0] == pytest.approx(1.0, abs=1e-3)


def test_reset_leaves_nothing_of_before(world):
    world.reset(setup(Pose(0.0, 0.0), Pose(1.0, 0.0), obstacles=[Obstacle("rock", Pose(0, 1), (0.2, 0.2, 0.2))]))
    world.add_body(BLOCK)
    world.freeze("r0", True)
    world.reset(setup(Pose(0.0, 0.0), arena=Arena(-1.0, -1.0, 1.0, 1.0)))
    assert world.bodies() == {}
    assert world.poses().shape == (1, 3)
    assert world.ranges(["r0"], np.array([math.pi / 2]), 5.0)[0][0] == pytest.approx(1.0, abs=2e-3)
    world.command("r0", "base", Twist(0.4, 0.0, 0.0))
    run(world, 1.0)
    assert world.poses()[0, 0] > 0.3


def test_equal_runs_are_equal_in_fresh_processes_and_in_used_ones(world_name, root: Path):
    first, other = WORLDS[world_name](), WORLDS[world_name]()
    try:
        other.reset(setup(Pose(0.0, 0.0)))
        other.command("r0", "base", Twist(0.3, 0.0, 0.1))
        run(other, 1.0)
        hashes = [crowd_hash(first), crowd_hash(first), crowd_hash(other)]
    finally:
        first.close()
        other.close()
    for seed in ("0", "1"):
        environment = {**os.environ, "PYTHONHASHSEED": seed}
        command = [sys.executable, "-m", "tests.sim.worlds", world_name]
        done = subprocess.run(command, cwd=root, env=environment, capture_output=True, text=True, check=True)
        hashes.append(done.stdout)
    assert len(set(hashes)) == 1


def test_observing_changes_nothing(world):
    assert crowd_hash(world, observed=True) == crowd_hash(world)


def test_robot_turned_by_a_whole_tick_counts_time_by_ticks(world):
    world.reset(setup(Pose(0.0, 0.0), tick=2 * TICK))
    world.command("r0", "base", Twist(0.0, 0.0, 1.0))
    for _ in range(20):
        world.step()
    assert world.poses()[0, 2] == pytest.approx(2.0, rel=0.05)


def test_removed_robot_is_met_and_seen_by_nobody_and_stays_in_the_list(world):
    world.reset(setup(Pose(0.0, 0.0), Pose(0.5, 0.0, 1.0), Pose(1.5, 0.0, math.pi)))
    run(world, 0.2)
    before = world.poses()[1]
    world.remove_robot("r1")
    assert world.poses().shape == (3, 3)
    assert world.ranges(["r0"], np.zeros(1), 4.0)[0][0] == pytest.approx(1.5 - FRONT, abs=3e-3)
    world.command("r0", "base", Twist(0.4, 0.0, 0.0))
    run(world, 1.0)
    assert world.contacts() == ()
    run(world, 3.0)
    assert world.contacts() == (Contact("r0", "r2"),)
    assert world.poses()[0, 0] > 1.0
    np.testing.assert_array_equal(world.poses()[1], before)


def test_removed_robot_does_nothing_whatever_it_is_told(world):
    world.reset(setup(Pose(0.0, 0.0), Pose(1.0, 0.0)))
    world.remove_robot("r0")
    before = world.poses()
    world.command("r0", "base", Twist(0.3, 0.0, 1.0))
    world.freeze("r0", True)
    world.freeze("r0", False)
    world.remove_robot("r0")
    run(world, 1.0)
    np.testing.assert_allclose(world.poses(), before, atol=2e-3)
    with pytest.raises(SimError, match="robot r0: base takes a Twist"):
        world.command("r0", "base", 1.0)
    assert world.ranges(["r1"], np.array([math.pi]), 5.0)[0][0] == pytest.approx(4.0, abs=3e-3)


def test_robot_that_is_not_there_cannot_be_removed(world):
    world.reset(setup(Pose(0.0, 0.0)))
    with pytest.raises(SimError, match="robot r7: not in this world"):
        world.remove_robot("r7")


def test_removed_robots_are_back_after_a_reset(world):
    world.reset(setup(Pose(0.0, 0.0), Pose(0.5, 0.0)))
    world.remove_robot("r1")
    world.reset(setup(Pose(0.0, 0.0), Pose(0.5, 0.0)))
    assert world.ranges(["r0"], np.zeros(1), 4.0)[0][0] == pytest.approx(0.5 - FRONT, abs=3e-3)
    world.command("r1", "base", Twist(0.3, 0.0, 0.0))
    run(world, 1.0)
    assert world.poses()[1, 0] > 0.6
