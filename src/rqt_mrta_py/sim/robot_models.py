"""The kinds of robots that this room brings."""

from __future__ import annotations

import math
from dataclasses import replace

from rqt_mrta_py.hooks import ArmModel, RobotModel

__all__ = ["CARRIER", "DIFF_DRIVE", "MECANUM_ARM", "OMNI_DRIVE", "SMALL_DIFF_DRIVE", "STRONG_CARRIER"]

DIFF_DRIVE = RobotModel(
    name="diff_drive",
    drive="differential",
    length=0.30,
    width=0.22,
    height=0.14,
    # Over the corners of the body; the wheels' outer sides lie 0.18 m from the centre.
    radius=0.19,
    mass=5.6,
    wheel_radius=0.05,
    track=0.26,
    max_speed=0.5,
    max_turn_rate=2.0,
    # Above the wheels, below the top: the plane in which robots see one another.
    sensor_height=0.12,
    capabilities=frozenset({"drive", "range"}),
)
"""A small robot on two driven wheels and two casters."""

SMALL_DIFF_DRIVE = RobotModel(
    name="small_diff_drive",
    drive="differential",
    length=0.14,
    width=0.10,
    # As tall as it is long, to be seen in the plane in which robots see one another.
    height=0.14,
    # Over the corners of the body; the wheels' outer sides lie 0.085 m from the centre.
    radius=0.09,
    mass=0.8,
    wheel_radius=0.025,
    track=0.12,
    max_speed=0.25,
    max_turn_rate=2.5,
    sensor_height=0.12,
    capabilities=frozenset({"drive", "range"}),
)
"""A table-top robot on two driven wheels and two casters."""

OMNI_DRIVE = RobotModel(
    name="omni_drive",
    drive="omni",
    length=0.30,
    width=0.30,
    height=0.14,
    # Over the corners; the wheels lie under the body.
    radius=0.22,
    mass=6.4,
    wheel_radius=0.05,
    track=0.24,
    max_speed=0.5,
    max_turn_rate=2.0,
    sensor_height=0.12,
    capabilities=frozenset({"drive", "range"}),
)
"""A small robot on four mecanum wheels, which drives in any direction without turning."""

CARRIER = replace(
    DIFF_DRIVE,
    name="carrier",
    actuators=("base", "gripper"),
    capabilities=frozenset({"carry", "drive", "range"}),
    reach=0.20,
    max_load=0.5,
)
"""A ``diff_drive`` with a gripper in front."""

STRONG_CARRIER = RobotModel(
    name="strong_carrier",
    drive="differential",
    length=0.42,
    width=0.32,
    height=0.16,
    # Over the corners of the body; the wheels' outer sides lie 0.24 m from the centre.
    radius=0.27,
    mass=14.0,
    wheel_radius=0.05,
    track=0.38,
    max_speed=0.3,
    max_turn_rate=1.2,
    sensor_height=0.12,
    actuators=("base", "gripper"),
    capabilities=frozenset({"carry", "carry:heavy", "drive", "range"}),
    reach=0.25,
    max_load=4.0,
)
"""A larger and slower robot with a gripper, for loads that a ``carrier`` cannot take."""

MECANUM_ARM = RobotModel(
    name="mecanum_arm",
    drive="mecanum",
    length=0.28,
    width=0.22,
    height=0.14,
    # Over the corners of the body; with its arm up, the magnet's face is as far ahead.
    radius=0.18,
    mass=6.0,
    wheel_radius=0.04,
    track=0.18,
    max_speed=0.2,
    max_turn_rate=1.0,
    sensor_height=0.12,
    actuators=("base", "arm", "magnet"),
    capabilities=frozenset({"carry", "drive", "magnet", "range"}),
    max_load=0.5,
    wheelbase=0.20,
    # Dantas (2017) gives no measures: these reach the middles of blocks of 7 cm on five levels.
    arm=ArmModel(
        length=0.22,
        joint_ahead=0.12,
        magnet_ahead=0.06,
        joint_height=0.20,
        magnet_below=0.05,
        lowest=-math.radians(35.0),
        highest=math.pi / 2.0,
        rate=0.5,
    ),
)
"""A builder on four mecanum wheels, with an electromagnet on an arm that lifts."""
