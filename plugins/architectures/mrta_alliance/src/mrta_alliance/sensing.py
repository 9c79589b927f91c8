"""What a robot's own sensors say of each task (sensory feedback, input of equation 3.1)."""

from __future__ import annotations

from typing import Dict, Iterable, List, Mapping, Optional, Sequence

from mrta_alliance.equations import TIME_TOLERANCE
from mrta_alliance.parameters import AllianceParameters, BehaviourSetParameters
from rqt_mrta_py.hooks import Heard, SensorReading, SensoryEvaluator, SensoryEvaluatorFactory, Subscription
from rqt_mrta_py.model import Task, resolve_name

__all__ = ["Sensing"]


class Sensing:
    """The robot's sensors and, by task, who judges them."""

    def __init__(
        self,
        robot_id: str,
        parameters: AllianceParameters,
        tasks: Mapping[str, Task],
        evaluators: Mapping[str, SensoryEvaluatorFactory],
    ) -> None:
        """Make the evaluators of all behaviour sets that have sensors.

        Args:
            robot_id: whose sensors they are.
            parameters: see there.
            tasks: by id.
            evaluators: factories by name.

        Raises:
            ValueError: nobody registers an evaluator that a behaviour set names.
        """
        # Any node of the robot's namespace resolves a relative topic alike.
        self._resolved = {
            sensor.topic_name: resolve_name(sensor.topic_name, f"/{robot_id}/agent") for sensor in parameters.sensors
        }
        self._timeouts = {sensor.topic_name: sensor.timeout_duration for sensor in parameters.sensors}
        self._newest: Dict[str, Optional[Heard]] = dict.fromkeys(self._resolved.values())
        self._sensors = {told.task_id: told.sensors for told in parameters.behaviour_sets if told.sensors}
        self._evaluators = {
            told.task_id: _evaluator(told, tasks[told.task_id], evaluators)
            for told in parameters.behaviour_sets
            if told.sensors
        }

    def subscriptions(self) -> List[Subscription]:
        """Say what to hear: that the sensors speak, not what."""
        return [Subscription(topic) for topic in self._timeouts]

    def take_in(self, messages: Iterable[Heard]) -> None:
        """Remember the newest message of every sensor; others are passed over."""
        for message in messages:
            if message.topic in self._newest:
                self._newest[message.topic] = message

    def finds_applicable(self, task: str, now: float) -> bool:
        """Ask a task's evaluator; a task without sensors is always applicable as far as they are concerned.

        Args:
            task: id of a task of this robot.
            now: the time [s].
        """
        evaluator = self._evaluators.get(task)
        return evaluator is None or evaluator.is_applicable(now, self._readings(self._sensors[task], now))

    def _readings(self, topics: Sequence[str], now: float) -> List[SensorReading]:
        readings = []
        for topic in topics:
            newest = self._newest[self._resolved[topic]]
            fresh = newest is not None and now - newest.receipt <= self._timeouts[topic] + TIME_TOLERANCE
            readings.append(SensorReading(topic, fresh, newest))
        return readings


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
