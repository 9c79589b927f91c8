"""Simulated sensors: from the true state of the world to what a robot gets to hear."""

from __future__ import annotations

from dataclasses import dataclass
from types import MappingProxyType
from typing import TYPE_CHECKING, Callable, Collection, Mapping, NamedTuple, Optional, Protocol, Sequence

from rqt_mrta_py.hooks.robot_model import RobotModel
from rqt_mrta_py.hooks.stream import Outgoing, TeamOutgoing
from rqt_mrta_py.hooks.world import World
from rqt_mrta_py.model import LooseBody, Pose, SensorSetup

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

__all__ = [
    "RayPattern",
    "Sensor",
    "SensorContext",
    "SensorFactory",
    "SensorMoment",
    "TeamMoment",
    "TeamSensor",
    "TeamSensorFactory",
]

_NOTHING: Mapping[str, str] = MappingProxyType({})


@dataclass(frozen=True)
class SensorContext:
    """What a sensor is made from.

    Attributes:
        robot_id: whose sensor it is.
        model: what that robot is like.
        setup: topic, rate and parameters.
        start: where the robot starts in the frame ``map``.
        random: this robot's own generator for sensors.
        bodies: the scenario's loose bodies, as each was when it appeared; all that there ever were so far.
    """

    robot_id: str
    model: RobotModel
    setup: SensorSetup
    start: Pose
    random: np.random.Generator
    bodies: Collection[LooseBody] = ()


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
        held: who holds a loose body, by the body's id; what a stopped robot holds anybody can take, so it is left out.
    """

    now: float
    truth: Pose
    ranges: Optional[NDArray[np.float64]]
    world: World
    held: Mapping[str, str] = _NOTHING


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


class TeamMoment(NamedTuple):
    """What a kind of sensor measures from, on all robots whose sensors measure now.

    Attributes:
        members: which robots: their places among those that the sensor was made for, rising, shape (robots,).
        now: the time on each robot's clock [s], shape (robots,).
        truth: true poses in the frame ``map``: x, y [m] and yaw [rad], shape (robots, 3).
        ranges: true distances along the rays that the sensor wants [m], shape (robots, rays), infinity where nothing
            is seen; None if it wants none.
        world: what can be measured besides.
        held: as of a ``SensorMoment``.

    No array is to be changed, or kept.
    """

    members: NDArray[np.intp]
    now: NDArray[np.float64]
    truth: NDArray[np.float64]
    ranges: Optional[NDArray[np.float64]]
    world: World
    held: Mapping[str, str] = _NOTHING


class TeamSensor(Protocol):
    """One kind of simulated sensor on all robots that carry it alike, measured in one go."""

    @property
    def rays(self) -> Optional[RayPattern]:
        """The rays that each robot wants cast whenever it measures, asked once; None if it wants none."""
        ...

    def sense(self, moment: TeamMoment) -> Sequence[TeamOutgoing]:
        """Measure, at the sensors' own rate.

        Returns:
            What is published, with rows in the order of ``members``.
        """
        ...


TeamSensorFactory = Callable[[Sequence[SensorContext]], TeamSensor]
"""Takes one context for each robot, in the scenario's order; their setups are equal."""
