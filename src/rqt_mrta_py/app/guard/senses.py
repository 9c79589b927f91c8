"""What agents judge applicability by: sensory evaluators and readers of robots' sensors that carry their names."""

from __future__ import annotations

from typing import Any, Callable, Dict, Mapping, NoReturn, Sequence

from rqt_mrta_py.app.guard.asking import guarded, made
from rqt_mrta_py.errors import HookError
from rqt_mrta_py.hooks import (
    Heard,
    RobotSensor,
    RobotSensorFactory,
    RobotSensorSetup,
    SensorReading,
    SensoryEvaluator,
    SensoryEvaluatorFactory,
    Subscription,
)
from rqt_mrta_py.model import Task
from rqt_mrta_py.wording import accepted, shown

__all__ = ["guarded_evaluators", "guarded_robot_sensors"]


class _Named(Dict[str, Callable[[Any], Any]]):
    """Factories by name; asked for one that nobody registers, it says so."""

    def __init__(self, kind: str, factories: Mapping[str, Callable[[Any], Any]]) -> None:
        super().__init__(factories)
        self._kind = kind

    def __missing__(self, name: str) -> NoReturn:
        raise HookError(f"{self._kind} {shown(name)}: no plugin registers it; {accepted(str(name), sorted(self))}")


def guarded_evaluators(factories: Mapping[str, SensoryEvaluatorFactory]) -> Mapping[str, SensoryEvaluatorFactory]:
    """Give evaluators whose failures and answers are told with their names, so that no agent is blamed for them.

    Args:
        factories: of sensory evaluators, by name.
    """

    def checked(name: str, factory: SensoryEvaluatorFactory) -> Callable[[Task], SensoryEvaluator]:
        def make(task: Task) -> SensoryEvaluator:
            who = f"sensory evaluator {name} of task {task.id!r}"
            return _GuardedEvaluator(who, made(who, factory, task, "is_applicable"))

        return make

    return _Named("sensory evaluator", {name: checked(name, factory) for name, factory in factories.items()})


def guarded_robot_sensors(factories: Mapping[str, RobotSensorFactory]) -> Mapping[str, RobotSensorFactory]:
    """Give readers of sensors whose failures and answers are told with their names.

    Args:
        factories: of readers, by name.
    """

    def checked(name: str, factory: RobotSensorFactory) -> Callable[[RobotSensorSetup], RobotSensor]:
        def make(setup: RobotSensorSetup) -> RobotSensor:
            who = f"{setup.robot_id}: robot sensor {name} on {setup.topic}"
            return _GuardedRobotSensor(who, made(who, factory, setup, "subscription", "hear", "read"))

        return make

    return _Named("robot sensor", {name: checked(name, factory) for name, factory in factories.items()})


class _GuardedEvaluator:
    """Checks that an evaluator answers True or False."""

    __slots__ = ("_evaluator", "_who")

    def __init__(self, who: str, evaluator: SensoryEvaluator) -> None:
        self._who = who
        self._evaluator = evaluator

    def is_applicable(self, now: float, sensors: Sequence[SensorReading]) -> bool:
        """Judge by sensors; see hooks.SensoryEvaluator."""
        answer: Any = guarded(self._who, self._evaluator.is_applicable, now, sensors)
        if not isinstance(answer, bool):
            raise HookError(f"{self._who}: is_applicable answered {shown(answer)}; accepted is bool")
        return answer


class _GuardedRobotSensor:
    """Checks what a reader wishes to hear, and that it answers readings."""

    __slots__ = ("_sensor", "_who")

    def __init__(self, who: str, sensor: RobotSensor) -> None:
        self._who = who
        self._sensor = sensor

    def subscription(self) -> Subscription:
        """Say what to hear."""
        wish: Any = guarded(self._who, self._sensor.subscription)
        if not isinstance(wish, Subscription):
            raise HookError(f"{self._who}: wants to hear {shown(wish)}; a Subscription is needed")
        return wish

    def hear(self, heard: Heard) -> None:
        """Take in one message."""
        guarded(self._who, self._sensor.hear, heard)

    def read(self, now: float) -> SensorReading:
        """Tell how the sensor stands at a time [s]."""
        reading: Any = guarded(self._who, self._sensor.read, now)
        if not isinstance(reading, SensorReading):
            raise HookError(f"{self._who}: read answered {shown(reading)}; a SensorReading is needed")
        return reading
