"""Simulated sensors: from the true state of the world to what a robot gets to hear."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Callable, Protocol, Sequence

from rqt_mrta_py.hooks.robot_model import RobotModel
from rqt_mrta_py.hooks.stream import Outgoing
from rqt_mrta_py.hooks.world import World
from rqt_mrta_py.model import Pose, SensorSetup

if TYPE_CHECKING:
    import numpy as np

__all__ = ["Sensor", "SensorContext", "SensorFactory"]


@dataclass(frozen=True)
class SensorContext:
    """What a sensor is made from.

    Attributes:
        robot_id: whose sensor it is.
        model: what that robot is like.
        setup: topic, rate and parameters.
        start: where the robot starts in the frame ``map``.
        random: this robot's own generator for sensors.
    """

    robot_id: str
    model: RobotModel
    setup: SensorSetup
    start: Pose
    random: np.random.Generator


class Sensor(Protocol):
    """One simulated sensor of one robot."""

    def sense(self, now: float, truth: Pose, world: World) -> Sequence[Outgoing]:
        """Measure, at the sensor's own rate.

        Args:
            now: the time [s].
            truth: the robot's true pose in the frame ``map``.
            world: what can be measured besides.

        Returns:
            What the sensor publishes, relative names in the robot's namespace.
        """
        ...


SensorFactory = Callable[[SensorContext], Sensor]
