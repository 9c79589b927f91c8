from __future__ import annotations

import math

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from rqt_mrta_py.errors import SimError
from rqt_mrta_py.hooks import Outgoing, TeamOutgoing
from rqt_mrta_py.model import Pose
from rqt_mrta_py.sim.sensing.mount import RobotSaid
from rqt_mrta_py.sim.sensing.transforms import Transforms, odometry_origins
from tests.sim.expanding import nested

NUMBERS = st.floats(-50.0, 50.0)
POSES = st.builds(Pose, NUMBERS, NUMBERS, st.floats(-3.1, 3.1))


def pose_fields(pose):
    turn = {"z": math.sin(pose.yaw / 2), "w": math.cos(pose.yaw / 2)}
    return {"position": {"x": pose.x, "y": pose.y}, "orientation": turn}


def odometry(pose):
    return Outgoing("odom", "nav_msgs/Odometry", {"pose": {"pose": pose_fields(pose)}})


def located(pose):
    return Outgoing("pose", "geometry_msgs/PoseStamped", {"pose": pose_fields(pose)})


def columns_of(within, poses):
    return {
        f"{within}/position/x": np.array([pose.x for pose in poses]),
        f"{within}/position/y": np.array([pose.y for pose in poses]),
        f"{within}/orientation/z": np.array([math.sin(pose.yaw / 2) for pose in poses]),
        f"{within}/orientation/w": np.array([math.cos(pose.yaw / 2) for pose in poses]),
    }


def derive(transforms, now, *messages):
    """Let robot1 say messages; give those on ``/tf`` that follow."""
    if messages:
        transforms.hear(RobotSaid("robot1", messages))
    return transforms.due(np.array([now]))


def spoken(outgoing, row=0):
    """Give (parent, child, x, y, yaw) of each transform of a message."""
    assert (outgoing.topic, outgoing.type) == ("/tf", "tf2_msgs/TFMessage")
    result = []
    for stamped in nested(outgoing, row)["transforms"]:
        shift, turn = stamped["transform"]["translation"], stamped["transform"]["rotation"]
        yaw = 2 * math.atan2(turn["z"], turn["w"])
        result.append((stamped["header"]["frame_id"], stamped["child_frame_id"], shift["x"], shift["y"], yaw))
    return result


def test_odometry_origin_of_a_hand_calculated_case():
    """Half a metre ahead by odometry, at (1, 2) facing up: odometry began at (1, 1.5) facing up."""
    origin = odometry_origins(np.array([[1.0], [2.0], [math.pi / 2]]), np.array([[0.5], [0.0], [0.0]]))
    assert origin[:, 0] == pytest.approx([1.0, 1.5, math.pi / 2])


@given(POSES, POSES)
def test_odometry_origin_brings_the_counted_pose_to_the_located_one(place, count):
    ((ox,), (oy,), (turn,)) = odometry_origins(*(np.array([[p.x], [p.y], [p.yaw]]) for p in (place, count)))
    x = ox + math.cos(turn) * count.x - math.sin(turn) * count.y
    y = oy + math.sin(turn) * count.x + math.cos(turn) * count.y
    assert (x, y) == (pytest.approx(place.x, abs=1e-9), pytest.approx(place.y, abs=1e-9))
    assert math.remainder(turn + count.yaw - place.yaw, 2 * math.pi) == pytest.approx(0.0, abs=1e-9)


def test_transforms_follow_odometry_and_pair_with_the_localiser_of_the_same_moment():
    said = [odometry(Pose(0.5, 0.0, 0.0)), located(Pose(1.0, 2.0, math.pi / 2))]
    (outgoing,) = derive(Transforms(["robot1"]), 3.0, *said)
    assert outgoing.robots == ("robot1",)
    assert [stamped["header"]["stamp"] for stamped in nested(outgoing, 0)["transforms"]] == [3.0, 3.0]
    first, second = spoken(outgoing)
    assert first[:2] == ("map", "robot1/odom")
    assert first[2:] == pytest.approx((1.0, 1.5, math.pi / 2))
    assert second[:2] == ("robot1/odom", "robot1/base_link")
    assert second[2:] == pytest.approx((0.5, 0.0, 0.0))


