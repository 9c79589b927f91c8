"""Wheel odometry with slip."""

from __future__ import annotations

import math
from typing import Dict, Optional, Sequence, Tuple

import numpy as np
from numpy.typing import NDArray

from rqt_mrta_py.hooks import Column, SensorContext, TeamMoment, TeamOutgoing
from rqt_mrta_py.sim.angles import wrap_angles
from rqt_mrta_py.sim.picking import picked
from rqt_mrta_py.sim.sensors.ahead import Ahead
from rqt_mrta_py.sim.sensors.settings import SensorSettings

__all__ = ["Odometry"]

_Floats = NDArray[np.float64]

_SLIDING = ("mecanum", "omni")
"""Drives whose wheels count motion sideways."""

_SIDEWAYS = (
    ("sideways_drift", 0.0028),
    ("turn_drift", 0.0003 / (2.0 * math.pi)),
    ("sideways_error", 0.0032),
    ("drift", 0.0021),
    ("sideways_heading_error", math.radians(4.0)),
)
"""Parameters of such drives in the order of their biases, with defaults."""


class Odometry:
    """Publishes nav_msgs/Odometry: the robot's motion as its wheels count it, from zero in ``<robot>/odom``.

    Between two messages the robot moved ds along its heading and turned dth; the wheels count

        ds'  = ds (1 + distance_error b1)
        dth' = dth (1 + turn_error b2) + heading_error |ds| b3 + N(0, heading_walk sqrt(|ds|))

    and both are integrated, with b1, b2, b3 standard normal, drawn once per robot: its biases. Pushed sideways, wheels
    count nothing.

    Mecanum wheels count motion dl to the left, too, with biases b4 to b8 besides:

        ds'  = ... + sideways_drift |dl| b4 + turn_drift |dth| b5
        dl'  = dl (1 + sideways_error b6) + drift |ds| b7
        dth' = ... + sideways_heading_error |dl| b8

    The defaults are those measured of a mecanum base: D. de O. Dantas, *Implementação de um Sistema Autônomo de
    Construção de Estrutura usando Aprendizado por Reforço*, Universidade Federal do Maranhão, 2017, Table 18: driving
    along x 0.33 cm/m in x, 0.21 cm/m in y, 2 deg/m; along y 0.28 cm/m in x, 0.32 cm/m in y, 4 deg/m; turning 0.03 cm in
    x and 7 deg per turn. Differs from the paper: it measured where 2 m ended, which a constant heading bias of 2 deg/m
    would put 3.5 cm/m aside; here its numbers are what each bit of the way adds, so ends are farther off.
    ``heading_walk`` is ours.

    Parameters in a scenario, all at least 0:
        distance_error: 0.0033 [m/m].
        turn_error: 7/360 [rad/rad].
        heading_error: 2 degrees [rad/m].
        heading_walk: 0.005 [rad/sqrt(m)].
        sideways_error: of a base that drives sideways, as all that follows; 0.0032 [m/m].
        sideways_drift: ahead or back, of driving sideways; 0.0028 [m/m].
        sideways_heading_error: 4 degrees [rad/m].
        drift: to a side, of driving ahead or back; 0.0021 [m/m].
        turn_drift: ahead or back, of turning; 0.0003 m a turn [m/rad].
    """

    def __init__(self, contexts: Sequence[SensorContext]) -> None:
        settings = SensorSettings(contexts)
        distance_error = settings.number("distance_error", 0.0033)
        turn_error = settings.number("turn_error", 7.0 / 360.0)
        heading_error = settings.number("heading_error", math.radians(2.0))
        self._heading_walk = settings.number("heading_walk", 0.005)
        sideways_errors = np.array([settings.number(name, default) for name, default in _SIDEWAYS])
        settings.finish()
        self._topic = contexts[0].setup.topic
        self._robots = tuple([context.robot_id for context in contexts])
        self._frames = tuple([f"{context.robot_id}/odom" for context in contexts])
        self._child_frames = tuple([f"{context.robot_id}/base_link" for context in contexts])
        draws = [context.random.standard_normal for context in contexts]
        distance_bias, turn_bias, heading_bias = np.array([draw(3) for draw in draws]).T
        slides = np.array([context.model.drive in _SLIDING for context in contexts])
        biases = np.array([draw(5) if can else np.zeros(5) for draw, can in zip(draws, slides.tolist())])
        self._slides: Optional[_Floats] = slides.astype(np.float64) if slides.any() else None
        self._normal = Ahead(draws, 1)
        with np.errstate(over="ignore"):
            self._distance_factor: _Floats = 1.0 + distance_error * distance_bias
            self._turn_factor: _Floats = 1.0 + turn_error * turn_bias
            self._heading_per_metre: _Floats = heading_error * heading_bias
            self._sideways: _Floats = (sideways_errors * biases).T
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
            distance, left, turn = self._count(members, moment.truth.T)
            x, y, yaw = self._counted[:, members]
            middle = yaw + turn / 2
            x = x + distance * np.cos(middle)
            y = y + distance * np.sin(middle)
            if left is not None:
                x = x - left * np.sin(middle)
                y = y + left * np.cos(middle)
            yaw = wrap_angles(yaw + turn)
            self._counted[:, members] = x, y, yaw
            elapsed = moment.now - self._times[members]
            self._times[members] = moment.now
            speed, turn_rate = np.divide((distance, turn), elapsed, out=np.zeros((2, elapsed.size)), where=elapsed > 0)
            turn_z, turn_w = np.sin(yaw / 2), np.cos(yaw / 2)
        columns: Dict[str, Column] = {
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
        if left is not None:
            columns["twist/twist/linear/y"] = np.divide(left, elapsed, out=np.zeros(elapsed.size), where=elapsed > 0)
        return (TeamOutgoing(self._topic, "nav_msgs/Odometry", picked(self._robots, members), columns),)

    def _count(self, members: NDArray[np.intp], truth: _Floats) -> Tuple[_Floats, Optional[_Floats], _Floats]:
        """Give distance ahead, to the left if anybody can [m], and turn [rad] since the last truth, as wheels count."""
        before = self._truth[:, members]
        self._truth[:, members] = truth
        turn = wrap_angles(truth[2] - before[2])
        middle = before[2] + turn / 2
        distance = (truth[0] - before[0]) * np.cos(middle) + (truth[1] - before[1]) * np.sin(middle)
        length = np.abs(distance)
        walk = self._normal.take(members)[:, 0] * self._heading_walk * np.sqrt(length)
        counted_turn = turn * self._turn_factor[members] + self._heading_per_metre[members] * length + walk
        counted = distance * self._distance_factor[members]
        if self._slides is None:
            return counted, None, counted_turn
        left = self._slides[members] * (
            (truth[1] - before[1]) * np.cos(middle) - (truth[0] - before[0]) * np.sin(middle)
        )
        drift_of_left, drift_of_turn, error_of_left, drift_of_length, turn_of_left = self._sideways[:, members]
        counted = counted + drift_of_left * np.abs(left) + drift_of_turn * np.abs(turn)
        counted_turn = counted_turn + turn_of_left * np.abs(left)
        return counted, left * (1.0 + error_of_left) + drift_of_length * length, counted_turn
