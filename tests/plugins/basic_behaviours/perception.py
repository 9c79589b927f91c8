"""A perception and scans made by hand, and a setup to make behaviours from."""

from __future__ import annotations

import math
from typing import Any, Dict, Mapping, Optional, Sequence

import numpy as np

from rqt_mrta_py.hooks import BehaviourSetup, Heard
from rqt_mrta_py.model import Arena, Obstacle, Pose
from rqt_mrta_py.robot import GridNavigator
from tests.plugins.basic_behaviours.kinematics import ARENA, MODEL, cast_rays

RAYS = -math.pi + np.arange(36) * (2 * math.pi / 36)


def make_setup(obstacles: Sequence[Obstacle] = (), arena: Arena = ARENA) -> BehaviourSetup:
    navigator = GridNavigator(arena, obstacles, radius=MODEL.radius)
    return BehaviourSetup("robot1", MODEL, navigator, np.random.default_rng(3))


class Perceived:
    """What a behaviour perceives, set by hand."""

    def __init__(self, pose: Optional[Pose] = None, now: float = 1.0) -> None:
        self.now = now
        self.pose = pose
        self._newest: Dict[str, Heard] = {}

    def newest(self, topic: str) -> Optional[Heard]:
        return self._newest.get(topic)

    def hear(self, topic: str, type_name: str, fields: Mapping[str, Any]) -> None:
        """Take in a message."""
        self._newest[topic] = Heard(f"/robot1/{topic}", type_name, self.now, fields)

    def hear_scan(self, ranges: Sequence[float], **fields: Any) -> None:
        """Take in a scan all around with these ranges [m]."""
        content = {
            "angle_min": -math.pi,
            "angle_increment": 2 * math.pi / len(ranges) if len(ranges) else 0.1,
            "range_min": 0.05,
            "range_max": 4.0,
            "ranges": list(ranges),
            **fields,
        }
        self.hear("scan", "sensor_msgs/LaserScan", content)

    def look_around(self, obstacles: Sequence[Obstacle] = (), arena: Arena = ARENA) -> None:
        """Take in the scan that belongs to the pose."""
        assert self.pose is not None
        ranges = cast_rays(arena, obstacles, (), (self.pose.x, self.pose.y), RAYS + self.pose.yaw)
        self.hear_scan(np.where(ranges > 4.0, np.inf, ranges).tolist())
