from __future__ import annotations

import math

import numpy as np
import pytest

from rqt_mrta_py.errors import SimError
from rqt_mrta_py.model import Pose
from rqt_mrta_py.sim.robot_models import DIFF_DRIVE, MECANUM_ARM, OMNI_DRIVE
from rqt_mrta_py.sim.sensors import Odometry
from tests.sim.doubles import ScriptedRandom
from tests.sim.sensors.support import context, moment, pose_in

EXACT = {"distance_error": 0.0, "turn_error": 0.0, "heading_error": 0.0, "heading_walk": 0.0}


def drive(path, random=None, model=DIFF_DRIVE, **parameters):
    """Let odometry follow true poses, a tenth of a second apart; give its last message."""
    sensor = Odometry([context("odometry", "odom", random=random, start=path[0], model=model, **parameters)])
    for index, truth in enumerate(path):
        (outgoing,) = sensor.sense(moment(1.0 + 0.1 * index, [truth]))
    return outgoing


def straight(length, steps=100, yaw=0.0):
    return [Pose(math.cos(yaw) * length * i / steps, math.sin(yaw) * length * i / steps, yaw) for i in range(steps + 1)]


def counted(outgoing):
    return pose_in(outgoing.columns, "pose/pose")


def test_odometry_begins_at_zero_wherever_its_robot_starts():
    outgoing = drive([Pose(3.0, -2.0, 1.2)], **EXACT)
    assert (outgoing.topic, outgoing.type) == ("odom", "nav_msgs/Odometry")
    columns = outgoing.columns
    assert (columns["header/stamp"].tolist(), columns["header/frame_id"]) == ([1.0], ("robot1/odom",))
    assert columns["child_frame_id"] == ("robot1/base_link",)
    assert counted(outgoing) == Pose(0.0, 0.0, 0.0)
    assert (columns["twist/twist/linear/x"].tolist(), columns["twist/twist/angular/z"].tolist()) == ([0.0], [0.0])


def test_odometry_without_errors_counts_the_true_way_seen_from_its_start():
    """A quarter circle of radius 2 m from heading pi/2 ends 2 m ahead and 2 m to the left, a quarter turn on."""
    path = [
        Pose(5.0 + 2.0 * math.cos(a) - 2.0, 1.0 + 2.0 * math.sin(a), a + math.pi / 2)
        for a in np.linspace(0.0, math.pi / 2, 200).tolist()
    ]
    end = counted(drive(path, **EXACT))
    assert (end.x, end.y) == (pytest.approx(2.0, abs=1e-3), pytest.approx(2.0, abs=1e-3))
    assert end.yaw == pytest.approx(math.pi / 2)


def test_odometry_tells_velocity_in_the_robots_own_frame():
    columns = drive(straight(-3.0, steps=60, yaw=2.0), **EXACT).columns
    assert columns["twist/twist/linear/x"] == pytest.approx([-0.5])
    assert columns["twist/twist/angular/z"] == pytest.approx([0.0])


def test_odometry_of_one_sigma_counts_33_millimetres_too_much_over_ten_metres():
    end = counted(drive(straight(10.0), ScriptedRandom([1.0, 0.0, 0.0])))
    assert (end.x, end.y, end.yaw) == (pytest.approx(10.033), pytest.approx(0.0), pytest.approx(0.0))


def test_odometry_of_one_sigma_counts_seven_degrees_too_much_over_a_turn():
    turn = [Pose(0.0, 0.0, 2 * math.pi * i / 100) for i in range(101)]
    end = counted(drive(turn, ScriptedRandom([0.0, 1.0, 0.0])))
    assert math.degrees(end.yaw) == pytest.approx(7.0)
    assert (end.x, end.y) == (pytest.approx(0.0), pytest.approx(0.0))


