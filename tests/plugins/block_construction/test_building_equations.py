"""What builders compute, against numbers worked out by hand."""

from __future__ import annotations

import math

import numpy as np
import pytest
from block_construction.building.actions import Ending, Kind
from block_construction.building.eyes import Seen, lies_in
from block_construction.building.follower import Limits, Moment, go_to, lag, moment_of, towards
from block_construction.building.gripping import CENTRED, Grip, grip_of, stand_before, touching
from block_construction.building.pose_filter import PoseFilter, composed, corrected_gain, moved, relative
from block_construction.building.procedures import assembly, manipulation, withdrawal
from block_construction.building.routes import stand_off
from block_construction.building.site_map import SiteMap, cells_around, is_in_lane
from block_construction.building.slot import block_task
from block_construction.team.timed_way import TimedPoint

from rqt_mrta_py.model import Pose, Twist
from rqt_mrta_py.sim.robot_models import MECANUM_ARM
from tests.plugins.block_construction.toy_builder import a_task

ARM = MECANUM_ARM.arm
UP = math.pi / 2
FLOOR = -0.550053
"""asin((0.035 - 0.20 + 0.05) / 0.22): where the magnet is as high as the middle of a block on the floor [rad]."""
REACH = 0.367550
"""0.22 cos(-0.550053) + 0.12 + 0.06: there its face is so far ahead [m]."""
LIMITS = Limits(0.03, 0.08)


def close(x, y, yaw=0.0, abs=1e-6):
    return Pose(pytest.approx(x, abs=abs), pytest.approx(y, abs=abs), pytest.approx(yaw, abs=abs))


def test_manipulation_is_position_lower_approach_raise_retreat_raise():
    actions = manipulation(ARM, 0.035)
    lifted = math.asin((0.035 + 0.02 - 0.15) / 0.22)
    contact = REACH + 0.035
    assert [(each.kind, each.magnet, each.speed) for each in actions] == [
        (Kind.POSITION, False, 0.03),
        (Kind.LOWER, False, 0.01),
        (Kind.APPROACH, False, 0.03),
        (Kind.APPROACH, False, 0.01),
        (Kind.APPROACH, True, 0.01),
        (Kind.RAISE, True, 0.01),
        (Kind.RETREAT, True, 0.03),
        (Kind.RAISE, True, 0.01),
    ]
    assert [each.angle for each in actions] == pytest.approx([UP, *[FLOOR] * 4, lifted, lifted, UP], abs=1e-5)
    near = [each.distance for each in actions if each.kind is Kind.APPROACH]
    assert near == pytest.approx([contact + 0.03, contact - 0.003, contact - 0.003], abs=1e-5)
    assert [each.distance for each in actions if each.kind is not Kind.APPROACH] == [0.55, 0.55, None, 0.55, 0.55]
    assert [number for number, each in enumerate(actions) if each.ending is Ending.HELD] == [4]


def test_assembly_lowers_before_it_approaches_and_lets_go_before_it_retreats():
    """On level 4 the block's middle is 0.245 m high, 0.095 m above where the arm is level; at first 1 cm higher."""
    actions = assembly(ARM, 0.245, 0.035)
    kinds = [each.kind for each in actions]
    assert kinds == [
        *(Kind.POSITION, Kind.LOWER, Kind.APPROACH, Kind.APPROACH, Kind.LOWER, Kind.LOWER, Kind.LOWER),
        *(Kind.RETREAT, Kind.RETREAT, Kind.RAISE),
    ]
    assert [each.magnet for each in actions] == [True] * 6 + [False] * 4
    assert actions[1].angle == pytest.approx(math.asin(0.105 / 0.22))
    over = 0.22 * math.cos(math.asin(0.105 / 0.22)) + 0.18 + 0.035
    assert actions[3].distance == pytest.approx(over)
    assert [each.distance for each in actions[4:7]] == [None] * 3
    assert actions[5].angle == actions[6].angle == pytest.approx(math.asin(0.095 / 0.22))
    assert actions[6].ending is Ending.LET_GO
    assert actions[-1].angle == UP


def test_interrupted_robot_goes_back_before_it_raises_its_arm():
    retreat, lift = withdrawal(ARM, 0.1, magnet=True)
    assert (retreat.kind, retreat.angle, retreat.distance, retreat.magnet) == (Kind.RETREAT, 0.1, 0.55, True)
    assert (lift.kind, lift.angle) == (Kind.RAISE, UP)


