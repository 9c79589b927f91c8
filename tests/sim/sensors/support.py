"""Builds sensors for tests, and what they measure from."""

from __future__ import annotations

import math
from typing import Any, Mapping, Optional, Sequence

import numpy as np

from rqt_mrta_py.hooks import RobotModel, SensorContext, TeamMoment
from rqt_mrta_py.model import Pose, SensorSetup
from rqt_mrta_py.sim.robot_models import DIFF_DRIVE
from tests.sim.doubles import StillWorld

START = Pose(0.0, 0.0, 0.0)


def context(
    kind: str,
    topic: str,
    *,
    random: Any = None,
    start: Pose = START,
    rate: float = 10.0,
    robot: str = "robot1",
    model: RobotModel = DIFF_DRIVE,
    **parameters: Any,
):
    """Describe one sensor of one robot."""
    generator = np.random.default_rng(7) if random is None else random
    return SensorContext(robot, model, SensorSetup(kind, topic, rate, parameters), start, generator)


def moment(
    now: float,
    truth: Sequence[Pose],
    ranges: Optional[np.ndarray] = None,
    members: Optional[Sequence[int]] = None,
) -> TeamMoment:
    """Give what robots measure from that all have the same time, by default all of them."""
    places = np.arange(len(truth)) if members is None else np.array(members)
    poses = np.array([(pose.x, pose.y, pose.yaw) for pose in truth]).reshape(-1, 3)
    return TeamMoment(places, np.full(len(places), now), poses, ranges, StillWorld())


def pose_in(columns: Mapping[str, Any], within: str = "pose", row: int = 0) -> Pose:
    """Read the geometry_msgs/Pose of one row."""
    x, y = (float(columns[f"{within}/position/{name}"][row]) for name in "xy")
    turn_z, turn_w = (float(columns[f"{within}/orientation/{name}"][row]) for name in "zw")
    return Pose(x, y, 2 * math.atan2(turn_z, turn_w))
