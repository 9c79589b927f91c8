"""A localiser: what AMCL, or cameras on the ceiling, would tell."""

from __future__ import annotations

from typing import Sequence

from rqt_mrta_py.hooks import Outgoing, SensorContext, SensorMoment
from rqt_mrta_py.model import Pose, wrap_angle
from rqt_mrta_py.sim.messages import header, pose_fields
from rqt_mrta_py.sim.sensors.settings import SensorSettings

__all__ = ["Localiser"]


class Localiser:
    """Publishes geometry_msgs/PoseStamped in the frame ``map``: the true pose with white noise.

    Parameters in a scenario, both at least 0:
        position_noise: standard deviation in x and in y; 0.01 [m].
        heading_noise: standard deviation of the heading; 0.01 [rad].
    """

    def __init__(self, context: SensorContext) -> None:
        settings = SensorSettings(context)
        self._position_noise = settings.number("position_noise", 0.01)
        self._heading_noise = settings.number("heading_noise", 0.01)
        settings.finish()
        self._topic = context.setup.topic
        self._random = context.random

    @property
    def rays(self) -> None:
        """It wants none."""

    def sense(self, moment: SensorMoment) -> Sequence[Outgoing]:
        """Locate once."""
        x, y, yaw = self._random.standard_normal(3).tolist()
        pose = Pose(
            moment.truth.x + self._position_noise * x,
            moment.truth.y + self._position_noise * y,
            wrap_angle(moment.truth.yaw + self._heading_noise * yaw),
        )
        fields = {"header": header(moment.now, "map"), "pose": pose_fields(pose)}
        return (Outgoing(self._topic, "geometry_msgs/PoseStamped", fields),)
