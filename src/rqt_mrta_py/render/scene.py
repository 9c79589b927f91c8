"""Follows the stream to know where everything is."""

from __future__ import annotations

import math
from typing import Any, Dict, Mapping, Optional, Sequence

from rqt_mrta_py.hooks import Heard, RobotModel, RobotSight, SceneView, Subscription
from rqt_mrta_py.model import Mission, Pose, normalise_id
from rqt_mrta_py.render.path import PathKeeper

__all__ = ["DEFAULT_RADIUS", "SceneTracker"]

DEFAULT_RADIUS = 0.2
"""Radius drawn for a robot of unknown model [m]."""

_FIELDS = (
    "header/frame_id",
    "pose/position/x",
    "pose/position/y",
    "pose/orientation/x",
    "pose/orientation/y",
    "pose/orientation/z",
    "pose/orientation/w",
)


class SceneTracker:
    """Knows the arena, and from the stream's poses where each robot is and was; a Listener.

    Robots of the mission come first, in its order, then any other that tells its pose, by first sight. Poses in
    another frame than ``map``, or not finite, are passed over.

    Args:
        mission: whose scenario, if any, tells arena, obstacles and the robots' models.
        models: kinds of robots by name, for their size.
        trail: how far back trails reach [s].
    """

    def __init__(self, mission: Mission, models: Mapping[str, RobotModel], trail: float = 60.0) -> None:
        scenario = mission.scenario
        self._arena = scenario.arena if scenario else None
        self._obstacles = scenario.obstacles if scenario else ()
        self._tasks = mission.tasks
        self._models = models
        self._model_of = {robot.id: robot.model for robot in scenario.robots} if scenario else {}
        self._trail = trail
        self._poses: Dict[str, Optional[Pose]] = {robot.id: None for robot in mission.application.robots}
        self._paths: Dict[str, PathKeeper] = {robot: PathKeeper(trail) for robot in self._poses}

    def subscriptions(self) -> Sequence[Subscription]:
        """Ask for every robot's pose."""
        return (Subscription("/@robot_id@/pose", "geometry_msgs/PoseStamped", _FIELDS),)

    def hear(self, heard: Heard) -> None:
        """Take in one pose.

        Args:
            heard: a message subscribed to.
        """
        pose = _pose(heard.fields)
        if pose is None:
            return
        robot = normalise_id(heard.robot)
        path = self._paths.get(robot)
        if path is None:
            path = self._paths[robot] = PathKeeper(self._trail)
        self._poses[robot] = pose
        path.add(heard.receipt, pose.x, pose.y)

    def view(self, now: float, whole: bool = False) -> SceneView:
        """Give the scene at a moment.

        Args:
            now: the moment, not before the newest message heard [s].
            whole: give whole paths, thinned, rather than the trails of the last seconds.
        """
        robots = tuple(
            RobotSight(robot, self._poses[robot], self._radius(robot), path.whole() if whole else path.recent(now))
            for robot, path in self._paths.items()
        )
        return SceneView(self._arena, self._obstacles, robots, self._tasks)

    def _radius(self, robot: str) -> float:
        model = self._models.get(self._model_of.get(robot, ""))
        return DEFAULT_RADIUS if model is None else model.radius


def _pose(fields: Mapping[str, Any]) -> Optional[Pose]:
    frame, x, y, qx, qy, qz, qw = (fields[name] for name in _FIELDS)
    if normalise_id(frame) != "map" or not math.isfinite(x + y + qx + qy + qz + qw):
        return None
    return Pose(x, y, math.atan2(2.0 * (qw * qz + qx * qy), 1.0 - 2.0 * (qy * qy + qz * qz)))
