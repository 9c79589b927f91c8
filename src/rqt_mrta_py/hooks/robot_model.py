"""What a kind of robot is like: its size, how it drives, its actuators."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import FrozenSet, Optional, Tuple

from rqt_mrta_py.hooks.robot_arm import ArmModel

__all__ = ["GRIP_HALF_ANGLE", "RobotModel"]

GRIP_HALF_ANGLE = math.pi / 6
"""A gripper takes hold of what lies at most so far to either side of straight ahead [rad]."""

_MEASURES = (
    "length",
    "width",
    "height",
    "radius",
    "mass",
    "wheel_radius",
    "track",
    "max_speed",
    "max_turn_rate",
    "sensor_height",
)


@dataclass(frozen=True)
class RobotModel:
    """A kind of robot that worlds know how to build.

    Attributes:
        name: under which it is registered.
        drive: for instance ``differential`` or ``omni``; a world lists the drives that it can build among its
            capabilities as ``drive:<name>``.
        length, width, height: of the body [m].
        radius: of the circle around the robot as seen from above [m].
        mass: [kg].
        wheel_radius: [m].
        track: distance between left and right wheel [m].
        max_speed: [m/s].
        max_turn_rate: [rad/s].
        sensor_height: of the range finder's plane above the floor [m].
        actuators: what takes commands; ``base`` takes a Twist, ``gripper`` a number: above 0.5 it takes hold of the
            nearest body that it can take, else it lets go; ``arm`` takes the angle that its joint shall reach [rad];
            ``magnet`` a number: above 0.5 it holds the body whose strip is at its face, else it holds none.
        capabilities: what it can do.
        reach: of the gripper: the centre of what it takes lies at most so far outside the circle around the robot, and
            within ``GRIP_HALF_ANGLE`` of straight ahead [m].
        max_load: of the gripper or magnet: what is heavier it cannot take [kg].
        wheelbase: distance between front and rear axle; 0 where there is one axle [m].
        arm: that moves its magnet; None if it has none.

    Raises:
        ValueError: a measure is no finite number above 0; reach, load or wheelbase is not finite or negative; or it
            has an arm without the actuators ``arm`` and ``magnet``, or one of them without an arm; names it.
    """

    name: str
    drive: str
    length: float
    width: float
    height: float
    radius: float
    mass: float
    wheel_radius: float
    track: float
    max_speed: float
    max_turn_rate: float
    sensor_height: float
    actuators: Tuple[str, ...] = ("base",)
    capabilities: FrozenSet[str] = frozenset()
    reach: float = 0.0
    max_load: float = 0.0
    wheelbase: float = 0.0
    arm: Optional[ArmModel] = None

    def __post_init__(self) -> None:
        for measure in _MEASURES:
            value: object = getattr(self, measure)
            if not (isinstance(value, (int, float)) and math.isfinite(value) and value > 0.0):
                raise ValueError(f"robot model {self.name}: {measure} must be a finite number above 0 (got {value!r})")
        for measure in ("reach", "max_load", "wheelbase"):
            value = getattr(self, measure)
            if not (isinstance(value, (int, float)) and math.isfinite(value) and value >= 0.0):
                raise ValueError(f"robot model {self.name}: {measure} must be finite and not negative (got {value!r})")
        for actuator in ("arm", "magnet"):
            if (actuator in self.actuators) != (self.arm is not None):
                raise ValueError(
                    f"robot model {self.name}: actuators arm and magnet go with an arm, and an arm with both "
                    f"(got {self.actuators!r} and arm {self.arm!r})"
                )
