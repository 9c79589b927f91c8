"""Readers of sensors, and the feedback of a low_level node."""

from __future__ import annotations

import math
from typing import Dict, List, Sequence

import pytest
from hypothesis import given
from hypothesis import strategies as st
from mrta_alliance.sensing import HeardFeedback
from mrta_alliance.sensors import AnyMessage, Scan

from rqt_mrta_py.hooks import Heard, RobotSensorSetup, Subscription
from tests.plugins.mrta_alliance.team import agent, behaviour_set, motivations, nested, step

SETUP = RobotSensorSetup("one", "scan", 1.0, 3.0)


def said(receipt: float, ranges: Sequence[float] = ()) -> Heard:
    fields = {"ranges": list(ranges), "range_min": 0.1, "range_max": 10.0}
    return Heard("/one/scan", "sensor_msgs/LaserScan", receipt, fields)


def test_any_message_is_up_to_date_for_its_timeout_and_kept_for_its_horizon() -> None:
    sensor = AnyMessage(SETUP)
    assert sensor.subscription() == Subscription("scan")
    assert (sensor.read(1.0).up_to_date, sensor.read(1.0).newest) == (False, None)
    message = said(5.0)
    sensor.hear(message)
    readings = {now: sensor.read(now) for now in (5.0, 6.0, 6.1, 8.0, 8.1)}
    assert {now: each.up_to_date for now, each in readings.items()} == {
        5.0: True,
        6.0: True,
        6.1: False,
        8.0: False,
        8.1: False,
    }
    assert [each.newest for each in readings.values()] == [message] * 4 + [None]
    assert {each.topic for each in readings.values()} == {"scan"}


def test_any_message_is_kept_as_long_as_it_is_up_to_date_whatever_the_horizon() -> None:
    sensor = AnyMessage(RobotSensorSetup("one", "scan", 60.0, 5.0))
    sensor.hear(said(5.0))
    assert sensor.read(64.0).up_to_date


@pytest.mark.parametrize(
    ("ranges", "sees"),
    [
        ((), False),
        ((math.inf, math.nan, -math.inf), False),
        ((0.05, 11.0), False),  # too near and too far to be measured
        ((math.inf, 0.1), True),
        ((10.0, math.nan), True),
    ],
)
def test_scan_counts_if_a_ray_ends_within_reach(ranges: Sequence[float], sees: bool) -> None:
    sensor = Scan(SETUP)
    sensor.hear(said(5.0, ranges))
    assert sensor.read(5.5).up_to_date is sees


def test_scan_is_not_refreshed_by_scans_that_see_nothing() -> None:
    sensor = Scan(SETUP)
    for receipt, ranges in ((5.0, (3.0,)), (5.9, (math.inf,))):
        sensor.hear(said(receipt, ranges))
    assert [sensor.read(now).up_to_date for now in (6.0, 6.1)] == [True, False]
    assert sensor.subscription() == Subscription("scan", "sensor_msgs/LaserScan", ("ranges", "range_min", "range_max"))


def test_unknown_sensor_is_refused_by_name() -> None:
    sensors = {"size": 2, "sensor0": {"topic_name": "scan"}, "sensor1": {"plugin_name": "x/y", "topic_name": "odom"}}
    told = {**nested(behaviour_set("patrol")), "sensors": sensors}
    known = {"mrta_alliance/any_message": AnyMessage}
    match = r"sensors/sensor1/plugin_name: nobody registers the sensor 'x/y'; there are: mrta_alliance/any_message"
    with pytest.raises(ValueError, match=match):
        agent("one", told, ["patrol"], sensors=known)


def felt(receipt: float, applicable: bool, task: str = "patrol", robot: str = "one") -> Heard:
    fields = {"task_id": task, "applicable": applicable}
    return Heard(f"/{robot}/alliance/sensory_feedback", "alliance_msgs/SensoryFeedback", receipt, fields)


def test_low_level_feedback_is_held_for_tau() -> None:
    """tau = 2: True at 1.0 counts up to 3.0, False at once; other robots' low_level nodes do not count."""
    told = nested(behaviour_set("patrol"), behaviour_set("inspect"), low_level_feedback=True)
    one = agent("one", told, ["patrol", "inspect"])
    assert one.subscriptions()[1:] == [
        Subscription("alliance/sensory_feedback", "alliance_msgs/SensoryFeedback", ("task_id", "applicable"))
    ]
    heard: Dict[float, List[Heard]] = {1.0: [felt(1.0, True)], 3.4: [felt(3.3, True)], 3.6: [felt(3.5, False)]}
    heard[3.2] = [felt(3.1, True, robot="two"), felt(3.1, True, "cook")]
    answers = []
    for now in (0.8, 1.0, 3.0, 3.2, 3.4, 3.6):
        decision = step(one, now, heard.get(now, ()))
        answers.append(motivations(decision)["patrol"]["applicable"])
        assert motivations(decision)["inspect"]["applicable"] is False
        assert not [message for message in decision.messages if message.type == "alliance_msgs/SensoryFeedback"]
    assert answers == [False, True, True, False, True, False]


@given(
    st.lists(st.tuples(st.floats(0.0, 100.0), st.booleans()), max_size=20).map(sorted),
    st.floats(0.0, 120.0),
)
def test_sensory_feedback_is_the_newest_of_the_last_tau(story: list, later: float) -> None:
    feedback = HeardFeedback("one", 2.0)
    feedback.take_in(felt(receipt, applicable) for receipt, applicable in story)
    now = (story[-1][0] if story else 0.0) + later
    assert feedback.finds_applicable("patrol", now) is (bool(story) and story[-1][1] and later <= 2.0 + 1e-6)
    assert feedback.finds_applicable("inspect", now) is False
