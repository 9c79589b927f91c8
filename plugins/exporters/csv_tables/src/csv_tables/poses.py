"""Where robots were: the poses that their localisers gave."""

from __future__ import annotations

import math
from array import array
from typing import Dict, Iterator, List, Tuple

from rqt_mrta_py.hooks import Heard, Subscription

__all__ = ["POSES", "PoseTrack"]

POSES = Subscription(
    "/@robot_id@/pose",
    "geometry_msgs/PoseStamped",
    (
        "pose/position/x",
        "pose/position/y",
        "pose/orientation/x",
        "pose/orientation/y",
        "pose/orientation/z",
        "pose/orientation/w",
    ),
)


class PoseTrack:
    """Keeps the poses of a mission, in the order of the stream; those that are not finite are left out."""

    def __init__(self) -> None:
        self._robots: Dict[str, int] = {}
        self._speakers = array("L")
        self._values = array("d")

    def hear(self, heard: Heard) -> None:
        """Take in one message of ``POSES``."""
        x, y, qx, qy, qz, qw = (heard.fields[path] for path in POSES.fields)
        yaw = math.atan2(2.0 * (qw * qz + qx * qy), 1.0 - 2.0 * (qy * qy + qz * qz))
        if math.isfinite(x) and math.isfinite(y) and math.isfinite(yaw):
            self._speakers.append(self._robots.setdefault(heard.robot, len(self._robots)))
            self._values.extend((heard.receipt, x, y, yaw))

    def __iter__(self) -> Iterator[Tuple[str, float, float, float, float]]:
        """Yield robot, time [s], x [m], y [m] and yaw [rad], in the frame ``map``."""
        names: List[str] = list(self._robots)
        rows = zip(*(self._values[column::4] for column in range(4)))
        for speaker, (time, x, y, yaw) in zip(self._speakers, rows):
            yield names[speaker], time, x, y, yaw