@pytest.mark.parametrize("length", [2.0, -2.0])
def test_odometry_of_one_sigma_veers_two_degrees_a_metre_forth_and_back(length):
    """Integrated over 2 m, 2 deg/m is a heading of 4 degrees and, as the reference says, 3.5 cm/m sideways."""
    end = counted(drive(straight(length), ScriptedRandom([0.0, 0.0, 1.0])))
    assert math.degrees(end.yaw) == pytest.approx(4.0)
    assert abs(end.y) / 2.0 == pytest.approx(0.035, abs=0.001)


def test_odometry_heading_walks_with_the_square_root_of_the_way():
    """N(0, 0.005 sqrt|ds|) adds up to a deviation of 0.01 rad over 4 m, however many steps it takes."""
    parameters = {**EXACT, "heading_walk": 0.005}
    for steps in (4, 20):
        ends = [
            counted(drive(straight(4.0, steps), np.random.default_rng(seed), **parameters)).yaw for seed in range(600)
        ]
        assert np.std(ends) == pytest.approx(0.01, rel=0.1)
        assert np.mean(ends) == pytest.approx(0.0, abs=0.002)


def test_odometry_counts_nothing_when_pushed_sideways():
    end = counted(drive([Pose(0.0, 0.1 * i, 0.0) for i in range(11)]))
    assert end == Pose(0.0, 0.0, 0.0)


def sideways(length, steps=100):
    return [Pose(0.0, length * i / steps, 0.0) for i in range(steps + 1)]


MECANUM_EXACT = {
    **EXACT,
    **dict.fromkeys(("sideways_error", "sideways_drift", "sideways_heading_error", "drift", "turn_drift"), 0.0),
}


@pytest.mark.parametrize("model", [MECANUM_ARM, OMNI_DRIVE])
def test_odometry_of_mecanum_wheels_counts_the_way_sideways(model):
    outgoing = drive(sideways(-1.5), model=model, **MECANUM_EXACT)
    end = counted(outgoing)
    assert (end.x, end.y, end.yaw) == (pytest.approx(0.0), pytest.approx(-1.5), 0.0)
    assert outgoing.columns["twist/twist/linear/x"] == pytest.approx([0.0])
    assert outgoing.columns["twist/twist/linear/y"] == pytest.approx([-0.15])


def test_odometry_of_mecanum_wheels_follows_any_way():
    """From (1, 1) heading to +y, 2 m to +x and on the way half a turn: 2 m to its right, seen from its start."""
    path = [Pose(1.0 + 2.0 * i / 400, 1.0, math.pi / 2 + math.pi * i / 400) for i in range(401)]
    end = counted(drive(path, model=MECANUM_ARM, **MECANUM_EXACT))
    assert (end.x, end.y) == (pytest.approx(0.0, abs=1e-3), pytest.approx(-2.0, abs=1e-3))
    assert abs(end.yaw) == pytest.approx(math.pi)


@pytest.mark.parametrize(
    ("bias", "path", "error"),
    [
        (3, sideways(2.0), (0.0056, 0.0, 0.0)),
        (3, sideways(-2.0), (0.0056, 0.0, 0.0)),
        (4, [Pose(0.0, 0.0, 2 * math.pi * i / 100) for i in range(101)], (0.0, 0.0, 0.0)),
        (5, sideways(2.0), (0.0, 0.0064, 0.0)),
        (6, straight(2.0), (0.0, 0.0042, 0.0)),
        (0, straight(2.0), (0.0066, 0.0, 0.0)),
    ],
)
def test_odometry_of_mecanum_wheels_errs_as_table_18_says(bias, path, error):
    """Of 2 m: 0.28 cm/m ahead and 0.32 cm/m aside driving aside; 0.33 cm/m ahead and 0.21 cm/m aside driving ahead."""
    normals = [0.0] * 8
    normals[bias] = 1.0
    end, start = counted(drive(path, ScriptedRandom(normals), MECANUM_ARM)), path[0]
    true = path[-1]
    off = (end.x - true.x + start.x, end.y - true.y + start.y, math.remainder(end.yaw - true.yaw, 2 * math.pi))
    assert off == pytest.approx(error, abs=1e-5)


