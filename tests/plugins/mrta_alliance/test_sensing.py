"""Sensory feedback: evaluators over the sensors that a behaviour set names."""

from __future__ import annotations

from typing import Any, Dict, List, Sequence

import pytest
from mrta_alliance.plugin import mrta_register_robot_sensors

from rqt_mrta_py.hooks import Heard, SensorReading, Subscription
from rqt_mrta_py.model import Task
from tests.plugins.mrta_alliance.team import agent, behaviour_set, motivations, nested, step

SENSORS = mrta_register_robot_sensors()


class AllFresh:
    """Says that a task is applicable while every sensor is up to date; remembers what it saw."""

    seen: List[Sequence[SensorReading]]

    def __init__(self, task: Task) -> None:
        self.seen = []

    def is_applicable(self, now: float, sensors: Sequence[SensorReading]) -> bool:
        self.seen.append(sensors)
        return all(sensor.up_to_date for sensor in sensors)


def parameters() -> Dict[str, Any]:
    feedback = {
        "plugin_name": "mine/all_fresh",
        "sensors": {"size": 2, "sensor0": {"topic_name": "scan"}, "sensor1": {"topic_name": "/weather"}},
    }
    sensors = {
        "size": 3,
        "sensor0": {"plugin_name": "mrta_alliance/any_message", "topic_name": "scan", "timeout_duration": 1.0},
        "sensor1": {"plugin_name": "mrta_alliance/any_message", "topic_name": "/weather", "timeout_duration": 60.0},
        "sensor2": {"plugin_name": "mrta_alliance/any_message", "topic_name": "odom", "timeout_duration": 1.0},
    }
    told = nested(behaviour_set("patrol", sensory_feedback=feedback), behaviour_set("inspect"))
    return {**told, "sensors": sensors}


def sensed(topic: str, receipt: float) -> Heard:
    return Heard(topic, "any/Type", receipt, {})


def test_agent_subscribes_announcements_and_its_sensors() -> None:
    one = agent("one", parameters(), ["patrol", "inspect"], evaluators={"mine/all_fresh": AllFresh}, sensors=SENSORS)
    assert [wish.topic for wish in one.subscriptions()] == [
        "/alliance/inter_robot_communication",
        "scan",
        "/weather",
        "odom",
    ]
    assert one.subscriptions()[1] == Subscription("scan")


def test_set_with_sensors_is_applicable_while_its_evaluator_says_so() -> None:
    """scan is up to date for 1.0 s, /weather for 60 s; both relative to the robot's namespace where not global."""
    one = agent("one", parameters(), ["patrol", "inspect"], evaluators={"mine/all_fresh": AllFresh}, sensors=SENSORS)
    answers = []
    for now, heard in (
        (1.0, []),
        (2.0, [sensed("/one/scan", 1.5)]),
        (2.2, [sensed("/weather", 2.1)]),
        (2.5, []),
        (2.6, []),
        (2.8, [sensed("/one/scan", 2.7), sensed("/two/scan", 2.7)]),
    ):
        decision = step(one, now, heard)
        said = motivations(decision)
        feedback = {
            message.fields["task_id"]: message.fields["applicable"]
            for message in decision.messages
            if message.topic == "alliance/sensory_feedback"
        }
        assert feedback == {"patrol": said["patrol"]["applicable"], "inspect": True}
        answers.append((said["patrol"]["applicable"], said["patrol"]["motivation"]))
    assert answers == [(False, 0.0), (False, 0.0), (True, 1.0), (True, 2.0), (False, 0.0), (True, 1.0)]


def test_evaluator_is_shown_its_sensors_in_order() -> None:
    made: List[AllFresh] = []

    def make(task: Task) -> AllFresh:
        assert task.id == "patrol"
        made.append(AllFresh(task))
        return made[-1]

    one = agent("one", parameters(), ["patrol", "inspect"], evaluators={"mine/all_fresh": make}, sensors=SENSORS)
    scan = sensed("/one/scan", 0.9)
    step(one, 1.0, [scan])
    (evaluator,) = made
    assert [list(sensors) for sensors in evaluator.seen] == [
        [SensorReading("scan", True, scan), SensorReading("/weather", False, None)]
    ]


def test_sensors_do_not_overrule_what_the_robot_cannot_do() -> None:
    one = agent("one", parameters(), ["patrol", "inspect"], evaluators={"mine/all_fresh": AllFresh}, sensors=SENSORS)
    heard = [sensed("/one/scan", 1.0), sensed("/weather", 1.0)]
    decision = step(one, 1.0, heard, impossible=["patrol"])
    assert motivations(decision)["patrol"]["applicable"] is False
    assert [m.fields["applicable"] for m in decision.messages if m.topic == "alliance/sensory_feedback"] == [True, True]


def test_unknown_evaluator_is_refused_by_name() -> None:
    with pytest.raises(ValueError, match=r"task 'patrol'.*nobody registers.*'mine/all_fresh'; there are: other/one"):
        agent("one", parameters(), ["patrol", "inspect"], evaluators={"other/one": AllFresh}, sensors=SENSORS)


def test_evaluator_is_not_asked_for_where_a_set_has_no_sensors() -> None:
    told = nested(behaviour_set("patrol", sensory_feedback={"plugin_name": "nobody/knows"}))
    assert motivations(step(agent("one", told, ["patrol"]), 1.0))["patrol"]["applicable"] is True
