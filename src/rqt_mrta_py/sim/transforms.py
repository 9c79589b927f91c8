"""The transforms that a robot publishes: where it is by its odometry, and where its odometry is by its localiser."""

from __future__ import annotations

import math
from collections import abc
from typing import Any, Mapping, Optional, Sequence

from rqt_mrta_py.hooks import Outgoing
from rqt_mrta_py.model import Pose, wrap_angle
from rqt_mrta_py.sim.messages import as_transform, pose_fields, pose_of, transform_stamped

__all__ = ["TransformSource", "odometry_origin"]


class TransformSource:
    """Derives ``/tf`` of one robot from what its own sensors publish.

    Each nav_msgs/Odometry is followed by odom -> base_link, and by map -> odom once a localiser was heard; a
    geometry_msgs/PoseStamped is paired with the newest odometry.

    Args:
        robot_id: prefix of the frames ``<robot>/odom`` and ``<robot>/base_link``.
    """

    def __init__(self, robot_id: str) -> None:
        self._odom_frame = f"{robot_id}/odom"
        self._base_frame = f"{robot_id}/base_link"
        self._odometry: Optional[Mapping[str, Any]] = None
        self._origin: Optional[Mapping[str, Any]] = None

    def derive(self, now: float, measured: Sequence[Outgoing]) -> Sequence[Outgoing]:
        """Take in what sensors published at a time [s]; answer the transforms due with it, at most one message."""
        located: Optional[Mapping[str, Any]] = None
        counted: Optional[Mapping[str, Any]] = None
        for outgoing in measured:
            if outgoing.type == "nav_msgs/Odometry":
                counted = _inner(_inner(outgoing.fields, "pose"), "pose")
            elif outgoing.type == "geometry_msgs/PoseStamped":
                located = _inner(outgoing.fields, "pose")
        if counted is not None:
            self._odometry = counted
        if located is not None and self._odometry is not None:
            self._origin = as_transform(pose_fields(odometry_origin(pose_of(located), pose_of(self._odometry))))
        if counted is None:
            return ()
        transforms = [transform_stamped(now, self._odom_frame, self._base_frame, as_transform(counted))]
        if self._origin is not None:
            transforms.insert(0, transform_stamped(now, "map", self._odom_frame, self._origin))
        return (Outgoing("/tf", "tf2_msgs/TFMessage", {"transforms": transforms}),)


def _inner(fields: Any, name: str) -> Mapping[str, Any]:
    """Give a part of a message, whose fields nobody has checked yet; one left out has none."""
    inner = fields.get(name, {})
    # To be a Mapping is a question that takes long.
    return inner if inner.__class__ is dict or isinstance(inner, abc.Mapping) else {}


def odometry_origin(located: Pose, counted: Pose) -> Pose:
    """Place the frame ``odom`` in ``map`` such that a pose in the one and a pose in the other are the same place.

    Args:
        located: the robot in ``map``.
        counted: the robot in ``odom``.

    Returns:
        T(map, odom) = T(map, base) T(odom, base)^-1.
    """
    yaw = wrap_angle(located.yaw - counted.yaw)
    cos, sin = math.cos(yaw), math.sin(yaw)
    return Pose(
        located.x - (cos * counted.x - sin * counted.y),
        located.y - (sin * counted.x + cos * counted.y),
        yaw,
    )
