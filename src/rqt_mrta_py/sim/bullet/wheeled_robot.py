"""A robot on two driven wheels and two casters, as quick to simulate as it can be without driving wrongly."""

from __future__ import annotations

import math
from typing import Optional, Tuple

from rqt_mrta_py.hooks import PlacedRobot
from rqt_mrta_py.model import Twist
from rqt_mrta_py.sim.bullet.engine import Engine
from rqt_mrta_py.sim.bullet.robot import Frame
from rqt_mrta_py.sim.bullet.robot_shape import RobotShape, shape_of

__all__ = ["WheeledRobot"]

_WHEEL_MASS_SHARE = 0.3 / 5.6
_WHEEL_INERTIA_SHARE = 0.5
"""A wheel's moment of inertia about its axle, over the robot's mass and the wheel's radius squared: motor and gear turn
with it. With the bare wheel's the solver would not converge: robots told to stand still crept by 6 mm/s, and turning
on the spot one wheel was 4 % slow, the other 9 % fast."""
_MOTOR_TORQUE = 1.0
_LEFT, _RIGHT = 0, 1
_BASE = -1


class WheeledRobot:
    """One robot with differential drive in one physics client.

    Attributes:
        body: PyBullet's number of the body.
        model: what it is like.
        shape: what it looks like.
    """

    parts: Tuple[int, ...] = (_BASE, _LEFT, _RIGHT)
    hand = _BASE
    lifts = False
    grip_force = math.inf

    def __init__(self, engine: Engine, robot: PlacedRobot) -> None:
        self.model = robot.model
        self.shape = shape_of(robot.model)
        self.body = _build(engine, robot, self.shape)
        self._engine = engine
        self._twist = Twist()
        self._anchor: Optional[int] = None
        self._may_rest = False
        self._drive(self._twist)

    @property
    def is_frozen(self) -> bool:
        """Tell whether the robot is held in its place."""
        return self._anchor is not None

    def command(self, twist: Twist) -> None:
        """Set the velocity to be driven; remembered but not obeyed while frozen.

        Args:
            twist: in the robot's frame; the part to the left is beyond a differential drive and left out.
        """
        if twist == self._twist:
            return
        self._twist = twist
        if not self.is_frozen:
            self._drive(twist)

    def freeze(self) -> None:
        """Block the wheels and hold the body where it is, for wheels alone would slip under a push."""
        if self.is_frozen:
            return
        bullet, client = self._engine.bullet, self._engine.client
        self._drive(Twist())
        position, orientation = bullet.getBasePositionAndOrientation(self.body, physicsClientId=client)
        self._anchor = bullet.createConstraint(
            self.body,
            _BASE,
            -1,
            -1,
            bullet.JOINT_FIXED,
            (0.0, 0.0, 0.0),
            (0.0, 0.0, 0.0),
            position,
            childFrameOrientation=orientation,
            physicsClientId=client,
        )

    def release(self) -> None:
        """Let the robot drive again, by its newest command."""
        if self._anchor is not None:
            self._engine.bullet.removeConstraint(self._anchor, physicsClientId=self._engine.client)
            self._anchor = None
            self._drive(self._twist)

    def frame(self) -> Frame:
        """Give where its body is."""
        frame: Frame = self._engine.bullet.getBasePositionAndOrientation(self.body, self._engine.client)
        return frame

    def hand_frame(self) -> Frame:
        """Give where its body is, which bodies are attached to."""
        return self.frame()

    def _drive(self, twist: Twist) -> None:
        """Turn the wheels: v_left,right = v -+ w track / 2, over the wheels' radius."""
        self._let_rest(twist.vx == 0.0 and twist.wz == 0.0)
        across = twist.wz * self.model.track / 2
        radius = self.model.wheel_radius
        bullet = self._engine.bullet
        bullet.setJointMotorControlArray(
            self.body,
            (_LEFT, _RIGHT),
            bullet.VELOCITY_CONTROL,
            targetVelocities=((twist.vx - across) / radius, (twist.vx + across) / radius),
            forces=(_MOTOR_TORQUE, _MOTOR_TORQUE),
            physicsClientId=self._engine.client,
        )

    def _let_rest(self, rest: bool) -> None:
        """Spare the engine a robot that stands; it wakes when something moves it, and must not rest while it drives."""
        if rest == self._may_rest:
            return
        self._may_rest = rest
        bullet = self._engine.bullet
        driving = bullet.ACTIVATION_STATE_DISABLE_SLEEPING | bullet.ACTIVATION_STATE_WAKE_UP
        state = bullet.ACTIVATION_STATE_ENABLE_SLEEPING if rest else driving
        bullet.changeDynamics(self.body, _BASE, activationState=state, physicsClientId=self._engine.client)


def _build(engine: Engine, robot: PlacedRobot, shape: RobotShape) -> int:
    """Build the body with its frame at the centre of mass, the wheels on the floor."""
    bullet, client, model = engine.bullet, engine.client, robot.model
    wheel_mass = model.mass * _WHEEL_MASS_SHARE
    wheel = bullet.createCollisionShape(bullet.GEOM_SPHERE, radius=model.wheel_radius, physicsClientId=client)
    level = (0.0, 0.0, 0.0, 1.0)
    body: int = bullet.createMultiBody(
        baseMass=model.mass - 2 * wheel_mass,
        baseCollisionShapeIndex=_body_shape(engine, shape),
        basePosition=(robot.start.x, robot.start.y, shape.frame_height),
        baseOrientation=(0.0, 0.0, math.sin(robot.start.yaw / 2), math.cos(robot.start.yaw / 2)),
        linkMasses=(wheel_mass, wheel_mass),
        linkCollisionShapeIndices=(wheel, wheel),
        linkVisualShapeIndices=(-1, -1),
        linkPositions=tuple(wheel.centre for wheel in shape.wheels),
        linkOrientations=(level, level),
        linkInertialFramePositions=((0.0, 0.0, 0.0), (0.0, 0.0, 0.0)),
        linkInertialFrameOrientations=(level, level),
        linkParentIndices=(0, 0),
        linkJointTypes=(bullet.JOINT_REVOLUTE, bullet.JOINT_REVOLUTE),
        linkJointAxis=((0.0, 1.0, 0.0), (0.0, 1.0, 0.0)),
        physicsClientId=client,
    )
    bullet.changeDynamics(body, _BASE, lateralFriction=0.0, physicsClientId=client)
    across = 0.4 * wheel_mass * model.wheel_radius**2
    along = _WHEEL_INERTIA_SHARE * model.mass * model.wheel_radius**2
    for link in (_LEFT, _RIGHT):
        bullet.changeDynamics(
            body, link, lateralFriction=1.0, localInertiaDiagonal=(across, along, across), physicsClientId=client
        )
    return body


def _body_shape(engine: Engine, shape: RobotShape) -> int:
    """Join the box and the casters in front and behind into one shape."""
    bullet = engine.bullet
    front, rear = shape.casters
    level = [0.0, 0.0, 0.0, 1.0]
    # Lists throughout: this call crashes on tuples.
    joined: int = bullet.createCollisionShapeArray(
        shapeTypes=[bullet.GEOM_BOX, bullet.GEOM_SPHERE, bullet.GEOM_SPHERE],
        halfExtents=[list(shape.box_half_size), [0.0, 0.0, 0.0], [0.0, 0.0, 0.0]],
        radii=[0.0, front.radius, rear.radius],
        collisionFramePositions=[list(shape.box_centre), list(front.centre), list(rear.centre)],
        collisionFrameOrientations=[level, level, level],
        physicsClientId=engine.client,
    )
    return joined
