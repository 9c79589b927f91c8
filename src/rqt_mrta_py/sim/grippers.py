"""The grippers of a simulated team: what robots take hold of, carry and put down."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, Callable, Collection, Dict, Iterator, Mapping, NamedTuple, Optional, Sequence, Tuple

from rqt_mrta_py.hooks import GRIP_HALF_ANGLE, RobotModel, Subscription, TeamHeard, World
from rqt_mrta_py.model import LooseBody, Pose
from rqt_mrta_py.sim.holding import Holding
from rqt_mrta_py.sim.sensing.mount import RobotSaid
from rqt_mrta_py.sim.simulated_robot import SimulatedRobot

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

__all__ = ["GRIPPER", "GRIPPER_COMMAND", "GRIPPER_STATE", "Grippers", "can_grip"]

GRIPPER = "gripper"
"""The actuator of robots that can take hold of loose bodies."""

GRIPPER_COMMAND = Subscription("gripper/command", "std_msgs/Float64", ("data",))
"""What each robot with a gripper hears in its own namespace: above 0.5 to take hold, else to let go."""

GRIPPER_STATE = "gripper/state"
"""Where each robot with a gripper says what it holds (std_msgs/String): the body's id; empty if nothing."""

_CLOSED = 0.5


def can_grip(model: RobotModel, x: float, y: float) -> bool:
    """Tell whether a gripper reaches a place.

    Args:
        model: of the robot.
        x: of a body's centre, ahead of the robot's [m].
        y: of the same, to the left [m].
    """
    return math.hypot(x, y) - model.radius <= model.reach and abs(math.atan2(y, x)) <= GRIP_HALF_ANGLE


class _Near(NamedTuple):
    """A body that can be taken: how far its centre is [m], and its id."""

    distance: float
    body: str


class Grippers:
    """Hears what grippers are commanded, carries it out, and tells who holds what.

    While it is commanded to, a robot that holds nothing takes hold of the nearest body that it can take: in its reach,
    not too heavy, and held by no robot at work. It keeps it until it is commanded to let go. A robot that is stopped
    keeps what it holds, but without power it cannot keep others from taking it.

    Args:
        robots: by id; those without a gripper are passed over.
        bodies: by id, all that there ever were so far.
        control_rate: ticks a second [Hz].
    """

    def __init__(
        self, robots: Mapping[str, SimulatedRobot], bodies: Mapping[str, LooseBody], control_rate: int
    ) -> None:
        self._robots = {name: (row, each) for row, (name, each) in enumerate(robots.items()) if _has_one(each.model)}
        self._bodies = bodies
        self._holding = Holding({name: each for name, (_, each) in self._robots.items()}, GRIPPER_STATE, control_rate)
        # What was commanded and is not done yet: True to take hold.
        self._wanted: Dict[str, bool] = {}

    @property
    def robots(self) -> Tuple[str, ...]:
        """Ids of the robots that have a gripper."""
        return tuple(self._robots)

    @property
    def kept(self) -> Collection[str]:
        """Ids of all bodies in grippers, those of stopped robots too."""
        return self._holding.kept

    @property
    def held(self) -> Mapping[str, str]:
        """Who holds what: robots by the bodies' ids, without what stopped robots hold."""
        return self._holding.held

    def listener(self, robots: Sequence[str]) -> Tuple[Subscription, Callable[[TeamHeard], None]]:
        """Say what robots hear, each in its own namespace, and who is told of it.

        Args:
            robots: ids of robots with grippers, in the order of the rows that will be told.
        """
        names = tuple(robots)

        def hear(heard: TeamHeard) -> None:
            for row, fields in zip(heard.rows, heard.fields):
                self._command(names[row], fields["data"] > _CLOSED)

        return GRIPPER_COMMAND, hear

    def act(self, world: World, where: Callable[[], NDArray[np.float64]], taken: Collection[str] = ()) -> None:
        """Carry out what was commanded.

        Args:
            world: where bodies and robots are.
            where: gives true poses of all robots in the frame ``map``: x, y [m] and yaw [rad], shape (robots, 3).
            taken: ids of bodies that others than grippers hold.
        """
        if not self._wanted:
            return
        for name, (row, robot) in self._robots.items():
            wanted = self._wanted.get(name)
            if wanted is None:
                continue
            if robot.is_stopped:
                del self._wanted[name]
            elif not wanted:
                self._holding.drop(name, world)
                del self._wanted[name]
            else:
                body = self._nearest(robot.model, Pose(*where()[row].tolist()), world, taken)
                if body is not None:
                    self._holding.take(name, body, world)
                    del self._wanted[name]

    def forget(self, name: str) -> None:
        """Let a robot hold nothing any more: it was taken away, and what it held with it."""
        self._holding.forget(name)

    def tell(self, tick: int) -> Iterator[RobotSaid]:
        """Say what robots hold: at once when it changes, else twice a second; stopped robots are silent.

        Args:
            tick: of the mission, from 0.
        """
        return self._holding.tell(tick)

    def _command(self, name: str, close: bool) -> None:
        if self._robots[name][1].is_stopped or close == (name in self._holding.by_robot):
            self._wanted.pop(name, None)
        else:
            self._wanted[name] = close

    def _nearest(self, model: RobotModel, pose: Pose, world: World, taken: Collection[str]) -> Optional[str]:
        """Find the nearest body that a robot can take; of equally near ones the first by id."""
        held = self.held
        found = []
        for name, state in world.bodies().items():
            body = self._bodies.get(name)
            if body is None or body.mass > model.max_load or name in held or name in taken:
                continue
            place = Pose(state.position[0], state.position[1])
            distance, bearing = pose.distance(place), pose.bearing(place)
            if can_grip(model, distance * math.cos(bearing), distance * math.sin(bearing)):
                found.append(_Near(distance, name))
        return min(found).body if found else None


def _has_one(model: RobotModel) -> bool:
    return GRIPPER in model.actuators
