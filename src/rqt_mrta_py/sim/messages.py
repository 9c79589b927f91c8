"""Fields of standard messages, as the codec takes them."""

from __future__ import annotations

import math
from typing import Any, Dict, Mapping

from rqt_mrta_py.model import Pose

__all__ = ["as_transform", "header", "pose_fields", "pose_of", "quaternion", "transform_stamped"]

_ZEROS: Mapping[str, float] = {}


def header(now: float, frame: str) -> Dict[str, Any]:
    """Give a std_msgs/Header.

    Args:
        now: its stamp [s].
        frame: its frame_id.
    """
    return {"stamp": now, "frame_id": frame}


def quaternion(yaw: float) -> Dict[str, float]:
    """Give a geometry_msgs/Quaternion that turns by ``yaw`` [rad] about the vertical."""
    return {"z": math.sin(yaw / 2), "w": math.cos(yaw / 2)}


def pose_fields(pose: Pose) -> Dict[str, Any]:
    """Give a geometry_msgs/Pose on the floor."""
    return {"position": {"x": pose.x, "y": pose.y}, "orientation": quaternion(pose.yaw)}


def pose_of(fields: Mapping[str, Any]) -> Pose:
    """Read a geometry_msgs/Pose on the floor; fields left out are zero."""
    position, orientation = fields.get("position", _ZEROS), fields.get("orientation", _ZEROS)
    yaw = 2 * math.atan2(orientation.get("z", 0.0), orientation.get("w", 0.0))
    return Pose(position.get("x", 0.0), position.get("y", 0.0), yaw)


def as_transform(pose: Mapping[str, Any]) -> Dict[str, Any]:
    """Give the geometry_msgs/Transform to where a geometry_msgs/Pose is."""
    return {"translation": pose.get("position", _ZEROS), "rotation": pose.get("orientation", _ZEROS)}


def transform_stamped(now: float, parent: str, child: str, transform: Mapping[str, Any]) -> Dict[str, Any]:
    """Give a geometry_msgs/TransformStamped: where ``child`` stands in ``parent``, as a geometry_msgs/Transform."""
    return {"header": {"stamp": now, "frame_id": parent}, "child_frame_id": child, "transform": transform}
