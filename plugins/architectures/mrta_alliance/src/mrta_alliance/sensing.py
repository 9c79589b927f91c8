"""What is said of each task's applicability (sensory feedback, input of equation 3.1).

Two sources, one or the other: the robot's own sensors, by readers and evaluators that plugins register; or the
SensoryFeedback of a low_level node, such as the original's, which has asked its own.
"""

from __future__ import annotations

from typing import Collection, Dict, Iterable, List, Mapping, Protocol

from mrta_alliance.equations import TIME_TOLERANCE
from mrta_alliance.messages import FEEDBACK_TOPIC, FEEDBACK_TYPE
from mrta_alliance.parameters import AllianceParameters, BehaviourSetParameters, SensorParameters
from rqt_mrta_py.hooks import (
    AgentSetup,
    Heard,
    RobotSensor,
    RobotSensorFactory,
    RobotSensorSetup,
    SensoryEvaluator,
    SensoryEvaluatorFactory,
    Subscription,
)
from rqt_mrta_py.model import Task, resolve_name

__all__ = ["Feedback", "HeardFeedback", "Sensing"]


class Feedback(Protocol):
    """Knows of each task what its sensory feedback is."""

    def subscriptions(self) -> List[Subscription]:
        """Say what to hear."""
        ...

    def take_in(self, messages: Iterable[Heard]) -> None:
        """Remember what came; messages of others are passed over."""
        ...

    def of(self, tasks: Collection[str], now: float) -> Mapping[str, bool]:
        """Tell tasks' sensory feedback, by task, in their order; what was given is not changed any more.

        Args:
            tasks: ids of tasks of this robot; new ones stand at the end.
            now: the time [s].
        """
        ...


class HeardFeedback:
    """The newest SensoryFeedback of each task, held for tau, then False; implements Feedback.

    Differs from the original nodes: what counts is when a message was received, not its stamp, and a value that changed
    to and fro expires like any other.
    """

    def __init__(self, robot_id: str, timeout: float) -> None:
        """Start without feedback, so that nothing is applicable.

        Args:
            robot_id: whose tasks are judged.
            timeout: tau [s].
        """
        self._topic = resolve_name(FEEDBACK_TOPIC, f"/{robot_id}/agent")
        self._timeout = timeout
        self._newest: Dict[str, Heard] = {}

    def subscriptions(self) -> List[Subscription]:
        """Say what to hear: the robot's own low_level node."""
        return [Subscription(FEEDBACK_TOPIC, FEEDBACK_TYPE, ("task_id", "applicable"))]

    def take_in(self, messages: Iterable[Heard]) -> None:
        """Remember the newest message of every task."""
        for message in messages:
            if message.topic == self._topic:
                self._newest[message.fields["task_id"]] = message

    def of(self, tasks: Collection[str], now: float) -> Mapping[str, bool]:
        """Tell tasks' sensory feedback."""
        return {task: self.finds_applicable(task, now) for task in tasks}

    def finds_applicable(self, task: str, now: float) -> bool:
        """Tell what was said last of a task, if that is not too long ago."""
        newest = self._newest.get(task)
        if newest is None or now - newest.receipt > self._timeout + TIME_TOLERANCE:
            return False
        return bool(newest.fields["applicable"])


class Sensing:
    """The robot's sensors and, by task, who judges them; implements Feedback."""

    def __init__(self, setup: AgentSetup, parameters: AllianceParameters, tasks: Mapping[str, Task]) -> None:
        """Make the readers of all sensors and the evaluators of all behaviour sets that have sensors.

        Args:
            setup: whose sensors they are, and who reads and judges them.
            parameters: see there.
            tasks: by id.

        Raises:
            ValueError: nobody registers a sensor, or an evaluator that a behaviour set names.
        """
        robot_id, evaluators = setup.robot_id, setup.evaluators
        self._readers = {
            sensor.topic_name: _reader(sensor, index, robot_id, setup.sensors)
            for index, sensor in enumerate(parameters.sensors)
        }
        # Any node of the robot's namespace resolves a relative topic alike.
        self._by_topic: Dict[str, RobotSensor] = {
            resolve_name(topic, f"/{robot_id}/agent"): reader for topic, reader in self._readers.items()
        }
        self._told: Mapping[str, bool] = {}
        self._sensors = {told.task_id: told.sensors for told in parameters.behaviour_sets if told.sensors}
        self._evaluators = {
            told.task_id: _evaluator(told, tasks[told.task_id], evaluators)
            for told in parameters.behaviour_sets
            if told.sensors
        }

    def subscriptions(self) -> List[Subscription]:
        """Say what to hear: what the readers ask for."""
        return [reader.subscription() for reader in self._readers.values()]

    def take_in(self, messages: Iterable[Heard]) -> None:
        """Give every message to the reader of its sensor; others are passed over."""
        if not self._by_topic:
            return
        for message in messages:
            reader = self._by_topic.get(message.topic)
            if reader is not None:
                reader.hear(message)

    def of(self, tasks: Collection[str], now: float) -> Mapping[str, bool]:
        """Tell tasks' sensory feedback; only those that have sensors need asking, and the same is given again."""
        if len(tasks) != len(self._told):
            self._told = dict.fromkeys(tasks, True)
        asked = {task: self.finds_applicable(task, now) for task in self._evaluators if task in self._told}
        if any(answer is not self._told[task] for task, answer in asked.items()):
            self._told = {**self._told, **asked}
        return self._told

    def finds_applicable(self, task: str, now: float) -> bool:
        """Ask a task's evaluator; a task without sensors is always applicable as far as they are concerned."""
        evaluator = self._evaluators.get(task)
        if evaluator is None:
            return True
        return evaluator.is_applicable(now, [self._readers[topic].read(now) for topic in self._sensors[task]])


def _reader(
    told: SensorParameters, index: int, robot_id: str, sensors: Mapping[str, RobotSensorFactory]
) -> RobotSensor:
    if told.plugin_name not in sensors:
        known = ", ".join(sorted(sensors)) or "none"
        raise ValueError(
            f"sensors/sensor{index}/plugin_name: nobody registers the sensor {told.plugin_name!r}; there are: {known}"
        )
    setup = RobotSensorSetup(robot_id, told.topic_name, told.timeout_duration, told.buffer_horizon)
    return sensors[told.plugin_name](setup)


def _evaluator(
    told: BehaviourSetParameters, task: Task, evaluators: Mapping[str, SensoryEvaluatorFactory]
) -> SensoryEvaluator:
    if told.evaluator not in evaluators:
        known = ", ".join(sorted(evaluators)) or "none"
        raise ValueError(
            f"behaviour set of task {told.task_id!r}: motivational_behaviour/sensory_feedback/plugin_name: nobody "
            f"registers the sensory evaluator {told.evaluator!r}; there are: {known}"
        )
    return evaluators[told.evaluator](task)
