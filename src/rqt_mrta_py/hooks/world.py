"""Worlds: where simulated robots move and meet."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Callable, FrozenSet, Mapping, NamedTuple, Protocol, Sequence, Tuple, Union

from rqt_mrta_py.hooks.robot_model import RobotModel
from rqt_mrta_py.model import Arena, Obstacle, Pose, Twist

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

__all__ = ["ArmWorld", "Body", "BodyState", "Contact", "PlacedRobot", "World", "WorldFactory", "WorldSetup"]


@dataclass(frozen=True)
class PlacedRobot:
    """A robot to be built: its id, what it is like, where it starts in the frame ``map``."""

    id: str
    model: RobotModel
    start: Pose


@dataclass(frozen=True)
class WorldSetup:
    """What a world is built from.

    Attributes:
        arena: floor and walls.
        obstacles: fixed bodies.
        robots: in this order everywhere.
        tick: length of one step [s].
    """

    arena: Arena
    obstacles: Tuple[Obstacle, ...]
    robots: Tuple[PlacedRobot, ...]
    tick: float


@dataclass(frozen=True)
class Body:
    """A loose body: a block to carry, a target, rubbish.

    Attributes:
        id: unique among bodies, obstacles and robots.
        position: of its centre [m].
        yaw: [rad].
        size: length, width, height [m].
        mass: [kg].
        friction: coefficient.
    """

    id: str
    position: Tuple[float, float, float]
    yaw: float
    size: Tuple[float, float, float]
    mass: float
    friction: float = 0.5


class BodyState(NamedTuple):
    """Where a body is: centre [m] and orientation as a quaternion (x, y, z, w), in the frame ``map``."""

    position: Tuple[float, float, float]
    orientation: Tuple[float, float, float, float]


class Contact(NamedTuple):
    """Two things that touch; ``first`` < ``second``; the floor does not count, walls are ``wall``."""

    first: str
    second: str


class World(Protocol):
    """Where simulated robots move and meet; stepped by the mission's loop, one control tick at a time."""

    @property
    def capabilities(self) -> FrozenSet[str]:
        """What it can do.

        ``drive:<name>``, ``contacts``, ``ranges``, ``bodies``, ``attach``, ``freeze``, ``remove`` (of robots), ...
        """
        ...

    def reset(self, setup: WorldSetup) -> None:
        """Build everything anew; all earlier bodies are gone.

        Raises:
            SimError: something cannot be built; names it.
        """
        ...

    def add_body(self, body: Body) -> None:
        """Put a loose body into the world.

        Raises:
            SimError: the id is taken.
        """
        ...

    def remove_body(self, body_id: str) -> None:
        """Take a loose body out of the world.

        Raises:
            SimError: there is no such body.
        """
        ...

    def attach(self, robot: str, body_id: str) -> None:
        """Fix a loose body to a robot, in the relative pose that both have now."""
        ...

    def detach(self, body_id: str) -> None:
        """Let go of an attached body."""
        ...

    def freeze(self, robot: str, frozen: bool) -> None:
        """Make a robot stand still, braked, whatever it is commanded; or let it move again."""
        ...

    def remove_robot(self, robot: str) -> None:
        """Take a robot off the floor for good, with what it holds.

        From then on it touches nothing and nobody sees it, its pose stays as it was, and whatever it is commanded
        means nothing. Removing it again does nothing.

        Raises:
            SimError: no such robot.
        """
        ...

    def command(self, robot: str, actuator: str, value: Union[Twist, float]) -> None:
        """Set what an actuator shall do from the next step on, until the next command.

        Raises:
            SimError: no such robot or actuator, or a value that is not finite.
        """
        ...

    def step(self) -> None:
        """Let one tick pass."""
        ...

    def poses(self) -> NDArray[np.float64]:
        """Give x, y [m] and yaw [rad] of every robot in the frame ``map``: shape (robots, 3), in the setup's order."""
        ...

    def bodies(self) -> Mapping[str, BodyState]:
        """Give the state of every loose body by id, in the order of their adding."""
        ...

    def contacts(self) -> Tuple[Contact, ...]:
        """List what touches what after the last step: each pair once, sorted."""
        ...

    def ranges(self, robots: Sequence[str], bearings: NDArray[np.float64], max_range: float) -> NDArray[np.float64]:
        """Measure distances from the centres of robots, each in the plane of its range finder.

        Args:
            robots: their ids.
            bearings: directions relative to a robot's heading, the same for all [rad], shape (rays,).
            max_range: what lies farther is not seen [m].

        Returns:
            True distances to the nearest surface that is not the robot's own [m], shape (robots, rays); infinity
            where nothing is seen.
        """
        ...

    def close(self) -> None:
        """Free what the world holds; safe to call twice."""
        ...


class ArmWorld(World, Protocol):
    """A world that moves arms, of which it lists the capability ``arms``: the actuator ``arm`` takes their angles."""

    def arm_angles(self) -> Mapping[str, float]:
        """Give the angle of joint 1 of every robot that has an arm and is there [rad], by id, in the setup's order."""
        ...


WorldFactory = Callable[[], World]
