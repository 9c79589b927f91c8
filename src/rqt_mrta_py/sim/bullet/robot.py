"""What every robot of BulletWorld is to the world around it, however it drives."""

from __future__ import annotations

from typing import Protocol, Tuple

from rqt_mrta_py.model import Twist
from rqt_mrta_py.sim.bullet.robot_shape import RobotShape

__all__ = ["BulletRobot", "Frame"]

Frame = Tuple[Tuple[float, float, float], Tuple[float, float, float, float]]
"""A position [m] and a quaternion (x, y, z, w) in the frame ``map``."""


class BulletRobot(Protocol):
    """One robot in one physics client."""

    @property
    def body(self) -> int:
        """PyBullet's number of the body."""
        ...

    @property
    def parts(self) -> Tuple[int, ...]:
        """Links of the body that touch things; -1 is its base."""
        ...

    @property
    def hand(self) -> int:
        """The link that bodies are attached to."""
        ...

    @property
    def lifts(self) -> bool:
        """Whether it lifts what it holds; else it would drag that over the floor."""
        ...

    @property
    def grip_force(self) -> float:
        """How strongly it holds what is attached to it [N]; infinite for what cannot be torn off."""
        ...

    @property
    def shape(self) -> RobotShape:
        """What range finders see of it."""
        ...

    def command(self, twist: Twist) -> None:
        """Set the velocity to be driven, in the robot's frame; remembered but not obeyed while frozen."""
        ...

    def freeze(self) -> None:
        """Hold the robot where it is."""
        ...

    def release(self) -> None:
        """Let the robot move again, by its newest command."""
        ...

    def frame(self) -> Frame:
        """Give where the robot is: the origin of its shape."""
        ...

    def hand_frame(self) -> Frame:
        """Give where the centre of mass of its hand is."""
        ...
