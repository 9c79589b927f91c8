from __future__ import annotations

import math

import numpy as np
import pytest

from rqt_mrta_py.errors import SimError
from rqt_mrta_py.sim.sensors import RangeFinder
from tests.sim.doubles import ScriptedRandom, StillWorld
from tests.sim.sensors.support import START, context, moment

EXACT = {"noise": 0.0, "noise_per_metre": 0.0, "dropout": 0.0}


def scan(seen, random=None, **parameters):
    sensor = RangeFinder([context("range_finder", "scan", random=random, **parameters)])
    (outgoing,) = sensor.sense(moment(2.5, [START], StillWorld(seen).ranges(["robot1"], *sensor.rays)))
    return outgoing


def ranges_of(outgoing):
    (row,) = outgoing.columns["ranges"].tolist()
    return row


def many(seen, **parameters):
    """Give the ranges of six scans of as many rays as there may be, one after the other."""
    sensor = RangeFinder([context("range_finder", "scan", rays=3600, **parameters)])
    now = moment(2.5, [START], StillWorld(seen).ranges(["robot1"], *sensor.rays))
    return [value for _ in range(6) for outgoing in sensor.sense(now) for value in ranges_of(outgoing)]


def test_range_finder_publishes_a_laser_scan_in_the_frame_of_its_robot():
    outgoing = scan([1.0], **EXACT)
    assert (outgoing.topic, outgoing.type) == ("scan", "sensor_msgs/LaserScan")
    columns = outgoing.columns
    assert (columns["header/stamp"].tolist(), columns["header/frame_id"]) == ([2.5], ("robot1/base_link",))
    assert columns["scan_time"] == pytest.approx(0.1)
    assert (columns["range_min"], columns["range_max"]) == (0.05, 4.0)
    assert ranges_of(outgoing) == [1.0] * 36


def test_range_finder_spreads_a_full_turn_without_a_last_ray_on_the_first():
    columns = scan([1.0], rays=4, **EXACT).columns
    assert columns["angle_min"] == pytest.approx(-math.pi)
    assert columns["angle_increment"] == pytest.approx(math.pi / 2)
    assert columns["angle_max"] == pytest.approx(math.pi / 2)


def test_range_finder_spreads_a_fan_from_edge_to_edge():
    columns = scan([1.0], rays=5, fov=2.0, **EXACT).columns
    assert (columns["angle_min"], columns["angle_max"]) == (pytest.approx(-1.0), pytest.approx(1.0))
    assert columns["angle_increment"] == pytest.approx(0.5)


def test_range_finder_with_one_ray_looks_ahead():
    columns = scan([1.0], rays=1, fov=1.0, **EXACT).columns
    assert (columns["angle_min"], columns["angle_max"], columns["angle_increment"]) == (0.0, 0.0, 0.0)


def test_range_finder_without_noise_tells_the_truth():
    assert ranges_of(scan([0.5, 1.25, 3.0, 2.0], rays=4, **EXACT)) == [0.5, 1.25, 3.0, 2.0]


def test_range_finder_marks_what_is_beyond_its_reach_as_rep_117_says():
    ranges = ranges_of(scan([0.04, 0.05, 4.0, 4.5, math.inf], rays=5, **EXACT))
    assert ranges == [-math.inf, 0.05, 4.0, math.inf, math.inf]


def test_range_finder_noise_grows_with_the_distance():
    """With sigma = 0.01 + 0.02 r, one sigma at 1 m is 0.03 m, at 3 m 0.07 m."""
    random = ScriptedRandom([1.0, 1.0, -1.0, 0.0])
    ranges = ranges_of(scan([1.0, 3.0], random, rays=4, noise=0.01, noise_per_metre=0.02, dropout=0.0))
    assert ranges == pytest.approx([1.03, 3.07, 0.97, 3.0])


def test_range_finder_noise_has_the_deviation_asked_for():
    ranges = many([2.0], noise=0.01, noise_per_metre=0.01, dropout=0.0)
    assert np.mean(ranges) == pytest.approx(2.0, abs=0.001)
    assert np.std(ranges) == pytest.approx(0.03, rel=0.03)


