"""Wheel odometry with slip."""

from __future__ import annotations

import math
from typing import Optional, Sequence, Tuple

from rqt_mrta_py.hooks import Outgoing, SensorContext, SensorMoment
from rqt_mrta_py.model import Pose, wrap_angle
from rqt_mrta_py.sim.messages import header, pose_fields
from rqt_mrta_py.sim.sensors.settings import SensorSettings

__all__ = ["Odometry"]


class Odometry:
    """Publishes nav_msgs/Odometry: the robot's motion as its wheels count it, from zero in ``<robot>/odom``.

    Between two messages the robot moved ds along its heading and turned dth; the wheels count

        ds'  = ds (1 + distance_error b1)
        dth' = dth (1 + turn_error b2) + heading_error |ds| b3 + N(0, heading_walk sqrt(|ds|))

    and both are integrated, with b1, b2, b3 standard normal, drawn once per robot: its biases. Pushed sideways, wheels
    count nothing.

    The defaults are rows 1 (straight on: 0.33 cm/m, 2 deg/m) and 3 (rotation: 7 deg/turn) of a measured table of a
    mecanum base; row 2 is about driving sideways, which this drive cannot. Row 1 also tells 0.21 cm/m sideways, which
    a constant heading bias of 2 deg/m cannot give (3.5 cm/m over 2 m), so it is left out: this is what integrated dead
    reckoning looks like to a supervisor, not the table's end errors. ``heading_walk`` is ours.

    Parameters in a scenario, all at least 0:
        distance_error: 0.0033 [m/m].
        turn_error: 7/360 [rad/rad].
        heading_error: 2 degrees [rad/m].
        heading_walk: 0.005 [rad/sqrt(m)].
    """

    def __init__(self, context: SensorContext) -> None:
        settings = SensorSettings(context)
        distance_error = settings.number("distance_error", 0.0033)
        turn_error = settings.number("turn_error", 7.0 / 360.0)
        heading_error = settings.number("heading_error", math.radians(2.0))
        self._heading_walk = settings.number("heading_walk", 0.005)
        settings.finish()
        distance_bias, turn_bias, heading_bias = context.random.standard_normal(3).tolist()
        self._distance_factor = 1.0 + distance_error * distance_bias
        self._turn_factor = 1.0 + turn_error * turn_bias
        self._heading_per_metre = heading_error * heading_bias
        self._frame = f"{context.robot_id}/odom"
        self._child_frame = f"{context.robot_id}/base_link"
        self._topic = context.setup.topic
        self._random = context.random
        self._counted = Pose(0.0, 0.0, 0.0)
        self._truth = context.start
        self._time: Optional[float] = None

    @property
    def rays(self) -> None:
        """It wants none."""

    def sense(self, moment: SensorMoment) -> Sequence[Outgoing]:
        """Count what the wheels did since the last time."""
        distance, turn = self._count(moment.truth)
        elapsed = moment.now - self._time if self._time is not None else 0.0
        self._time = moment.now
        middle = self._counted.yaw + turn / 2
        self._counted = Pose(
            self._counted.x + distance * math.cos(middle),
            self._counted.y + distance * math.sin(middle),
            wrap_angle(self._counted.yaw + turn),
        )
        speed, turn_rate = (distance / elapsed, turn / elapsed) if elapsed > 0 else (0.0, 0.0)
        fields = {
            "header": header(moment.now, self._frame),
            "child_frame_id": self._child_frame,
            "pose": {"pose": pose_fields(self._counted)},
            "twist": {"twist": {"linear": {"x": speed}, "angular": {"z": turn_rate}}},
        }
        return (Outgoing(self._topic, "nav_msgs/Odometry", fields),)

    def _count(self, truth: Pose) -> Tuple[float, float]:
        """Give distance [m] and turn [rad] since the last truth, as the wheels count them."""
        before, self._truth = self._truth, truth
        turn = wrap_angle(truth.yaw - before.yaw)
        middle = before.yaw + turn / 2
        distance = (truth.x - before.x) * math.cos(middle) + (truth.y - before.y) * math.sin(middle)
        walk = float(self._random.standard_normal()) * self._heading_walk * math.sqrt(abs(distance))
        counted_turn = turn * self._turn_factor + self._heading_per_metre * abs(distance) + walk
        return distance * self._distance_factor, counted_turn
