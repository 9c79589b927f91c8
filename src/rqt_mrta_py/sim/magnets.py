"""The electromagnets of a simulated team: what they take, hold and let go."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, Callable, Collection, Dict, Iterator, Mapping, Optional, Sequence, Tuple, cast

from rqt_mrta_py.hooks import ArmModel, ArmWorld, BodyState, Subscription, TeamHeard, World
from rqt_mrta_py.model import LooseBody, Pose
from rqt_mrta_py.sim.body_footprints import axes_of
from rqt_mrta_py.sim.holding import Holding
from rqt_mrta_py.sim.sensing.mount import RobotSaid
from rqt_mrta_py.sim.simulated_robot import SimulatedRobot

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

__all__ = ["MAGNET_COMMAND", "MAGNET_STATE", "Magnets", "is_at_face"]

MAGNET_COMMAND = Subscription("magnet/command", "std_msgs/Float64", ("data",))
"""What each robot with a magnet hears in its own namespace: above 0.5 to switch it on, else off."""

MAGNET_STATE = "magnet/state"
"""Where each robot with a magnet says what it holds (std_msgs/String): the body's id; empty if nothing."""

_ON = 0.5
_ALIGNED = math.cos(math.radians(10.0))
"""Of the angle between a magnet's face and the face that it holds, at most."""
_PRESSED = 0.005
"""So deep a magnet's face may be in what it is pressed against [m]."""

_Vector = Tuple[float, float, float]


def is_at_face(arm: ArmModel, base: Pose, angle: float, body: BodyState, size: _Vector) -> bool:
    """Tell whether a magnet holds a body that is there: its face lies on the metal strip of the body's rear face.

    A body's rear face is the one towards its own -y; it is about parallel to the magnet's face, within 10 degrees.

    Args:
        arm: that carries the magnet.
        base: of the robot, frame ``map``.
        angle: of joint 1 [rad].
        body: where the body is.
        size: its length, width, height [m].
    """
    magnet = arm.magnet_pose(base, angle)
    along, ahead, up = axes_of(body.orientation)
    if math.cos(base.yaw) * ahead[0] + math.sin(base.yaw) * ahead[1] < _ALIGNED:
        return False
    from_centre = (
        magnet.x - body.position[0],
        magnet.y - body.position[1],
        arm.height_at(angle) - body.position[2],
    )
    gap = -_dot(from_centre, ahead) - size[1] / 2
    beside, above = abs(_dot(from_centre, along)), abs(_dot(from_centre, up))
    return -_PRESSED <= gap <= arm.grip_gap and beside <= size[0] / 2 and above <= size[2] / 2


class Magnets:
    """Hears whether magnets shall be on, carries it out, and tells who holds what.

    A magnet that is on and holds nothing takes the first body by id that is at its face, not too heavy, and held by no
    robot at work. It holds that until it is switched off, or something has torn it from the face. As of ``Grippers``, a
    robot that is stopped keeps what it holds, but cannot keep another magnet from taking it.

    Args:
        robots: by id; those without an arm are passed over.
        bodies: by id, all that there ever were so far.
        control_rate: ticks a second [Hz].
    """

    def __init__(
        self, robots: Mapping[str, SimulatedRobot], bodies: Mapping[str, LooseBody], control_rate: int
    ) -> None:
        self._all = robots
        self._arms: Dict[str, Tuple[int, ArmModel]] = {
            name: (row, robot.model.arm)
            for row, (name, robot) in enumerate(robots.items())
            if robot.model.arm is not None
        }
        self._bodies = bodies
        self._holding = Holding({name: robots[name] for name in self._arms}, MAGNET_STATE, control_rate)
        self._on = dict.fromkeys(self._arms, False)
        self._shall_look = False

    @property
    def robots(self) -> Tuple[str, ...]:
        """Ids of the robots that have a magnet."""
        return tuple(self._arms)

    @property
    def held(self) -> Mapping[str, str]:
        """Who holds what: robots by the bodies' ids, without what stopped robots hold."""
        return self._holding.held

    @property
    def kept(self) -> Collection[str]:
        """Ids of all bodies at magnets, those of stopped robots too."""
        return self._holding.kept

    def listener(self, robots: Sequence[str]) -> Tuple[Subscription, Callable[[TeamHeard], None]]:
        """Say what robots hear, each in its own namespace, and who is told of it.

        Args:
            robots: ids of robots with magnets, in the order of the rows that will be told.
        """
        names = tuple(robots)

        def hear(heard: TeamHeard) -> None:
            for row, fields in zip(heard.rows, heard.fields):
                if not self._all[names[row]].is_stopped:
                    self._on[names[row]] = fields["data"] > _ON

        return MAGNET_COMMAND, hear

    def act(self, world: World, where: Callable[[], NDArray[np.float64]], taken: Collection[str] = ()) -> None:
        """Let go what magnets that are off hold, and take what is at the faces of those that are on.

        Args:
            world: where bodies and robots are.
            where: gives true poses of all robots in the frame ``map``: x, y [m] and yaw [rad], shape (robots, 3).
            taken: ids of bodies that others than magnets hold.
        """
        holds = self._holding.by_robot
        for name in [name for name in holds if not self._on[name]]:
            self._holding.drop(name, world)
        looking = [name for name, on in self._on.items() if on and not self._all[name].is_stopped]
        if not any(name not in holds or self._shall_look for name in looking):
            return
        angles, states, poses = cast(ArmWorld, world).arm_angles(), world.bodies(), where()
        for name in looking:
            row, arm = self._arms[name]
            base = Pose(*poses[row].tolist())
            held = holds.get(name)
            if held is None:
                found = self._at_face(name, base, angles[name], states, taken)
                if found is not None:
                    for loser in self._holding.take(name, found, world):
                        self._on[loser] = False
            elif not is_at_face(arm, base, angles[name], states[held], self._bodies[held].size):
                self._holding.drop(name, world)
        self._shall_look = False

    def forget(self, name: str) -> None:
        """Let a robot hold nothing any more: it was taken away, and what it held with it."""
        self._holding.forget(name)

    def tell(self, tick: int) -> Iterator[RobotSaid]:
        """Say what robots hold: at once when it changes, else twice a second; stopped robots are silent.

        Args:
            tick: of the mission, from 0.
        """
        # Whether something was torn off need not be asked more often than it is told.
        self._shall_look = self._shall_look or self._holding.is_due(tick)
        return self._holding.tell(tick)

    def _at_face(
        self,
        name: str,
        base: Pose,
        angle: float,
        states: Mapping[str, BodyState],
        taken: Collection[str],
    ) -> Optional[str]:
        arm = self._arms[name][1]
        held, most = self.held, self._all[name].model.max_load
        for body in sorted(states.keys() & self._bodies.keys()):
            known = self._bodies[body]
            is_free = body not in held and body not in taken and known.mass <= most
            if is_free and is_at_face(arm, base, angle, states[body], known.size):
                return body
        return None


def _dot(first: _Vector, second: _Vector) -> float:
    return first[0] * second[0] + first[1] * second[1] + first[2] * second[2]
