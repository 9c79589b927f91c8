from __future__ import annotations

import math

import numpy as np
import pytest

from rqt_mrta_py.errors import SimError
from rqt_mrta_py.model import Pose
from rqt_mrta_py.sim.sensors import Localiser
from tests.sim.doubles import ScriptedRandom
from tests.sim.sensors.support import context, moment, pose_in

TRUTH = Pose(1.0, -2.0, 3.0)


def locate(sensor):
    (outgoing,) = sensor.sense(moment(4.0, [TRUTH]))
    return outgoing


def test_localiser_publishes_a_pose_in_the_map():
    outgoing = locate(Localiser([context("localiser", "pose", position_noise=0.0, heading_noise=0.0)]))
    assert (outgoing.topic, outgoing.type) == ("pose", "geometry_msgs/PoseStamped")
    assert outgoing.robots == ("robot1",)
    columns = outgoing.columns
    assert (columns["header/stamp"].tolist(), columns["header/frame_id"]) == ([4.0], "map")
    assert (columns["pose/position/x"].tolist(), columns["pose/position/y"].tolist()) == ([1.0], [-2.0])
    assert columns["pose/orientation/z"] == pytest.approx([math.sin(1.5)])
    assert columns["pose/orientation/w"] == pytest.approx([math.cos(1.5)])


def test_localiser_adds_noise_to_each_part():
    random = ScriptedRandom([1.0, -2.0, 3.0])
    pose = pose_in(locate(Localiser([context("localiser", "pose", random=random)])).columns)
    assert (pose.x, pose.y, pose.yaw) == (pytest.approx(1.01), pytest.approx(-2.02), pytest.approx(3.03))


def test_localiser_noise_has_the_deviations_asked_for_and_no_memory():
    sensor = Localiser([context("localiser", "pose", position_noise=0.05, heading_noise=0.02)])
    poses = [pose_in(locate(sensor).columns) for _ in range(4000)]
    x = np.array([pose.x for pose in poses])
    assert np.mean(x) == pytest.approx(1.0, abs=0.004)
    assert np.std(x) == pytest.approx(0.05, rel=0.05)
    assert np.corrcoef(x[1:], x[:-1])[0, 1] == pytest.approx(0.0, abs=0.06)
    heading = [math.remainder(pose.yaw - 3.0, 2 * math.pi) for pose in poses]
    assert np.std(heading) == pytest.approx(0.02, rel=0.05)


def test_localiser_is_evenly_off_within_what_it_is_told():
    """Evenly within 8 mm to either side: never farther, and 8 / sqrt(3) mm in the root mean square."""
    exact = {"position_noise": 0.0, "heading_noise": 0.0}
    sensor = Localiser([context("localiser", "pose", uniform_noise=0.008, **exact)])
    poses = [pose_in(locate(sensor).columns) for _ in range(4000)]
    off = np.array([(pose.x - TRUTH.x, pose.y - TRUTH.y) for pose in poses])
    assert np.abs(off).max(axis=0) == pytest.approx([0.008, 0.008], rel=0.01)
    assert np.abs(off).max() <= 0.008
    assert off.std(axis=0) == pytest.approx([0.008 / math.sqrt(3.0)] * 2, rel=0.05)
    assert off.mean(axis=0) == pytest.approx([0.0, 0.0], abs=4e-4)
    assert np.corrcoef(off.T)[0, 1] == pytest.approx(0.0, abs=0.06)
    assert np.corrcoef(off[1:, 0], off[:-1, 0])[0, 1] == pytest.approx(0.0, abs=0.06)
    assert {round(pose.yaw, 9) for pose in poses} == {TRUTH.yaw}


def test_localiser_draws_its_normal_noise_alike_whether_it_is_evenly_off_too_or_not():
    before = [Localiser([context("localiser", "pose", uniform_noise=noise)]) for noise in (0.0, 1e-12)]
    first, second = (pose_in(locate(sensor).columns) for sensor in before)
    assert (first.x, first.y, first.yaw) == pytest.approx((second.x, second.y, second.yaw), abs=1e-9)


def lasting(rate, until, *, robot=1, noise=0.008, hold=60.0, begin=0.0):
    """Give by how much a localiser is off, by times, where measurements are exact but for what lasts."""
    random = np.random.default_rng(robot)
    exact = {"position_noise": 0.0, "heading_noise": 0.0}
    sensor = Localiser([context("localiser", "pose", random=random, uniform_noise=noise, uniform_hold=hold, **exact)])
    found = {}
    for tick in range(round(begin * rate), round(until * rate)):
        pose = pose_in(sensor.sense(moment(tick / rate, [TRUTH]))[0].columns)
        found[tick / rate] = (pose.x - TRUTH.x, pose.y - TRUTH.y)
    return found


