"""What is simulated: moles move straight ahead through soft ground and never meet anything."""

from __future__ import annotations

from typing import Any, Dict, FrozenSet, List, Mapping, Optional, Sequence, Set, Tuple

import numpy as np

from rqt_mrta_py.hooks import (
    AssemblyOutcome,
    AssemblyRequest,
    BlockPlacement,
    Body,
    BodyState,
    Contact,
    LinkSetup,
    Outgoing,
    PlannerSetup,
    RobotModel,
    SensorContext,
    SensorMoment,
    SimError,
    TeamMoment,
    TeamOutgoing,
    WorldSetup,
)
from rqt_mrta_py.model import Pose, Twist

MOLE = RobotModel("mole", "differential", 0.4, 0.3, 0.2, 0.25, 5.0, 0.05, 0.25, 0.7, 1.0, 0.1)
DETOUR = 42.0


class Burrow:
    def __init__(self) -> None:
        self._robots: Dict[str, Pose] = {}
        self._speeds: Dict[str, float] = {}
        self._frozen: Set[str] = set()
        self._tick = 0.0

    @property
    def capabilities(self) -> FrozenSet[str]:
        return frozenset({"drive:differential", "freeze"})

    def reset(self, setup: WorldSetup) -> None:
        self._robots = {robot.id: robot.start for robot in setup.robots}
        self._speeds = dict.fromkeys(self._robots, 0.0)
        self._tick = setup.tick

    def add_body(self, body: Body) -> None:
        raise SimError(f"{body.id}: there is no room for bodies in a burrow")

    def remove_body(self, body_id: str) -> None:
        raise SimError(f"{body_id}: there are no bodies in a burrow")

    def attach(self, robot: str, body_id: str) -> None:
        self.remove_body(body_id)

    def detach(self, body_id: str) -> None:
        self.remove_body(body_id)

    def freeze(self, robot: str, frozen: bool) -> None:
        (self._frozen.add if frozen else self._frozen.discard)(robot)

    def command(self, robot: str, actuator: str, value: Twist) -> None:
        self._speeds[robot] = value.vx

    def step(self) -> None:
        for robot, place in self._robots.items():
            if robot not in self._frozen:
                self._robots[robot] = Pose(place.x + self._speeds[robot] * self._tick, place.y, place.yaw)

    def poses(self) -> Any:
        return np.array([(place.x, place.y, place.yaw) for place in self._robots.values()], dtype=np.float64)

    def bodies(self) -> Mapping[str, BodyState]:
        return {}

    def contacts(self) -> Tuple[Contact, ...]:
        return ()

    def ranges(self, robots: Sequence[str], bearings: Any, max_range: float) -> Any:
        return np.full((len(robots), len(bearings)), np.inf)

    def close(self) -> None:
        pass


class Detour:
    """Whatever the way, it is 42 m long."""

    def __init__(self, setup: PlannerSetup) -> None:
        self.radius = setup.radius

    def path(self, start: Pose, goal: Pose) -> Optional[Tuple[Pose, ...]]:
        return (goal,)

    def cost_field(self, goal: Pose) -> Detour:
        return self

    def at(self, place: Pose) -> Optional[float]:
        return DETOUR

    def observe(self, obstacles: Sequence[Tuple[Pose, float]]) -> None:
        pass


class TinCan:
    """Two cans and a string: nothing is lost, everything is late."""

    def __init__(self, setup: LinkSetup) -> None:
        self._delay = float(setup.parameters["delay"])

    def deliveries(self, sender: str, receiver: str, now: float) -> Sequence[float]:
        return [0.0 if sender == receiver or not (sender and receiver) else self._delay]


class Odometer:
    rays = None

    def __init__(self, context: SensorContext) -> None:
        self._topic = context.setup.topic
        self._start = context.start.x

    def sense(self, moment: SensorMoment) -> List[Outgoing]:
        return [Outgoing(self._topic, "std_msgs/Float64", {"data": moment.truth.x - self._start})]


class Ranks:
    """Which mole lies lower than which: none of them could tell alone."""

    rays = None

    def __init__(self, contexts: Sequence[SensorContext]) -> None:
        self._topic = contexts[0].setup.topic
        self._robots = [context.robot_id for context in contexts]

    def sense(self, moment: TeamMoment) -> List[TeamOutgoing]:
        robots = tuple(self._robots[member] for member in moment.members)
        ranks = np.argsort(np.argsort(moment.truth[:, 1], kind="stable")).astype(np.int64)
        return [TeamOutgoing(self._topic, "std_msgs/Int32", robots, {"data": ranks + 1})]


def crumbs(request: AssemblyRequest) -> AssemblyOutcome:
    placements = []
    for y, row in enumerate(request.structure.heights, 1):
        for x, height in enumerate(row, 1):
            placements += [BlockPlacement(x, y, z, 1) for z in range(1, height + 1)]
    return AssemblyOutcome(tuple(placements))
