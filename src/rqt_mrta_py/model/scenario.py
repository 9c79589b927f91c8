"""What is simulated: arena, obstacles, robots with their sensors, and what happens on the way."""

from __future__ import annotations

from dataclasses import dataclass, field
from enum import Enum
from typing import Any, Mapping, Optional, Tuple

from rqt_mrta_py.model.geometry import Pose

__all__ = ["Arena", "Obstacle", "RobotSetup", "ScenarioEvent", "ScenarioEventKind", "ScenarioSpec", "SensorSetup"]


@dataclass(frozen=True)
class Arena:
    """A rectangle of floor with a wall around it, in the frame ``map``.

    Attributes:
        min_x, min_y, max_x, max_y: inner faces of the walls [m].
        wall_height: [m].
    """

    min_x: float
    min_y: float
    max_x: float
    max_y: float
    wall_height: float = 0.3


@dataclass(frozen=True)
class Obstacle:
    """A fixed body on the floor.

    Attributes:
        id: unique among obstacles.
        pose: of its centre, in the frame ``map``.
        size: length along its own x, width along its own y, height [m]; a cylinder has length and width equal to
            its diameter.
        shape: ``box`` or ``cylinder``.
    """

    id: str
    pose: Pose
    size: Tuple[float, float, float]
    shape: str = "box"


@dataclass(frozen=True)
class SensorSetup:
    """One simulated sensor of one robot.

    Attributes:
        kind: the name under which the sensor is registered.
        topic: where it publishes, relative to the robot's namespace.
        rate: [Hz].
        parameters: what the sensor's model wants to know.
    """

    kind: str
    topic: str
    rate: float
    parameters: Mapping[str, Any] = field(default_factory=dict)


@dataclass(frozen=True)
class RobotSetup:
    """One simulated robot.

    Attributes:
        id: as in the application.
        model: the name under which its model is registered.
        start: start pose in the frame ``map``.
        sensors: in file order.
        capabilities: what it can do, beyond its model's.
    """

    id: str
    model: str
    start: Pose
    sensors: Tuple[SensorSetup, ...] = ()
    capabilities: Tuple[str, ...] = ()


class ScenarioEventKind(Enum):
    """What a scenario can make happen."""

    ROBOT_STOPS = "robot_stops"
    ROBOT_RETURNS = "robot_returns"


@dataclass(frozen=True)
class ScenarioEvent:
    """Something that happens at a given mission time, on purpose.

    Attributes:
        time: mission time [s].
        kind: what happens.
        robot: whom it happens to; None if no robot.
        task: which task it happens to; None if no task.
        parameters: how strongly, how far, to whom.
    """

    time: float
    kind: ScenarioEventKind
    robot: Optional[str] = None
    task: Optional[str] = None
    parameters: Mapping[str, Any] = field(default_factory=dict)


@dataclass(frozen=True)
class ScenarioSpec:
    """Everything that is simulated in one application.

    Attributes:
        arena: floor and walls.
        obstacles: in file order.
        robots: in file order.
        events: by time, then file order.
        world: the name under which the world is registered.
        duration: of the mission [s].
        control_rate: control ticks a second [Hz]; an integer, for the tick is the clock.
        picture_period: one monitor picture every so many seconds of mission time; 0 for none [s].
    """

    arena: Arena
    obstacles: Tuple[Obstacle, ...]
    robots: Tuple[RobotSetup, ...]
    events: Tuple[ScenarioEvent, ...] = ()
    world: str = "bullet"
    duration: float = 60.0
    control_rate: int = 20
    picture_period: float = 1.0