def test_what_lasts_is_drawn_anew_at_multiples_of_how_long_it_lasts():
    """In 180 s three errors of 60 s each, however often it measures, in x and in y."""
    off = lasting(10.0, 180.0)
    assert len(set(off.values())) == 3
    for number in range(3):
        assert len({off[60.0 * number + second] for second in (0.0, 0.1, 30.0, 59.9)}) == 1
    assert off[59.9] != off[60.0]
    assert all(x != y for x, y in off.values())


def test_what_lasts_does_not_depend_on_how_often_it_measures_or_measured_before():
    often, seldom, late = lasting(10.0, 180.0), lasting(0.5, 180.0), lasting(10.0, 180.0, begin=150.0)
    assert all(often[time] == off for time, off in (*seldom.items(), *late.items()))
    assert lasting(1.0, 10.0, robot=2)[0.0] != often[0.0]


def test_what_lasts_is_evenly_distributed_and_has_no_memory():
    """Evenly within 8 mm to either side: 8 / sqrt(3) mm in the root mean square."""
    off = np.array(list(lasting(1.0, 4000.0, hold=1.0).values()))
    assert np.abs(off).max() <= 0.008
    assert np.abs(off).max(axis=0) == pytest.approx([0.008, 0.008], rel=0.01)
    assert off.std(axis=0) == pytest.approx([0.008 / math.sqrt(3.0)] * 2, rel=0.05)
    assert np.corrcoef(off.T)[0, 1] == pytest.approx(0.0, abs=0.06)
    assert np.corrcoef(off[1:, 0], off[:-1, 0])[0, 1] == pytest.approx(0.0, abs=0.06)


def test_what_lasts_does_so_on_clocks_that_are_far_off_too():
    exact = {"position_noise": 0.0, "heading_noise": 0.0}
    sensor = Localiser([context("localiser", "pose", uniform_noise=0.008, uniform_hold=60.0, **exact)])
    first, same, before, far = (
        pose_in(sensor.sense(moment(now, [TRUTH]))[0].columns) for now in (-30.0, -1.0, -61.0, 1e300)
    )
    assert first == same != before
    assert max(abs(first.x - 1.0), abs(before.x - 1.0), abs(far.x - 1.0)) <= 0.008


def test_a_hold_of_zero_is_none_at_all():
    sensors = [
        Localiser([context("localiser", "pose", uniform_noise=0.008, **more)]) for more in ({}, {"uniform_hold": 0.0})
    ]
    for _ in range(200):
        first, second = (pose_in(locate(sensor).columns) for sensor in sensors)
        assert first == second


def test_localiser_names_a_parameter_that_is_no_number():
    with pytest.raises(SimError) as caught:
        Localiser([context("localiser", "pose", position_noise=math.nan, heading_noise=True, uniform_hold=-1)])
    where = "robot robot1: sensor localiser on pose: parameter"
    assert str(caught.value).splitlines() == [
        f"{where} position_noise: must be a number at least 0 (got nan)",
        f"{where} heading_noise: must be a number at least 0 (got True)",
        f"{where} uniform_hold: must be a number at least 0 (got -1)",
    ]


@pytest.mark.parametrize("noise", [{}, {"uniform_noise": 0.02}, {"uniform_noise": 0.02, "uniform_hold": 0.5}])
def test_localiser_of_a_robot_is_the_same_alone_and_in_a_team(noise):
    robots = [("robot1", Pose(1.0, -2.0, 3.0)), ("robot2", Pose(-4.0, 0.5, -1.0)), ("robot3", Pose(0.0, 0.0, 0.0))]

    def contexts(*places):
        return [
            context("localiser", "pose", robot=robots[place][0], random=np.random.default_rng(place), **noise)
            for place in places
        ]

    team = Localiser(contexts(0, 1, 2))
    (first,) = team.sense(moment(1.0, [robots[0][1], robots[2][1]], members=[0, 2]))
    (second,) = team.sense(moment(2.0, [pose for _, pose in robots]))
    assert (first.robots, second.robots) == (("robot1", "robot3"), ("robot1", "robot2", "robot3"))
    for place, (_, truth) in enumerate(robots):
        alone = Localiser(contexts(place))
        said = [alone.sense(moment(now, [truth]))[0] for now in ((1.0, 2.0) if place != 1 else (2.0,))]
        assert pose_in(second.columns, row=place) == pose_in(said[-1].columns)