def test_range_finder_loses_the_share_of_rays_asked_for():
    ranges = many([2.0], noise=0.0, noise_per_metre=0.0, dropout=0.25)
    assert np.mean(np.isposinf(ranges)) == pytest.approx(0.25, abs=0.02)


def test_range_finder_draws_as_much_whatever_it_sees():
    states = []
    for seen in ([1.0], [math.inf], [0.01]):
        random = np.random.default_rng(3)
        many(seen, random=random)
        states.append(random.bit_generator.state)
    assert states[0] == states[1] == states[2]


def test_range_finder_draws_noise_and_losses_of_seven_scans_of_36_rays_in_turn():
    sensor = RangeFinder([context("range_finder", "scan", noise=0.1, noise_per_metre=0.0, dropout=0.3)])
    now = moment(1.0, [START], np.full((1, 36), 2.0))
    scans = [ranges_of(outgoing) for _ in range(10) for outgoing in sensor.sense(now)]
    random = np.random.default_rng(7)
    for first in (0, 7):
        noise, chance = random.standard_normal((7, 36)), random.random((7, 36))
        expected = np.where(chance < 0.3, np.inf, 2.0 + 0.1 * noise)
        np.testing.assert_allclose(scans[first : first + 7], expected[: len(scans) - first], rtol=1e-12)


def test_range_finder_tells_all_wrong_parameters_at_once():
    with pytest.raises(SimError) as caught:
        RangeFinder([context("range_finder", "scan", rays=0, dropout=1.5, noise="much", max_rnge=3.0, fov=-1.0)])
    where = "robot robot1: sensor range_finder on scan: parameter"
    assert str(caught.value).splitlines() == [
        f"{where} rays: must be a whole number from 1 to 3600 (got 0)",
        f"{where} fov: must be a number above 0, at most 6.28329 (got -1.0)",
        f"{where} noise: must be a number at least 0, at most 1000 (got 'much')",
        f"{where} dropout: must be a number at least 0, at most 1 (got 1.5)",
        f"{where} max_rnge: unknown; nearest is 'max_range'",
    ]


def test_range_finder_must_reach_farther_than_it_begins():
    with pytest.raises(SimError, match=r"parameter max_range: must be above min_range \(2\) \(got 1.0\)"):
        RangeFinder([context("range_finder", "scan", min_range=2.0, max_range=1.0)])


def test_range_finder_has_ten_rays_a_degree_at_most():
    with pytest.raises(SimError, match=r"parameter rays: must be a whole number from 1 to 3600 \(got 1000000000\)"):
        RangeFinder([context("range_finder", "scan", rays=10**9)])


def test_range_finder_leaves_the_distances_it_was_handed_as_they_are():
    sensor = RangeFinder([context("range_finder", "scan", rays=3)])
    handed = np.array([[0.01, 2.0, np.inf]])
    handed.flags.writeable = False
    sensor.sense(moment(1.0, [START], handed))
    assert handed.tolist() == [[0.01, 2.0, math.inf]]


def test_range_finder_of_a_robot_is_the_same_alone_and_in_a_team():
    seen = np.array([[0.5, 1.0, 2.0, np.inf], [3.0, 3.9, 0.02, 1.5], [1.0, 1.0, 1.0, 1.0]])

    def contexts(*places):
        return [
            context("range_finder", "scan", rays=4, robot=f"robot{place}", random=np.random.default_rng(place))
            for place in places
        ]

    (together,) = RangeFinder(contexts(0, 1, 2)).sense(moment(1.0, [START, START], seen[[0, 2]], members=[0, 2]))
    assert together.robots == ("robot0", "robot2")
    for row, place in enumerate([0, 2]):
        (alone,) = RangeFinder(contexts(place)).sense(moment(1.0, [START], seen[[place]]))
        assert together.columns["ranges"][row].tolist() == ranges_of(alone)
