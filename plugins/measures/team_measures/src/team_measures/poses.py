"""The poses that robots' localisers give on ``/<robot>/pose``, as measures hear them."""

from __future__ import annotations

from rqt_mrta_py.hooks import Subscription

__all__ = ["FRAME", "MAP_FRAMES", "POSES", "X", "Y"]

FRAME, X, Y = "header/frame_id", "pose/position/x", "pose/position/y"
POSES = Subscription("/@robot_id@/pose", "geometry_msgs/PoseStamped", (FRAME, X, Y))
MAP_FRAMES = frozenset({"map", "/map"})
"""Poses in any other frame drift and begin anywhere."""