def test_odometry_of_mecanum_wheels_shifts_a_third_of_a_millimetre_over_a_turn():
    """0.03 cm a turn, along the heading of the moment: over a half turn it adds up to 0.015 cm / (pi / 2) aside."""
    half_turn = [Pose(0.0, 0.0, math.pi * i / 400) for i in range(401)]
    end = counted(drive(half_turn, ScriptedRandom([0.0, 0.0, 0.0, 0.0, 1.0]), MECANUM_ARM))
    assert (end.x, end.y) == (pytest.approx(0.0, abs=1e-6), pytest.approx(0.00015 * 2 / math.pi, abs=1e-6))


def test_odometry_of_mecanum_wheels_veers_four_degrees_a_metre_sideways():
    end = counted(drive(sideways(1.0), ScriptedRandom([0.0] * 7 + [1.0]), MECANUM_ARM))
    assert math.degrees(end.yaw) == pytest.approx(4.0)


def test_odometry_of_a_mixed_team_counts_sideways_what_can_drive_so():
    contexts = [
        context("odometry", "odom", robot=f"r{place}", model=model, **MECANUM_EXACT)
        for place, model in enumerate((DIFF_DRIVE, MECANUM_ARM))
    ]
    sensor = Odometry(contexts)
    for index in range(11):
        (last,) = sensor.sense(moment(1.0 + 0.1 * index, [Pose(0.1 * index, 0.1 * index)] * 2))
    assert [pose_in(last.columns, "pose/pose", row) for row in (0, 1)] == [
        Pose(pytest.approx(1.0), pytest.approx(0.0), 0.0),
        Pose(pytest.approx(1.0), pytest.approx(1.0), 0.0),
    ]


def test_odometry_of_a_robot_at_rest_stays():
    assert counted(drive([Pose(1.0, 2.0, 3.0)] * 50)) == Pose(0.0, 0.0, 0.0)


def test_odometry_draws_its_biases_once():
    """Two robots of one generator differ; each keeps its own error a metre over the whole way."""
    random = np.random.default_rng(11)
    parameters = {"heading_walk": 0.0, "heading_error": 0.0}
    first, second = (counted(drive(straight(4.0), random, **parameters)).x for _ in range(2))
    assert first != second
    half = counted(drive(straight(2.0), np.random.default_rng(11), **parameters)).x
    assert (half - 2.0) * 2 == pytest.approx(first - 4.0)


def test_odometry_refuses_a_negative_error():
    with pytest.raises(
        SimError, match=r"robot robot1: sensor odometry on odom: parameter turn_error: must be a number"
    ):
        drive([Pose(0.0, 0.0)], turn_error=-0.1)


def test_odometry_of_a_robot_is_the_same_alone_and_in_a_team_that_does_not_always_measure():
    paths = [straight(1.0, steps=8, yaw=0.3 + place) for place in range(3)]

    def contexts(*places):
        return [
            context(
                "odometry", "odom", robot=f"robot{place}", start=paths[place][0], random=np.random.default_rng(place)
            )
            for place in places
        ]

    measures = [[0, 2] if index in (3, 4) else [0, 1, 2] for index in range(9)]
    team = Odometry(contexts(0, 1, 2))
    for index, members in enumerate(measures):
        (last,) = team.sense(moment(1.0 + 0.1 * index, [paths[place][index] for place in members], members=members))
    for place, path in enumerate(paths):
        alone = Odometry(contexts(place))
        for index, members in enumerate(measures):
            if place in members:
                (expected,) = alone.sense(moment(1.0 + 0.1 * index, [path[index]]))
        for column in ("pose/pose/position/x", "pose/pose/orientation/z", "twist/twist/linear/x"):
            assert last.columns[column][place] == expected.columns[column][0]
        assert last.columns["header/frame_id"][place] == f"robot{place}/odom"
