"""Who holds which loose body, whatever it is held by, and what robots say of it."""

from __future__ import annotations

from typing import Collection, Dict, Iterator, List, Mapping, Sequence

from rqt_mrta_py.hooks import Outgoing, World
from rqt_mrta_py.sim.schedule import Schedule
from rqt_mrta_py.sim.sensing.mount import RobotSaid
from rqt_mrta_py.sim.simulated_robot import SimulatedRobot

__all__ = ["Holding"]

_STATE_RATE = 2.0
"""How often a robot says what it holds while that stays the same [Hz]."""


class Holding:
    """Keeps what the robots of a team hold by one kind of actuator; each holds one body at the most.

    A robot that is stopped keeps what it holds, but without power it cannot keep others from taking it.

    Attributes:
        by_robot: ids of the bodies by those of the robots that hold them, stopped ones too.

    Args:
        robots: by id, those that have the actuator.
        topic: relative, where each says what it holds (std_msgs/String): the body's id; empty if nothing.
        control_rate: ticks a second [Hz].
    """

    def __init__(self, robots: Mapping[str, SimulatedRobot], topic: str, control_rate: int) -> None:
        self.by_robot: Dict[str, str] = {}
        self._robots = robots
        self._topic = topic
        self._schedule = Schedule(min(_STATE_RATE, control_rate), control_rate)
        self._told: Dict[str, str] = {}

    @property
    def held(self) -> Mapping[str, str]:
        """Who holds what: robots by the bodies' ids, without what stopped robots hold."""
        return {body: robot for robot, body in self.by_robot.items() if not self._robots[robot].is_stopped}

    @property
    def kept(self) -> Collection[str]:
        """Ids of all bodies that are held, by stopped robots too."""
        return self.by_robot.values()

    def take(self, name: str, body: str, world: World) -> Sequence[str]:
        """Let a robot take a body, off whoever holds it.

        Args:
            name: of the robot, which holds nothing.
            body: its id.
            world: where both are.

        Returns:
            The robots that have lost it.
        """
        losers: List[str] = [other for other, held in self.by_robot.items() if held == body]
        for other in losers:
            self.drop(other, world)
        world.attach(name, body)
        self.by_robot[name] = body
        return losers

    def drop(self, name: str, world: World) -> None:
        """Let a robot let go of what it holds."""
        world.detach(self.by_robot.pop(name))

    def forget(self, name: str) -> None:
        """Let a robot hold nothing any more: it was taken away, and what it held with it."""
        self.by_robot.pop(name, None)

    def is_due(self, tick: int) -> bool:
        """Tell whether all say what they hold at a tick, even if it has stayed the same."""
        return self._schedule.is_due(tick)

    def tell(self, tick: int) -> Iterator[RobotSaid]:
        """Say what robots hold: at once when it changes, else twice a second; stopped robots are silent.

        Args:
            tick: of the mission, from 0.
        """
        is_due = self.is_due(tick)
        for name, robot in self._robots.items():
            held = self.by_robot.get(name, "")
            if not robot.is_stopped and (is_due or held != self._told.get(name, "")):
                self._told[name] = held
                yield RobotSaid(name, (Outgoing(self._topic, "std_msgs/String", {"data": held}),))
