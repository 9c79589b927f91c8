"""Where robots are by their transforms, for those that tell no pose."""

from __future__ import annotations

import math
from typing import Any, Dict, List, Mapping, Optional, Sequence, Tuple

from rqt_mrta_py.model import Pose, normalise_id, wrap_angle

__all__ = ["FrameTree"]

_MAP = "map"
_BASES = ("base_link", "base_footprint")
# A tree that is deeper is none; a stream with more frames than these tells more than robots.
_DEEPEST = 16
_MOST_FRAMES = 20_000


class FrameTree:
    """Follows transforms, as far as they are planar, from ``map`` to every frame ``<robot>/base_link``.

    Args:
        sole_robot: whom a ``base_link`` without a robot's name belongs to; None for nobody.
    """

    def __init__(self, sole_robot: Optional[str] = None) -> None:
        self._sole_robot = sole_robot
        self._parents: Dict[str, Tuple[str, Pose]] = {}

    def take(self, transforms: Sequence[Mapping[str, Any]]) -> List[Tuple[str, Pose]]:
        """Take in the transforms of one message.

        Args:
            transforms: each a geometry_msgs/TransformStamped as nested builtins.

        Returns:
            Every robot whose base this message moved, with its pose in ``map``, if that is known.
        """
        bases: List[Tuple[str, str]] = []
        for each in transforms:
            child = normalise_id(each["child_frame_id"])
            pose = _planar(each["transform"])
            if pose is None or (len(self._parents) >= _MOST_FRAMES and child not in self._parents):
                continue
            self._parents[child] = (normalise_id(each["header"]["frame_id"]), pose)
            robot = self._robot_of(child)
            if robot is not None:
                bases.append((robot, child))
        placed = [(robot, self._in_map(frame)) for robot, frame in bases]
        return [(robot, pose) for robot, pose in placed if pose is not None]

    def _robot_of(self, frame: str) -> Optional[str]:
        robot, _, name = frame.rpartition("/")
        if name not in _BASES:
            return None
        return robot or self._sole_robot

    def _in_map(self, frame: str) -> Optional[Pose]:
        pose = Pose(0.0, 0.0, 0.0)
        for _ in range(_DEEPEST):
            if frame == _MAP:
                return pose
            if frame not in self._parents:
                return None
            frame, step = self._parents[frame]
            pose = _chained(step, pose)
        return None


def _chained(first: Pose, second: Pose) -> Pose:
    cos, sin = math.cos(first.yaw), math.sin(first.yaw)
    x = first.x + cos * second.x - sin * second.y
    y = first.y + sin * second.x + cos * second.y
    return Pose(x, y, wrap_angle(first.yaw + second.yaw))


def _planar(transform: Mapping[str, Any]) -> Optional[Pose]:
    moved, turned = transform["translation"], transform["rotation"]
    x, y = moved["x"], moved["y"]
    qx, qy, qz, qw = turned["x"], turned["y"], turned["z"], turned["w"]
    if not math.isfinite(x + y + qx + qy + qz + qw):
        return None
    return Pose(x, y, math.atan2(2.0 * (qw * qz + qx * qy), 1.0 - 2.0 * (qy * qy + qz * qz)))
