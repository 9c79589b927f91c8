"""A localiser: what AMCL, or cameras on the ceiling, would tell."""

from __future__ import annotations

from typing import Sequence

import numpy as np

from rqt_mrta_py.hooks import SensorContext, TeamMoment, TeamOutgoing
from rqt_mrta_py.sim.angles import wrap_angles
from rqt_mrta_py.sim.picking import picked
from rqt_mrta_py.sim.sensors.ahead import Ahead
from rqt_mrta_py.sim.sensors.lasting import Lasting
from rqt_mrta_py.sim.sensors.settings import SensorSettings

__all__ = ["Localiser"]


class Localiser:
    """Publishes geometry_msgs/PoseStamped in the frame ``map``: the true pose with white noise.

    Each measurement is off by noise of its own: normal, and evenly distributed if that is asked for, both added up.
    What is evenly distributed may also last, as the error of a map or of a SLAM does, which no averaging removes.

    Parameters in a scenario, all at least 0:
        position_noise: standard deviation in x and in y; 0.01 [m].
        heading_noise: standard deviation of the heading; 0.01 [rad].
        uniform_noise: x and y are each off by a number evenly distributed within so much to either side; 0 [m].
        uniform_hold: these two are kept for so long, then drawn anew, at multiples of it on the robot's clock, however
            often it measures; 0, the default: drawn at each measurement [s].
    """

    def __init__(self, contexts: Sequence[SensorContext]) -> None:
        settings = SensorSettings(contexts)
        position_noise = settings.number("position_noise", 0.01)
        heading_noise = settings.number("heading_noise", 0.01)
        self._uniform_noise = settings.number("uniform_noise", 0.0)
        hold = settings.number("uniform_hold", 0.0)
        settings.finish()
        self._noise = np.array([position_noise, position_noise, heading_noise])
        self._topic = contexts[0].setup.topic
        self._robots = tuple([context.robot_id for context in contexts])
        self._normal = Ahead([context.random.standard_normal for context in contexts], 3)
        # Drawn only where it is asked for: other localisers' numbers stay the same.
        is_even = self._uniform_noise > 0.0
        self._even = Ahead([context.random.random for context in contexts], 2) if is_even and hold == 0.0 else None
        self._lasting = Lasting(contexts, hold) if is_even and hold > 0.0 else None

    @property
    def rays(self) -> None:
        """It wants none."""

    def sense(self, moment: TeamMoment) -> Sequence[TeamOutgoing]:
        """Locate once."""
        drawn = self._normal.take(moment.members)
        with np.errstate(over="ignore"):
            x, y, heading = (moment.truth + self._noise * drawn).T
            even = None
            if self._even is not None:
                even = self._even.take(moment.members)
            elif self._lasting is not None:
                even = self._lasting.take(moment.members, moment.now)
            if even is not None:
                off = self._uniform_noise * (2.0 * even - 1.0)
                x, y = x + off[:, 0], y + off[:, 1]
        yaw = wrap_angles(heading)
        columns = {
            "header/stamp": moment.now,
            "header/frame_id": "map",
            "pose/position/x": x,
            "pose/position/y": y,
            "pose/orientation/z": np.sin(yaw / 2),
            "pose/orientation/w": np.cos(yaw / 2),
        }
        robots = picked(self._robots, moment.members)
        return (TeamOutgoing(self._topic, "geometry_msgs/PoseStamped", robots, columns),)
