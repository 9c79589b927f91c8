"""Simulated sensors: from the true state of the world to what a robot gets to hear."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Callable, NamedTuple, Optional, Protocol, Sequence

from rqt_mrta_py.hooks.robot_model import RobotModel
from rqt_mrta_py.hooks.stream import Outgoing
from rqt_mrta_py.hooks.world import World
from rqt_mrta_py.model import Pose, SensorSetup

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

__all__ = ["RayPattern", "Sensor", "SensorContext", "SensorFactory", "SensorMoment"]


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


class RayPattern(NamedTuple):
    """Rays that a sensor wants cast whenever it measures; robots that want the same are served together.

    Attributes:
        bearings: directions relative to the robot's heading [rad], shape (rays,).
        max_range: what lies farther is not seen [m].
    """

    bearings: NDArray[np.float64]
    max_range: float


class SensorMoment(NamedTuple):
    """What a sensor measures from.

    Attributes:
        now: the time, on the robot's clock [s].
        truth: the robot's true pose in the frame ``map``.
        ranges: true distances along the rays that the sensor wants [m], shape (rays,), infinity where nothing is
            seen; not to be changed; None if it wants none.
        world: what can be measured besides.
    """

    now: float
    truth: Pose
    ranges: Optional[NDArray[np.float64]]
    world: World


class Sensor(Protocol):
    """One simulated sensor of one robot."""

    @property
    def rays(self) -> Optional[RayPattern]:
        """The rays it wants cast whenever it measures, asked once; None if it wants none."""
        ...

    def sense(self, moment: SensorMoment) -> Sequence[Outgoing]:
        """Measure, at the sensor's own rate.

        Returns:
            What the sensor publishes, relative names in the robot's namespace.
        """
        ...


SensorFactory = Callable[[SensorContext], Sensor]