def test_level_that_the_arm_does_not_reach_is_refused():
    with pytest.raises(ValueError, match="the arm does not reach"):
        assembly(ARM, 0.395, 0.035)


def test_no_block_is_held_nearer_than_where_it_touches_the_magnet():
    """Its middle is half its width of 7 cm behind its face."""
    assert touching(Grip(0.032, 0.01, 0.02)) == (0.035, 0.01, 0.02)
    assert touching(Grip(0.041, 0.01, 0.02)) == (0.041, 0.01, 0.02)


def test_grip_is_where_the_block_is_as_seen_from_the_magnet():
    """A robot that looks up at (1, 1) with its face 0.4 m ahead; the block lies 1 cm to its left and 3.5 cm farther."""
    grip = grip_of(Pose(1.0, 1.0, UP), 0.4, Pose(0.99, 1.435, UP + 0.02))
    assert grip == (pytest.approx(0.035), pytest.approx(0.01), pytest.approx(0.02))


def test_robot_stands_where_its_block_comes_to_lie_right():
    assert stand_before(Pose(2.0, 1.0, 0.0), 0.4, CENTRED) == close(1.565, 1.0)
    # Held 1 cm to the left, the robot stands 1 cm to the right: below, as it looks along x.
    assert stand_before(Pose(2.0, 1.0, 0.0), 0.4, Grip(0.035, 0.01, 0.0)) == close(1.565, 0.99)
    block, grip = Pose(0.3, -0.4, 2.0), Grip(0.041, -0.02, 0.05)
    robot = stand_before(block, 0.37, grip)
    assert grip_of(robot, 0.37, block) == (pytest.approx(0.041), pytest.approx(-0.02), pytest.approx(0.05))


def test_robot_stands_55_cm_before_what_it_places():
    assert stand_off(Pose(1.02, 0.86, UP)) == close(1.02, 0.31, UP)


def test_half_of_a_difference_is_believed_where_both_are_as_sure():
    assert corrected_gain(4.0, 4.0) == 0.5
    assert corrected_gain(1.0, 3.0) == 0.25


def test_velocity_in_the_robots_own_frame_leads_on():
    assert moved(Twist(0.03, 0.01, 0.0), 2.0) == close(0.06, 0.02)
    # Ahead while it turns by 0.2: along the direction half way.
    assert moved(Twist(1.0, 0.0, 0.2), 1.0) == close(math.cos(0.1), math.sin(0.1), 0.2)
    there = Pose(1.0, 2.0, UP)
    assert composed(there, Pose(0.5, 0.1, 0.3)) == close(0.9, 2.5, UP + 0.3)
    assert relative(there, Pose(0.9, 2.5, UP + 0.3)) == close(0.5, 0.1, 0.3)


def test_filter_of_exact_fixes_says_what_they_say():
    fused = PoseFilter()
    for tick in range(100):
        true = Pose(0.003 * tick, 1.0, 0.0)
        assert fused.step(0.1 * tick, true, None, Twist(0.03)) == close(true.x, true.y, abs=1e-9)


def test_filter_of_a_robot_that_stands_averages():
    """Of the mean of 300 fixes that are off by up to 3 cm, the standard deviation is 0.03 / sqrt(900) = 1 mm."""
    random = np.random.default_rng(5)
    off = []
    for _ in range(20):
        fused = PoseFilter()
        for tick in range(300):
            dx, dy = random.uniform(-0.03, 0.03, 2)
            found = fused.step(0.1 * tick, Pose(1.0 + dx, 2.0 + dy, 0.0), None, Twist())
        off += [found.x - 1.0, found.y - 2.0]
        assert 0.0007 < fused.doubt < 0.0015
    assert np.std(off) < 0.0015


def test_filter_goes_on_by_the_wheels_where_no_fix_comes():
    fused = PoseFilter()
    fix = Pose(1.0, 2.0, UP)
    fused.step(0.0, fix, Pose(5.0, 5.0, 0.0), Twist())
    # In their own frame the wheels counted 0.2 m ahead and 0.1 m to the left.
    assert fused.step(1.0, fix, Pose(5.2, 5.1, 0.0), Twist()) == close(0.9, 2.2, UP)
    assert fused.doubt > 0.001


def test_filter_notices_that_the_robot_was_moved():
    fused = PoseFilter()
    for tick in range(50):
        fused.step(0.1 * tick, Pose(1.0, 2.0, 0.0), None, Twist())
    assert fused.step(5.0, Pose(1.4, 2.0, 0.0), None, Twist()) == close(1.4, 2.0, abs=1e-3)


