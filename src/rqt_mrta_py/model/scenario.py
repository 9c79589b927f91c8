"""What is simulated: arena, obstacles, robots with their sensors, and what happens on the way."""

from __future__ import annotations

import re
from dataclasses import dataclass, field
from enum import Enum
from typing import Any, Mapping, Optional, Tuple

from rqt_mrta_py.model.geometry import Pose

__all__ = [
    "MAPPED_TOPICS",
    "Arena",
    "Dispenser",
    "LooseBody",
    "MapKnowledge",
    "Obstacle",
    "RadioSetup",
    "RobotSetup",
    "ScenarioEvent",
    "ScenarioEventKind",
    "ScenarioSpec",
    "SensorSetup",
]


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
class LooseBody:
    """A body that robots can push or carry: rubbish, a block.

    Attributes:
        id: unique among bodies, obstacles and robots.
        pose: of its centre at the start, in the frame ``map``; it stands on the floor.
        size: length, width, height [m].
        mass: [kg].
        kind: what it is, as those who look for it call it.
        friction: coefficient, of it on the floor.
    """

    id: str
    pose: Pose
    size: Tuple[float, float, float]
    mass: float = 0.2
    kind: str = "thing"
    friction: float = 0.5


@dataclass(frozen=True)
class Dispenser:
    """A place where loose bodies of one kind come from, one after the other.

    The first lies there at the start. The next one appears once the last one has been carried off: it is farther than
    its own length from the place, and nothing else is there.

    Attributes:
        id: unique among dispensers, bodies, obstacles and robots.
        pose, size, mass, kind, friction: of each body, as of a ``LooseBody``.
        stock: how many bodies in all; None: as many as are needed.
    """

    id: str
    pose: Pose
    size: Tuple[float, float, float]
    mass: float = 0.2
    kind: str = "thing"
    friction: float = 0.5
    stock: Optional[int] = None

    def body(self, number: int) -> LooseBody:
        """Give a body as it appears.

        Args:
            number: from 1, in the order of their appearance; it ends the body's id, as in ``sw3_1``.
        """
        return LooseBody(f"{self.id}_{number}", self.pose, self.size, self.mass, self.kind, self.friction)

    def gives(self, body_id: str) -> bool:
        """Tell whether a body of this id may come from here."""
        name, _, number = body_id.rpartition("_")
        if name != self.id or not re.fullmatch("[1-9][0-9]{0,8}", number):
            return False
        return self.stock is None or int(number) <= self.stock


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


class MapKnowledge(Enum):
    """What a robot knows of the map when it starts.

    * ``known``: the arena and all obstacles.
    * ``unknown``: the arena only; it maps what its range finder meets, robots too until it sees where they were free.
    """

    KNOWN = "known"
    UNKNOWN = "unknown"


MAPPED_TOPICS = ("pose", "scan")
"""What a robot hears that maps, in its own namespace."""


@dataclass(frozen=True)
class RobotSetup:
    """One simulated robot.

    Attributes:
        id: as in the application.
        model: the name under which its model is registered.
        start: start pose in the frame ``map``.
        sensors: in file order.
        capabilities: what it can do, beyond its model's.
        map: what it knows of the map when it starts.
    """

    id: str
    model: str
    start: Pose
    sensors: Tuple[SensorSetup, ...] = ()
    capabilities: Tuple[str, ...] = ()
    map: MapKnowledge = MapKnowledge.KNOWN


@dataclass(frozen=True)
class RadioSetup:
    """The radio between robots.

    Attributes:
        kind: the name under which the link's model is registered.
        parameters: what that model wants to know.
    """

    kind: str = "perfect"
    parameters: Mapping[str, Any] = field(default_factory=dict)


