"""A robot on mecanum wheels with a magnet on an arm.

It hangs on joints along x, along y and about the vertical, whose motors are as strong as its wheels hold on to the
floor: it stays upright, is stopped by what it runs into, and its rollers need not be simulated.
"""

from __future__ import annotations

import math
from typing import List, Tuple

from rqt_mrta_py.hooks import ArmModel, PlacedRobot
from rqt_mrta_py.model import Twist
from rqt_mrta_py.sim.bullet.engine import Engine
from rqt_mrta_py.sim.bullet.robot import Frame
from rqt_mrta_py.sim.bullet.robot_shape import RobotShape, shape_of_mecanum
from rqt_mrta_py.sim.mecanum import MecanumWheels, within_wheel_speed

__all__ = ["MecanumRobot"]

_X, _Y, _TURN, _BOOM, _MAGNET = range(5)
_JOINTS = (_X, _Y, _TURN, _BOOM, _MAGNET)
_CARRIAGE_MASS = 0.01
_BOOM_MASS_SHARE, _MAGNET_MASS_SHARE = 0.05, 0.03
_BOOM_HALF_WIDTH = 0.012
_PLATE_HALF_SIZE = (0.01, 0.02, 0.02)
_GRAVITY = 9.81
_TRACTION = 0.5
"""How strongly the wheels push at most, over the robot's weight."""
_ARM_TORQUE = 6.0
_WRIST_TORQUE = 3.0
_UNMOVABLE = 1e5
"""What holds a frozen robot [N, N m]."""
_LEVEL = (0.0, 0.0, 0.0, 1.0)
_NOTHING = -1

_Vector = Tuple[float, float, float]


class MecanumRobot:
    """One robot with a mecanum drive and an arm in one physics client; starts with its arm up.

    Attributes:
        body: PyBullet's number of the body.
        shape: what range finders see of it: its chassis.
    """

    parts = (_TURN, _BOOM, _MAGNET)
    hand = _MAGNET
    lifts = True

    def __init__(self, engine: Engine, robot: PlacedRobot, arm: ArmModel) -> None:
        model = robot.model
        self.shape: RobotShape = shape_of_mecanum(model)
        self.body = _build(engine, robot, arm, self.shape)
        self._engine = engine
        self._arm = arm
        self._wheels = MecanumWheels(model.wheel_radius, (model.wheelbase + model.track) / 2)
        self._most_wheel_speed = model.max_speed / model.wheel_radius
        push = _TRACTION * model.mass * _GRAVITY
        self._forces = (push, push, push * self._wheels.half_lengths, _ARM_TORQUE, _WRIST_TORQUE)
        self._twist = Twist()
        self._goal = arm.highest
        self._is_frozen = False

    @property
    def grip_force(self) -> float:
        """How strongly the magnet holds [N]."""
        return self._arm.max_force

    @property
    def arm(self) -> ArmModel:
        """What its arm is like."""
        return self._arm

    @property
    def goal(self) -> float:
        """The angle that joint 1 of the arm goes to or is at [rad]."""
        return self._goal

    def command(self, twist: Twist) -> None:
        """Set the velocity to be driven; remembered but not obeyed while frozen.

        Args:
            twist: in the robot's frame; slowed down where a wheel would turn faster than straight ahead at full speed.
        """
        self._twist = within_wheel_speed(self._wheels, twist, self._most_wheel_speed)

    def move_arm(self, angle: float) -> None:
        """Set where the arm shall go, at the rate of its model; beyond its ends, to the end.

        Args:
            angle: of joint 1 [rad].
        """
        self._goal = max(self._arm.lowest, min(self._arm.highest, angle))

    def freeze(self) -> None:
        """Hold base and arm where they are."""
        self._is_frozen = True

    def release(self) -> None:
        """Let the robot move again, by its newest commands."""
        self._is_frozen = False

    def prepare(self, step: float) -> None:
        """Set the motors for one physics step.

        Args:
            step: its length [s].
        """
        bullet, client = self._engine.bullet, self._engine.client
        speeds = (0.0,) * len(_JOINTS) if self._is_frozen else self._speeds(step)
        bullet.setJointMotorControlArray(
            self.body,
            _JOINTS,
            bullet.VELOCITY_CONTROL,
            targetVelocities=speeds,
            forces=(_UNMOVABLE,) * len(_JOINTS) if self._is_frozen else self._forces,
            physicsClientId=client,
        )

    def frame(self) -> Frame:
        """Give where the chassis is."""
        x, y, yaw, _, _ = self._joints()
        return (x, y, self.shape.frame_height), (0.0, 0.0, math.sin(yaw / 2), math.cos(yaw / 2))

    def hand_frame(self) -> Frame:
        """Give where the magnet's centre of mass is."""
        state = self._engine.bullet.getLinkState(
            self.body, _MAGNET, computeForwardKinematics=1, physicsClientId=self._engine.client
        )
        return state[0], state[1]

    def arm_angle(self) -> float:
        """Give the angle of joint 1 [rad]."""
        return self._joints()[_BOOM]

    def _speeds(self, step: float) -> Tuple[float, ...]:
        """Give what all joints shall turn or slide by until the next step."""
        _, _, yaw, boom, wrist = self._joints()
        twist = self._twist
        cos, sin = math.cos(yaw), math.sin(yaw)
        rate = max(-self._arm.rate, min(self._arm.rate, (self._goal - boom) / step))
        # The wrist turns back what the boom will have turned.
        level = (-(boom + rate * step) - wrist) / step
        return cos * twist.vx - sin * twist.vy, sin * twist.vx + cos * twist.vy, twist.wz, rate, level

    def _joints(self) -> List[float]:
        states = self._engine.bullet.getJointStates(self.body, _JOINTS, physicsClientId=self._engine.client)
        return [state[0] for state in states]


