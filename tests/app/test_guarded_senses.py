"""Sensory evaluators and readers of sensors are told by name when they fail, and agents when they name none."""

from __future__ import annotations

from typing import Any, List

import pytest

from rqt_mrta_py.app.guard import guarded_evaluators, guarded_robot_sensors
from rqt_mrta_py.errors import HookError
from rqt_mrta_py.hooks import Heard, RobotSensorSetup, SensorReading, Subscription
from rqt_mrta_py.model import Task

SETUP = RobotSensorSetup("robot1", "scan", timeout=1.0, horizon=2.0)
WISH = Subscription("scan", "sensor_msgs/LaserScan", ("ranges",))
HEARD = Heard("/robot1/scan", "sensor_msgs/LaserScan", 3.0, {"ranges": [1.0]})


class Answers:
    """Evaluator and reader in one: answers what it was told to, or raises it."""

    def __init__(self, answer: Any) -> None:
        self.answer = answer
        self.heard: List[Heard] = []

    def is_applicable(self, now: float, sensors: Any) -> Any:
        return self._give()

    def subscription(self) -> Any:
        return self._give()

    def hear(self, heard: Heard) -> None:
        self.heard.append(heard)

    def read(self, now: float) -> Any:
        return self._give()

    def _give(self) -> Any:
        if isinstance(self.answer, Exception):
            raise self.answer
        return self.answer


def evaluator(answer: Any) -> Any:
    return guarded_evaluators({"p/e": lambda task: Answers(answer)})["p/e"](Task("dig", "dig"))


def sensor(answer: Any) -> Any:
    return guarded_robot_sensors({"p/s": lambda setup: Answers(answer)})["p/s"](SETUP)


@pytest.mark.parametrize("answer", [True, False])
def test_what_an_evaluator_answers_is_passed_on(answer: bool) -> None:
    assert evaluator(answer).is_applicable(1.0, ()) is answer


def test_what_a_reader_wishes_hears_and_reads_is_passed_on() -> None:
    parts: List[Answers] = []

    def make(setup: RobotSensorSetup) -> Any:
        assert setup is SETUP
        parts.append(Answers(WISH))
        return parts[0]

    reader = guarded_robot_sensors({"p/s": make})["p/s"](SETUP)
    assert reader.subscription() == WISH
    reader.hear(HEARD)
    assert parts[0].heard == [HEARD]
    parts[0].answer = SensorReading("scan", True, HEARD)
    assert reader.read(3.5) == SensorReading("scan", True, HEARD)


@pytest.mark.parametrize(
    ("ask", "message"),
    [
        (
            lambda: evaluator(1).is_applicable(1.0, ()),
            "sensory evaluator p/e of task 'dig': is_applicable answered 1; accepted is bool",
        ),
        (
            lambda: evaluator(KeyError("x")).is_applicable(1.0, ()),
            "sensory evaluator p/e of task 'dig': KeyError: 'x'",
        ),
        (
            lambda: guarded_evaluators({"p/e": lambda task: None})["p/e"](Task("dig", "dig")),
            "sensory evaluator p/e of task 'dig': made None, which has no 'is_applicable'",
        ),
        (
            lambda: sensor("scan").subscription(),
            "robot1: robot sensor p/s on scan: wants to hear 'scan'; a Subscription is needed",
        ),
        (
            lambda: sensor(True).read(1.0),
            "robot1: robot sensor p/s on scan: read answered True; a SensorReading is needed",
        ),
        (
            lambda: sensor(ZeroDivisionError("no")).read(1.0),
            "robot1: robot sensor p/s on scan: ZeroDivisionError: no",
        ),
        (
            lambda: guarded_robot_sensors({"p/s": lambda setup: None})["p/s"](SETUP),
            "robot1: robot sensor p/s on scan: made None, which has no 'subscription'",
        ),
        (
            lambda: guarded_evaluators({"p/fresh": Answers})["p/frseh"],
            "sensory evaluator 'p/frseh': no plugin registers it; nearest is 'p/fresh'",
        ),
        (
            lambda: guarded_robot_sensors({})["p/s"],
            "robot sensor 'p/s': no plugin registers it; there is none",
        ),
    ],
)
def test_what_does_not_fit_is_told_by_name(ask: Any, message: str) -> None:
    with pytest.raises(HookError) as caught:
        ask()
    assert str(caught.value) == message


def test_an_agent_can_ask_whether_a_name_is_registered() -> None:
    factories = guarded_robot_sensors({"p/b": Answers, "p/a": Answers})
    assert "p/a" in factories
    assert "p/c" not in factories
    assert factories.get("p/c") is None
    assert sorted(factories) == ["p/a", "p/b"]