def test_way_is_driven_at_its_times():
    way = (TimedPoint(10.0, 0.0, 0.0), TimedPoint(20.0, 0.3, 0.0), TimedPoint(30.0, 0.3, 0.2))
    assert moment_of(way, 5.0) == (0.0, 0.0, 0.0, 0.0)
    assert moment_of(way, 15.0) == pytest.approx((0.15, 0.0, 0.03, 0.0))
    assert moment_of(way, 25.0) == pytest.approx((0.3, 0.1, 0.0, 0.02))
    assert moment_of(way, 30.0) == (0.3, 0.2, 0.0, 0.0)
    assert lag(moment_of(way, 15.0), Pose(0.12, 0.04)) == pytest.approx(0.05)


def test_robot_turns_while_it_drives_and_exceeds_no_limit():
    """Looking up, a way to the right is to its own right."""
    twist = towards(Pose(0.0, 0.0, UP), Moment(0.0, 0.0, 0.02, 0.0), 0.0, LIMITS)
    assert (twist.vx, twist.vy, twist.wz) == (pytest.approx(0.0), pytest.approx(-0.02), -0.08)
    far = go_to(Pose(0.0, 0.0, 0.0), Pose(3.0, 4.0, 0.01), LIMITS)
    assert (far.vx, far.vy, far.wz) == (pytest.approx(0.018), pytest.approx(0.024), pytest.approx(0.02))
    near = go_to(Pose(0.0, 0.0, 0.0), Pose(0.002, 0.0, 0.0), LIMITS)
    assert 0.0 < near.vx < 0.01


def test_block_as_long_as_its_slot_lies_in_it_within_two_centimetres_on_its_level():
    slot = block_task(a_task(level=2))
    assert lies_in(Seen(1.02, 0.879, 0.105, False, "block3"), slot)
    assert not lies_in(Seen(1.02, 0.881, 0.105, False, "block3"), slot)
    assert not lies_in(Seen(1.02, 0.86, 0.035, False, "block3"), slot)
    assert not lies_in(Seen(1.02, 0.86, 0.105, True, "block3"), slot)
    assert not lies_in(Seen(1.02, 0.86, 0.105, False, "block1"), slot)


@pytest.mark.parametrize(
    ("x", "y", "z", "level", "bars"),
    [
        (1.02, 0.60, 0.035, 1, True),
        (1.20, 0.60, 0.035, 1, True),
        (1.25, 0.60, 0.035, 1, False),
        (1.02, 0.05, 0.035, 1, False),
        (1.02, 0.98, 0.035, 1, False),
        (1.05, 0.87, 0.035, 1, True),
        (1.05, 0.87, 0.035, 2, False),
        (1.02, 0.60, 0.035, 2, True),
    ],
)
def test_what_lies_before_a_slot_or_askew_in_it_is_in_the_way(x, y, z, level, bars):
    """The slot at (1.02, 0.86) is reached from below; what lies under the slot of level 2 supports it."""
    assert is_in_lane(Seen(x, y, z, False, "block3"), block_task(a_task(level=level))) is bars


def test_loose_block_takes_up_the_cells_around_it():
    """With the corner at (0, 0), a block at (0.12, 0.04) reaches from 0.05 to 0.19 m and from -0.03 to 0.11 m."""
    assert cells_around(Seen(0.12, 0.04, 0.03, False, "block3"), 0.0, 0.0) == {
        (column, row) for column in (1, 2, 3) for row in (0, 1, 2)
    }


def test_site_map_knows_what_others_have_placed_until_it_is_seen_elsewhere():
    first, second = block_task(a_task()), block_task(a_task(2, level=2))
    site = SiteMap()
    site.slots.update({1: first, 2: second})
    site.hear(frozenset({1}))
    assert site.covered == {(3, 1), (4, 1), (5, 1)}
    assert site.look({"b1": Seen(1.02, 0.86, 0.035, False, "block3")}) == ()
    away = {"b1": Seen(0.3, 1.8, 0.035, False, "block3")}
    assert site.look(away) == ()
    assert site.look(away) == (1,)
    assert (site.standing, site.missing) == (frozenset(), {1})
    assert site.covered == cells_around(away["b1"], first.site[0], first.site[1])
    site.put(1, "b2")
    assert (site.standing, site.missing) == ({1}, set())
