"""Wheel odometry with slip."""

from __future__ import annotations

import math
from typing import Sequence, Tuple

import numpy as np
from numpy.typing import NDArray

from rqt_mrta_py.hooks import SensorContext, TeamMoment, TeamOutgoing
from rqt_mrta_py.sim.angles import wrap_angles
from rqt_mrta_py.sim.picking import picked
from rqt_mrta_py.sim.sensors.ahead import Ahead
from rqt_mrta_py.sim.sensors.settings import SensorSettings

__all__ = ["Odometry"]

_Floats = NDArray[np.float64]


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

    def __init__(self, contexts: Sequence[SensorContext]) -> None:
        settings = SensorSettings(contexts)
        distance_error = settings.number("distance_error", 0.0033)
        turn_error = settings.number("turn_error", 7.0 / 360.0)
        heading_error = settings.number("heading_error", math.radians(2.0))
        self._heading_walk = settings.number("heading_walk", 0.005)
        settings.finish()
        self._topic = contexts[0].setup.topic
        self._robots = tuple([context.robot_id for context in contexts])
        self._frames = tuple([f"{context.robot_id}/odom" for context in contexts])
        self._child_frames = tuple([f"{context.robot_id}/base_link" for context in contexts])
        draws = [context.random.standard_normal for context in contexts]
        distance_bias, turn_bias, heading_bias = np.array([draw(3) for draw in draws]).T
        self._normal = Ahead(draws, 1)
        with np.errstate(over="ignore"):
            self._distance_factor: _Floats = 1.0 + distance_error * distance_bias
            self._turn_factor: _Floats = 1.0 + turn_error * turn_bias
            self._heading_per_metre: _Floats = heading_error * heading_bias
        self._counted: _Floats = np.zeros((3, len(contexts)))
        self._truth: _Floats = np.array([(one.start.x, one.start.y, one.start.yaw) for one in contexts]).T
        # Not yet known: no time at all has passed since what is no number.
        self._times: _Floats = np.full(len(contexts), np.nan)

    @property
    def rays(self) -> None:
        """It wants none."""

    def sense(self, moment: TeamMoment) -> Sequence[TeamOutgoing]:
        """Count what the wheels did since the last time."""
        members = moment.members
        with np.errstate(over="ignore", invalid="ignore"):
            distance, turn = self._count(members, moment.truth.T)
            x, y, yaw = self._counted[:, members]
            middle = yaw + turn / 2
            x = x + distance * np.cos(middle)
            y = y + distance * np.sin(middle)
            yaw = wrap_angles(yaw + turn)
            self._counted[:, members] = x, y, yaw
            elapsed = moment.now - self._times[members]
            self._times[members] = moment.now
            speed, turn_rate = np.divide((distance, turn), elapsed, out=np.zeros((2, elapsed.size)), where=elapsed > 0)
            turn_z, turn_w = np.sin(yaw / 2), np.cos(yaw / 2)
        columns = {
            "header/stamp": moment.now,
            "header/frame_id": picked(self._frames, members),
            "child_frame_id": picked(self._child_frames, members),
            "pose/pose/position/x": x,
            "pose/pose/position/y": y,
            "pose/pose/orientation/z": turn_z,
            "pose/pose/orientation/w": turn_w,
            "twist/twist/linear/x": speed,
            "twist/twist/angular/z": turn_rate,
        }
        return (TeamOutgoing(self._topic, "nav_msgs/Odometry", picked(self._robots, members), columns),)

    def _count(self, members: NDArray[np.intp], truth: _Floats) -> Tuple[_Floats, _Floats]:
        """Give distance [m] and turn [rad] since the last truth, as the wheels count them."""
        before = self._truth[:, members]
        self._truth[:, members] = truth
        turn = wrap_angles(truth[2] - before[2])
        middle = before[2] + turn / 2
        distance = (truth[0] - before[0]) * np.cos(middle) + (truth[1] - before[1]) * np.sin(middle)
        length = np.abs(distance)
        walk = self._normal.take(members)[:, 0] * self._heading_walk * np.sqrt(length)
        counted_turn = turn * self._turn_factor[members] + self._heading_per_metre[members] * length + walk
        return distance * self._distance_factor[members], counted_turn