class ScenarioEventKind(Enum):
    """What a scenario can make happen.

    * ``robot_stops``: it stands still and falls silent on all its topics; ``robot_returns`` undoes one stop.
    * ``robot_removed``: somebody takes it off the floor for good, with what it holds; an operator tells so.
    * ``robot_sticks``: it stands still but is heard; ``robot_comes_free`` undoes it.
    * ``robot_slows``: it drives at ``factor`` of what it is commanded, from 0 to 1; 1 undoes it.
    * ``robot_clock_shifts``: its clock is off by ``offset`` [s] from then on; 0 sets it right.
    * ``radio_fails``: a robot neither sends to nor hears from any other; ``radio_returns`` undoes it.
    * ``radio_partitions``: only robots of one of the ``groups`` (lists of ids) reach one another, whoever is in none
      reaches nobody; ``radio_heals`` undoes it.
    * ``radio_changes``: from then on the radio is of another ``kind``, or has other parameters.
    * ``task_appears``: a listed task that was not there before is there.
    * ``task_withdrawn``: an operator takes a task back.
    * ``task_reassigned``: an operator wants a task to be carried out by another robot.
    """

    ROBOT_STOPS = "robot_stops"
    ROBOT_RETURNS = "robot_returns"
    ROBOT_REMOVED = "robot_removed"
    ROBOT_STICKS = "robot_sticks"
    ROBOT_COMES_FREE = "robot_comes_free"
    ROBOT_SLOWS = "robot_slows"
    ROBOT_CLOCK_SHIFTS = "robot_clock_shifts"
    RADIO_FAILS = "radio_fails"
    RADIO_RETURNS = "radio_returns"
    RADIO_PARTITIONS = "radio_partitions"
    RADIO_HEALS = "radio_heals"
    RADIO_CHANGES = "radio_changes"
    TASK_APPEARS = "task_appears"
    TASK_WITHDRAWN = "task_withdrawn"
    TASK_REASSIGNED = "task_reassigned"

    @property
    def undoes(self) -> Optional[ScenarioEventKind]:
        """Give the kind that this one ends; None if it ends none.

        What happens to one robot is counted: it takes as many ends as there were beginnings.
        """
        return _UNDOES.get(self)


_UNDOES = {
    ScenarioEventKind.ROBOT_RETURNS: ScenarioEventKind.ROBOT_STOPS,
    ScenarioEventKind.ROBOT_COMES_FREE: ScenarioEventKind.ROBOT_STICKS,
    ScenarioEventKind.RADIO_RETURNS: ScenarioEventKind.RADIO_FAILS,
    ScenarioEventKind.RADIO_HEALS: ScenarioEventKind.RADIO_PARTITIONS,
}


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
        duration: of the mission, at most [s].
        control_rate: control ticks a second [Hz]; an integer, for the tick is the clock.
        picture_period: one monitor picture every so many seconds of mission time; 0 for none [s].
        radio: between robots, at the start.
        planner: the name under which is registered what robots find their ways with.
        bodies: that can be pushed or carried, in file order.
        linger: the mission ends so long after all tasks have ended that can; None: it goes on to its duration [s].
        dispensers: where further such bodies come from, in file order.
    """

    arena: Arena
    obstacles: Tuple[Obstacle, ...]
    robots: Tuple[RobotSetup, ...]
    events: Tuple[ScenarioEvent, ...] = ()
    world: str = "bullet"
    duration: float = 60.0
    control_rate: int = 20
    picture_period: float = 1.0
    radio: RadioSetup = field(default_factory=RadioSetup)
    planner: str = "astar"
    bodies: Tuple[LooseBody, ...] = ()
    dispensers: Tuple[Dispenser, ...] = ()
    linger: Optional[float] = None

    @property
    def is_open_ended(self) -> bool:
        """Whether the mission ends with its last task, so that only the latest time of its end is known before."""
        return self.linger is not None

    def planned_duration(self, asked: Optional[float]) -> Optional[float]:
        """Give how long the mission is planned to take [s]; None if nobody knows.

        Args:
            asked: what somebody asks for instead of its own duration; None if nobody does [s].
        """
        if asked is not None:
            return asked
        return None if self.is_open_ended else self.duration

    @property
    def first_bodies(self) -> Tuple[LooseBody, ...]:
        """The bodies that there are at the start: those listed, then the first one of each dispenser."""
        return (*self.bodies, *(dispenser.body(1) for dispenser in self.dispensers))
