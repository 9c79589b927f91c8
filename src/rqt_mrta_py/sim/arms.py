"""The arms of a simulated team: what angles they are commanded, and where they are."""

from __future__ import annotations

import math
from typing import Callable, Dict, Iterator, Mapping, Sequence, Tuple, cast

from rqt_mrta_py.hooks import ArmWorld, Outgoing, Subscription, TeamHeard, World
from rqt_mrta_py.sim.schedule import Schedule
from rqt_mrta_py.sim.sensing.mount import RobotSaid
from rqt_mrta_py.sim.simulated_robot import SimulatedRobot

__all__ = ["ARM_COMMAND", "ARM_STATE", "Arms"]

ARM_COMMAND = Subscription("arm/command", "std_msgs/Float64", ("data",))
"""What each robot with an arm hears in its own namespace: the angle of joint 1 to be reached [rad]."""

ARM_STATE = "arm/state"
"""Where each robot with an arm says the angle of its joint 1 [rad] (std_msgs/Float64)."""

_STATE_RATE = 10.0
"""How often a robot says where its arm is [Hz]."""


class Arms:
    """Hears where arms shall go, has it carried out, and tells where they are.

    An angle beyond the ends of an arm means the end; one that is not finite, and one heard while stopped, nothing.

    Args:
        robots: by id; those without an arm are passed over.
        control_rate: ticks a second [Hz].
    """

    def __init__(self, robots: Mapping[str, SimulatedRobot], control_rate: int) -> None:
        self._robots = {name: robot for name, robot in robots.items() if robot.model.arm is not None}
        self._schedule = Schedule(min(_STATE_RATE, control_rate), control_rate)
        # What was commanded and is not passed on yet [rad].
        self._wanted: Dict[str, float] = {}

    @property
    def robots(self) -> Tuple[str, ...]:
        """Ids of the robots that have an arm."""
        return tuple(self._robots)

    def listener(self, robots: Sequence[str]) -> Tuple[Subscription, Callable[[TeamHeard], None]]:
        """Say what robots hear, each in its own namespace, and who is told of it.

        Args:
            robots: ids of robots with arms, in the order of the rows that will be told.
        """
        names = tuple(robots)

        def hear(heard: TeamHeard) -> None:
            for row, fields in zip(heard.rows, heard.fields):
                if math.isfinite(fields["data"]) and not self._robots[names[row]].is_stopped:
                    self._wanted[names[row]] = fields["data"]

        return ARM_COMMAND, hear

    def act(self, world: World) -> None:
        """Pass on to the world what was commanded."""
        for name, angle in self._wanted.items():
            world.command(name, "arm", angle)
        self._wanted.clear()

    def tell(self, tick: int, world: World) -> Iterator[RobotSaid]:
        """Say where arms are, if it is time to; stopped robots are silent.

        Args:
            tick: of the mission, from 0.
            world: where they are; it has the capability ``arms`` if any robot has an arm.
        """
        if not self._robots or not self._schedule.is_due(tick):
            return
        for name, angle in cast(ArmWorld, world).arm_angles().items():
            if not self._robots[name].is_stopped:
                yield RobotSaid(name, (Outgoing(ARM_STATE, "std_msgs/Float64", {"data": angle}),))
