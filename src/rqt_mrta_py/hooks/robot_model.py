"""What a kind of robot is like: its size, how it drives, its actuators."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import FrozenSet, Tuple

__all__ = ["RobotModel"]

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
        actuators: what takes commands; ``base`` takes a Twist.
        capabilities: what it can do.

    Raises:
        ValueError: a measure is no finite number above 0; names it.
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

    def __post_init__(self) -> None:
        for measure in _MEASURES:
            value: object = getattr(self, measure)
            if not (isinstance(value, (int, float)) and math.isfinite(value) and value > 0.0):
                raise ValueError(f"robot model {self.name}: {measure} must be a finite number above 0 (got {value!r})")