def test_transforms_keep_the_last_origin_between_localisations():
    source = Transforms(["robot1"])
    derive(source, 1.0, located(Pose(1.0, 1.0, 0.0)), odometry(Pose(0.0, 0.0, 0.0)))
    (outgoing,) = derive(source, 2.0, odometry(Pose(0.5, 0.0, 0.0)))
    assert spoken(outgoing)[0][2:] == pytest.approx((1.0, 1.0, 0.0))
    assert derive(source, 3.0, located(Pose(2.0, 1.0, 0.0))) == []
    (outgoing,) = derive(source, 4.0, odometry(Pose(0.5, 0.0, 0.0)))
    assert spoken(outgoing)[0][2:] == pytest.approx((1.5, 1.0, 0.0))


def test_transforms_do_not_place_odometry_in_a_map_that_nobody_knows():
    (outgoing,) = derive(Transforms(["robot1"]), 1.0, odometry(Pose(1.0, 0.0, 0.0)))
    assert [entry[:2] for entry in spoken(outgoing)] == [("robot1/odom", "robot1/base_link")]


def test_transforms_are_silent_without_odometry():
    source = Transforms(["robot1"])
    assert derive(source, 1.0) == []
    assert derive(source, 2.0, located(Pose(1.0, 0.0, 0.0))) == []


def test_transforms_take_fields_that_are_left_out_as_zero():
    """As the codec does: a stranger's odometry need not spell them."""
    counted = Outgoing(
        "odom", "nav_msgs/Odometry", {"pose": {"pose": {"position": {"x": 0.5}, "orientation": {"w": 1.0}}}}
    )
    found = Outgoing("pose", "geometry_msgs/PoseStamped", {"pose": {"orientation": {"w": 1.0}}})
    (outgoing,) = derive(Transforms(["robot1"]), 1.0, counted, found)
    origin, base = (stamped["transform"] for stamped in nested(outgoing, 0)["transforms"])
    assert origin["translation"] == {"x": -0.5, "y": 0.0, "z": 0.0}
    assert base["translation"] == {"x": 0.5, "y": 0.0, "z": 0.0}
    assert base["rotation"] == {"x": 0.0, "y": 0.0, "z": 0.0, "w": 1.0}


def test_transforms_pass_on_where_a_flying_robot_is():
    pose = {"position": {"z": 3.0}, "orientation": {"x": 0.6, "w": 0.8}}
    (outgoing,) = derive(Transforms(["robot1"]), 1.0, Outgoing("o", "nav_msgs/Odometry", {"pose": {"pose": pose}}))
    (base,) = (stamped["transform"] for stamped in nested(outgoing, 0)["transforms"])
    assert base["translation"] == {"x": 0.0, "y": 0.0, "z": 3.0}
    assert base["rotation"] == {"x": 0.6, "y": 0.0, "z": 0.0, "w": 0.8}


def test_transforms_of_a_team_are_those_of_each_robot_alone():
    """Robots 1 and 3 count and are located, robot 2 counts, robot 4 is told by nobody."""
    names = [f"robot{number}" for number in (1, 2, 3, 4)]
    counts = [Pose(0.5, 0.1, 0.3), Pose(1.0, 0.0, 0.0), Pose(-2.0, 1.0, 3.0)]
    places = [Pose(4.0, 2.0, -1.0), Pose(0.0, 7.0, 2.0)]
    team = Transforms(names)
    team.hear(TeamOutgoing("odom", "nav_msgs/Odometry", tuple(names[:3]), columns_of("pose/pose", counts)))
    team.hear(TeamOutgoing("pose", "geometry_msgs/PoseStamped", ("robot1", "robot3"), columns_of("pose", places)))
    placed, lost = team.due(np.array([1.0, 2.0, 3.0, 4.0]))
    assert (placed.robots, lost.robots) == (("robot1", "robot3"), ("robot2",))
    assert placed.columns["transforms/1/header/stamp"].tolist() == [1.0, 3.0]
    assert spoken(lost) == [("robot2/odom", "robot2/base_link", 1.0, 0.0, 0.0)]
    for row, (name, count, place) in enumerate(zip(placed.robots, [counts[0], counts[2]], places)):
        alone = Transforms([name])
        alone.hear(RobotSaid(name, [odometry(count), located(place)]))
        (expected,) = alone.due(np.array([1.0]))
        assert spoken(placed, row) == spoken(expected)


def test_transforms_name_odometry_that_is_not_made_of_numbers():
    said = Outgoing("odom", "nav_msgs/Odometry", {"pose": {"pose": {"position": {"x": "far"}}}})
    with pytest.raises(SimError, match="robot1: nav_msgs/Odometry on odom: pose/pose/position/x must be a number"):
        derive(Transforms(["robot1"]), 1.0, said)