def _build(engine: Engine, robot: PlacedRobot, arm: ArmModel, shape: RobotShape) -> int:
    """Build carriages along x and y without extent, chassis, boom and magnet, each a link of the one before."""
    bullet, client, mass = engine.bullet, engine.client, robot.model.mass
    chassis = bullet.createCollisionShape(bullet.GEOM_BOX, halfExtents=shape.box_half_size, physicsClientId=client)
    half_boom = (arm.length / 2, 0.0, 0.0)
    boom = _box(engine, (arm.length / 2, _BOOM_HALF_WIDTH, _BOOM_HALF_WIDTH), half_boom)
    to_plate = (arm.magnet_ahead - _PLATE_HALF_SIZE[0], 0.0, -arm.magnet_below)
    plate = _box(engine, _PLATE_HALF_SIZE, to_plate)
    here = (0.0, 0.0, 0.0)
    boom_mass, magnet_mass = mass * _BOOM_MASS_SHARE, mass * _MAGNET_MASS_SHARE
    body: int = bullet.createMultiBody(
        baseMass=0.0,
        basePosition=here,
        linkMasses=(_CARRIAGE_MASS, _CARRIAGE_MASS, mass - boom_mass - magnet_mass, boom_mass, magnet_mass),
        linkCollisionShapeIndices=(_NOTHING, _NOTHING, chassis, boom, plate),
        linkVisualShapeIndices=(_NOTHING,) * 5,
        linkPositions=(
            here,
            here,
            (0.0, 0.0, shape.frame_height),
            (arm.joint_ahead, 0.0, arm.joint_height - shape.frame_height),
            (arm.length, 0.0, 0.0),
        ),
        linkOrientations=(_LEVEL,) * 5,
        linkInertialFramePositions=(here, here, here, half_boom, to_plate),
        linkInertialFrameOrientations=(_LEVEL,) * 5,
        # PyBullet counts parents from 1; 0 is the base.
        linkParentIndices=(0, 1, 2, 3, 4),
        linkJointTypes=(bullet.JOINT_PRISMATIC,) * 2 + (bullet.JOINT_REVOLUTE,) * 3,
        # A boom that goes up turns about the axis to the right.
        linkJointAxis=((1.0, 0.0, 0.0), (0.0, 1.0, 0.0), (0.0, 0.0, 1.0), (0.0, -1.0, 0.0), (0.0, -1.0, 0.0)),
        physicsClientId=client,
    )
    start = robot.start
    for joint, place in zip(_JOINTS, (start.x, start.y, start.yaw, arm.highest, -arm.highest)):
        bullet.resetJointState(body, joint, place, physicsClientId=client)
        # Links slow down by themselves otherwise.
        bullet.changeDynamics(
            body, joint, linearDamping=0.0, angularDamping=0.0, jointDamping=0.0, physicsClientId=client
        )
    return body


def _box(engine: Engine, half_size: _Vector, centre: _Vector) -> int:
    shape: int = engine.bullet.createCollisionShape(
        engine.bullet.GEOM_BOX, halfExtents=half_size, collisionFramePosition=centre, physicsClientId=engine.client
    )
    return shape
