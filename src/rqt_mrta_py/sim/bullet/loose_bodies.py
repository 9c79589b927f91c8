"""What is neither robot nor fixed: blocks to push and carry."""

from __future__ import annotations

import math
from typing import Collection, Dict, List, Mapping, NamedTuple, Optional, Tuple

import numpy as np
from numpy.typing import NDArray

from rqt_mrta_py.errors import SimError
from rqt_mrta_py.hooks import Body, BodyState
from rqt_mrta_py.sim.bullet.engine import Engine
from rqt_mrta_py.sim.bullet.robot import BulletRobot
from rqt_mrta_py.sim.bullet.surroundings import LOOSE_GROUP
from rqt_mrta_py.sim.world_checks import check_body

__all__ = ["LooseBodies"]

_BASE = -1
_EVERYTHING = -1
_STILL = (0.0, 0.0, 0.0)


class _Hold(NamedTuple):
    """A body's attachment: to whom, by which of PyBullet's constraints."""

    robot_id: str
    robot: BulletRobot
    constraint: int


class LooseBodies:
    """The loose bodies of one physics client, by id, in the order of their adding.

    Args:
        engine: the client.
    """

    def __init__(self, engine: Engine) -> None:
        self._engine = engine
        self._bodies: Dict[str, int] = {}
        self._half_sizes: Dict[str, Tuple[float, ...]] = {}
        self._frictions: Dict[str, float] = {}
        self._masses: Dict[int, float] = {}
        self._holds: Dict[str, _Hold] = {}

    def add(self, body: Body) -> int:
        """Build a body, whose id must not be taken.

        Returns:
            PyBullet's number of the body.

        Raises:
            SimError: its numbers make no body.
        """
        check_body(body)
        bullet, client = self._engine.bullet, self._engine.client
        half_extents = tuple(side / 2 for side in body.size)
        number: int = bullet.createMultiBody(
            body.mass,
            bullet.createCollisionShape(bullet.GEOM_BOX, halfExtents=half_extents, physicsClientId=client),
            basePosition=body.position,
            baseOrientation=(0.0, 0.0, math.sin(body.yaw / 2), math.cos(body.yaw / 2)),
            physicsClientId=client,
        )
        self._rub(number, body.friction)
        self._collide_with_all(number)
        self._bodies[body.id] = number
        self._masses[number] = body.mass
        self._frictions[body.id] = body.friction
        self._half_sizes[body.id] = half_extents
        return number

    def remove(self, body_id: str) -> int:
        """Take a body out of the world, off its carrier if it has one.

        Returns:
            PyBullet's number of the body that was.

        Raises:
            SimError: there is no such body.
        """
        number = self.number(body_id)
        if body_id in self._holds:
            self.detach(body_id)
        self._engine.bullet.removeBody(number, physicsClientId=self._engine.client)
        del self._bodies[body_id], self._half_sizes[body_id], self._frictions[body_id], self._masses[number]
        return number

    def attach(self, robot_id: str, robot: BulletRobot, body_id: str) -> None:
        """Fix a body to a robot's hand in their present relative pose; until detached, the two do not collide.

        Meanwhile it rubs on nothing, unless the robot lifts it: it is carried, and not dragged over the floor.

        Raises:
            SimError: there is no such body, or it is attached already.
        """
        number = self.number(body_id)
        if body_id in self._holds:
            holder = self._holds[body_id].robot_id
            raise SimError(f"body {body_id}: attached to {holder} already; detach it before {robot_id} takes it")
        bullet, client = self._engine.bullet, self._engine.client
        to_hand = bullet.invertTransform(*robot.hand_frame())
        at_body = bullet.getBasePositionAndOrientation(number, physicsClientId=client)
        position, orientation = bullet.multiplyTransforms(*to_hand, *at_body)
        constraint = bullet.createConstraint(
            robot.body,
            robot.hand,
            number,
            _BASE,
            bullet.JOINT_FIXED,
            (0.0, 0.0, 0.0),
            position,
            (0.0, 0.0, 0.0),
            parentFrameOrientation=orientation,
            physicsClientId=client,
        )
        if math.isfinite(robot.grip_force):
            bullet.changeConstraint(constraint, maxForce=robot.grip_force, physicsClientId=client)
        self._holds[body_id] = _Hold(robot_id, robot, constraint)
        self._collide(robot, number, enabled=False)
        if not robot.lifts:
            self._rub(number, 0.0)

    def detach(self, body_id: str) -> None:
        """Let go of a body.

        Raises:
            SimError: there is no such body, or nobody holds it.
        """
        number = self.number(body_id)
        hold = self._holds.pop(body_id, None)
        if hold is None:
            raise SimError(f"body {body_id}: not attached to any robot, so it cannot be detached")
        self._engine.bullet.removeConstraint(hold.constraint, physicsClientId=self._engine.client)
        self._collide(hold.robot, number, enabled=True)
        self._rub(number, self._frictions[body_id])

    def fix(self, number: int, *, fixed: bool) -> None:
        """Make a body stand as if it had no end of mass, or let it move again, from rest."""
        bullet, client = self._engine.bullet, self._engine.client
        # Two that sleep are not looked at: a third of the time.
        asleep = bullet.ACTIVATION_STATE_ENABLE_SLEEPING | bullet.ACTIVATION_STATE_SLEEP
        awake = bullet.ACTIVATION_STATE_DISABLE_SLEEPING | bullet.ACTIVATION_STATE_WAKE_UP
        bullet.changeDynamics(
            number,
            _BASE,
            mass=0.0 if fixed else self._masses[number],
            activationState=asleep if fixed else awake,
            physicsClientId=client,
        )
        bullet.resetBaseVelocity(number, _STILL, _STILL, physicsClientId=client)
        # PyBullet has put it among other fixed things, or those that move.
        self._collide_with_all(number)

    def held_by(self, robot: int) -> List[str]:
        """Give the ids of the bodies that are attached to a robot, by PyBullet's number of that."""
        return [body_id for body_id, hold in self._holds.items() if hold.robot.body == robot]

    @property
    def numbers(self) -> Collection[int]:
        """PyBullet's numbers of all bodies, in the order of their adding."""
        return self._bodies.values()

    @property
    def held(self) -> Mapping[int, int]:
        """PyBullet's numbers of bodies that are attached, each with that of its robot."""
        return {self._bodies[body_id]: hold.robot.body for body_id, hold in self._holds.items()}

    def states(self) -> Dict[str, BodyState]:
        """Give where every body is."""
        bullet, client = self._engine.bullet, self._engine.client
        return {
            body_id: BodyState(*bullet.getBasePositionAndOrientation(number, physicsClientId=client))
            for body_id, number in self._bodies.items()
        }

    def frames(self) -> NDArray[np.float64]:
        """Give position [m] and quaternion (x, y, z, w) of every body: shape (bodies, 7)."""
        frames = [(*state.position, *state.orientation) for state in self.states().values()]
        return np.array(frames, dtype=np.float64).reshape(-1, 7)

    def half_sizes(self) -> NDArray[np.float64]:
        """Give half of length, width and height of every body [m]: shape (bodies, 3)."""
        return np.array(list(self._half_sizes.values()), dtype=np.float64).reshape(-1, 3)

    def number(self, body_id: str) -> int:
        """Give PyBullet's number of a body.

        Raises:
            SimError: there is no such body.
        """
        number: Optional[int] = self._bodies.get(body_id)
        if number is None:
            raise SimError(f"body {body_id}: there is no such body; there are: {', '.join(self._bodies) or 'none'}")
        return number

    def _collide_with_all(self, number: int) -> None:
        self._engine.bullet.setCollisionFilterGroupMask(
            number, _BASE, LOOSE_GROUP, _EVERYTHING, physicsClientId=self._engine.client
        )

    def _rub(self, number: int, friction: float) -> None:
        bullet, client = self._engine.bullet, self._engine.client
        bullet.changeDynamics(number, _BASE, lateralFriction=friction, physicsClientId=client)

    def _collide(self, robot: BulletRobot, number: int, *, enabled: bool) -> None:
        for link in robot.parts:
            self._engine.bullet.setCollisionFilterPair(
                robot.body, number, link, _BASE, int(enabled), physicsClientId=self._engine.client
            )
