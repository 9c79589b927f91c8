from __future__ import annotations

import math

import pytest
from hypothesis import given
from hypothesis import strategies as st

from rqt_mrta_py.hooks import Outgoing
from rqt_mrta_py.model import Pose
from rqt_mrta_py.sim.messages import pose_fields
from rqt_mrta_py.sim.transforms import TransformSource, odometry_origin

NUMBERS = st.floats(-50.0, 50.0)
POSES = st.builds(Pose, NUMBERS, NUMBERS, st.floats(-3.1, 3.1))


def odometry(pose):
    return Outgoing("odom", "nav_msgs/Odometry", {"pose": {"pose": pose_fields(pose)}})


def located(pose):
    return Outgoing("pose", "geometry_msgs/PoseStamped", {"pose": pose_fields(pose)})


def spoken(outgoing):
    """Give (parent, child, x, y, yaw) of each transform of a message."""
    assert (outgoing.topic, outgoing.type) == ("/tf", "tf2_msgs/TFMessage")
    result = []
    for stamped in outgoing.fields["transforms"]:
        shift, turn = stamped["transform"]["translation"], stamped["transform"]["rotation"]
        yaw = 2 * math.atan2(turn["z"], turn["w"])
        result.append((stamped["header"]["frame_id"], stamped["child_frame_id"], shift["x"], shift["y"], yaw))
    return result


def test_odometry_origin_of_a_hand_calculated_case():
    """Half a metre ahead by odometry, at (1, 2) facing up: odometry began at (1, 1.5) facing up."""
    origin = odometry_origin(Pose(1.0, 2.0, math.pi / 2), Pose(0.5, 0.0, 0.0))
    assert (origin.x, origin.y, origin.yaw) == (pytest.approx(1.0), pytest.approx(1.5), pytest.approx(math.pi / 2))


@given(POSES, POSES)
def test_odometry_origin_brings_the_counted_pose_to_the_located_one(place, count):
    origin = odometry_origin(place, count)
    x = origin.x + math.cos(origin.yaw) * count.x - math.sin(origin.yaw) * count.y
    y = origin.y + math.sin(origin.yaw) * count.x + math.cos(origin.yaw) * count.y
    assert (x, y) == (pytest.approx(place.x, abs=1e-9), pytest.approx(place.y, abs=1e-9))
    assert math.remainder(origin.yaw + count.yaw - place.yaw, 2 * math.pi) == pytest.approx(0.0, abs=1e-9)


def test_transforms_follow_odometry_and_pair_with_the_localiser_of_the_same_moment():
    source = TransformSource("robot1")
    (outgoing,) = source.derive(3.0, [odometry(Pose(0.5, 0.0, 0.0)), located(Pose(1.0, 2.0, math.pi / 2))])
    assert [stamped["header"]["stamp"] for stamped in outgoing.fields["transforms"]] == [3.0, 3.0]
    first, second = spoken(outgoing)
    assert first[:2] == ("map", "robot1/odom")
    assert first[2:] == pytest.approx((1.0, 1.5, math.pi / 2))
    assert second[:2] == ("robot1/odom", "robot1/base_link")
    assert second[2:] == pytest.approx((0.5, 0.0, 0.0))


def test_transforms_keep_the_last_origin_between_localisations():
    source = TransformSource("robot1")
    source.derive(1.0, [located(Pose(1.0, 1.0, 0.0)), odometry(Pose(0.0, 0.0, 0.0))])
    (outgoing,) = source.derive(2.0, [odometry(Pose(0.5, 0.0, 0.0))])
    assert spoken(outgoing)[0][2:] == pytest.approx((1.0, 1.0, 0.0))
    assert source.derive(3.0, [located(Pose(2.0, 1.0, 0.0))]) == ()
    (outgoing,) = source.derive(4.0, [odometry(Pose(0.5, 0.0, 0.0))])
    assert spoken(outgoing)[0][2:] == pytest.approx((1.5, 1.0, 0.0))


def test_transforms_do_not_place_odometry_in_a_map_that_nobody_knows():
    (outgoing,) = TransformSource("robot1").derive(1.0, [odometry(Pose(1.0, 0.0, 0.0))])
    assert [entry[:2] for entry in spoken(outgoing)] == [("robot1/odom", "robot1/base_link")]


def test_transforms_are_silent_without_odometry():
    source = TransformSource("robot1")
    assert source.derive(1.0, []) == ()
    assert source.derive(2.0, [located(Pose(1.0, 0.0, 0.0))]) == ()


def test_transforms_take_fields_that_are_left_out_as_zero():
    """As the codec does: a stranger's odometry need not spell them."""
    source = TransformSource("robot1")
    counted = Outgoing(
        "odom", "nav_msgs/Odometry", {"pose": {"pose": {"position": {"x": 0.5}, "orientation": {"w": 1.0}}}}
    )
    found = Outgoing("pose", "geometry_msgs/PoseStamped", {"pose": {"orientation": {"w": 1.0}}})
    (outgoing,) = source.derive(1.0, [counted, found])
    origin, base = outgoing.fields["transforms"]
    assert origin["transform"]["translation"] == {"x": -0.5, "y": 0.0}
    assert base["transform"] == {"translation": {"x": 0.5}, "rotation": {"w": 1.0}}
