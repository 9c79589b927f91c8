"""A robot's own sensors as its agent looks at them: what they publish, and whether that is up to date."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Callable, Protocol

from rqt_mrta_py.hooks.evaluator import SensorReading
from rqt_mrta_py.hooks.stream import Heard, Subscription

__all__ = ["RobotSensor", "RobotSensorFactory", "RobotSensorSetup"]


@dataclass(frozen=True)
class RobotSensorSetup:
    """What a sensor's reader is made from.

    Attributes:
        robot_id: whose sensor it is, normalised.
        topic: where it publishes, in the robot's namespace unless it begins with a slash.
        timeout: for how long a message is up to date [s].
        horizon: for how long messages are kept [s].
    """

    robot_id: str
    topic: str
    timeout: float
    horizon: float


class RobotSensor(Protocol):
    """Reads one sensor of one robot, for those who judge by it whether a task is applicable."""

    def subscription(self) -> Subscription:
        """Say what to hear; asked once."""
        ...

    def hear(self, heard: Heard) -> None:
        """Take in one message."""
        ...

    def read(self, now: float) -> SensorReading:
        """Tell how the sensor stands at a time [s], not before that of the newest message."""
        ...


RobotSensorFactory = Callable[[RobotSensorSetup], RobotSensor]
