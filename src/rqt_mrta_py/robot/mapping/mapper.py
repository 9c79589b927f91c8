"""From scans and poses that a robot hears to its own map."""

from __future__ import annotations

import math
from typing import Callable, List, NamedTuple, Optional, Sequence, Tuple

import numpy as np

from rqt_mrta_py.hooks import Heard, Subscription
from rqt_mrta_py.model import Arena, Pose, wrap_angle
from rqt_mrta_py.robot.mapping.grid_map import GridMap

__all__ = ["Mapper"]

_POSE = Subscription(
    "pose",
    "geometry_msgs/PoseStamped",
    (
        "header/stamp",
        "pose/position/x",
        "pose/position/y",
        "pose/orientation/x",
        "pose/orientation/y",
        "pose/orientation/z",
        "pose/orientation/w",
    ),
)
_SCAN = Subscription(
    "scan",
    "sensor_msgs/LaserScan",
    ("header/stamp", "angle_min", "angle_increment", "range_min", "range_max", "ranges"),
)
_FARTHEST = 3.0
_LONGEST_GAP = 0.5
_PERIOD = 0.2
_TIME_SLACK = 1e-6
_MOST_WAITING = 10


class _Located(NamedTuple):
    stamp: float
    pose: Pose


class Mapper:
    """Puts each scan on the map from where the robot was when it was made.

    A scan waits until a pose as new as itself is known; between two poses at most half a second apart the robot is
    taken to have moved evenly. Scans that cannot be placed so are left out, those that come within 0.2 s of the one
    before, and what lies farther away than 3 m, where the noise of range and heading is wider than a cell.

    Args:
        arena: of which the robot knows the walls.
    """

    def __init__(self, arena: Arena) -> None:
        self.map = GridMap(arena)
        self._before: Optional[_Located] = None
        self._newest: Optional[_Located] = None
        self._waiting: List[Heard] = []
        self._looked = -math.inf
        self._rays: Tuple[Tuple[int, float, float], np.ndarray] = ((0, 0.0, 0.0), np.zeros(0))

    @property
    def now(self) -> float:
        """When the newest pose was measured, as its stamp says [s]; 0 before the first."""
        return self._newest.stamp if self._newest else 0.0

    def listeners(self) -> Sequence[Tuple[Subscription, Callable[[Heard], None]]]:
        """List what to hear, with whom to tell; relative names stand in the robot's namespace."""
        return ((_POSE, self._hear_pose), (_SCAN, self._hear_scan))

    def _hear_pose(self, heard: Heard) -> None:
        located = _located(heard)
        if located is None or (self._newest and located.stamp <= self._newest.stamp):
            return
        self._before, self._newest = self._newest, located
        waiting, self._waiting = self._waiting, []
        for scan in waiting:
            self._hear_scan(scan)

    def _hear_scan(self, heard: Heard) -> None:
        stamp = float(heard.fields["header/stamp"])
        if self._looked <= stamp < self._looked + _PERIOD - _TIME_SLACK:
            return
        if self._newest is None or stamp > self._newest.stamp:
            self._waiting = [*self._waiting[1 - _MOST_WAITING :], heard]
            return
        place = _between(self._before, self._newest, stamp)
        if place is not None:
            self._looked = stamp
            self._look(place, heard)

    def _look(self, place: Pose, heard: Heard) -> None:
        fields = heard.fields
        ranges = np.array(fields["ranges"], dtype=np.float64)
        key = (ranges.size, float(fields["angle_min"]), float(fields["angle_increment"]))
        least, most = float(fields["range_min"]), float(fields["range_max"])
        if not all(map(math.isfinite, (*key, least, most))):
            return
        if self._rays[0] != key:
            self._rays = (key, key[1] + key[2] * np.arange(ranges.size, dtype=np.float64))
        # REP-117: +inf is that nothing was met, -inf that it was too near to be measured; other values say nothing.
        told = ((ranges >= least) & (ranges <= most)) | np.isposinf(ranges)
        self.map.look(place, self._rays[1][told], ranges[told], min(most, _FARTHEST))


def _located(heard: Heard) -> Optional[_Located]:
    """Read a pose; None if it is not finite."""
    stamp, x, y, qx, qy, qz, qw = (float(heard.fields[field]) for field in _POSE.fields)
    if not all(map(math.isfinite, (stamp, x, y, qx, qy, qz, qw))):
        return None
    yaw = math.atan2(2.0 * (qw * qz + qx * qy), 1.0 - 2.0 * (qy * qy + qz * qz))
    return _Located(stamp, Pose(x, y, yaw))


def _between(before: Optional[_Located], after: _Located, stamp: float) -> Optional[Pose]:
    """Give where the robot was at a time up to that of the later pose; None if that cannot be told."""
    if stamp == after.stamp:
        return after.pose
    if before is None or stamp < before.stamp or after.stamp - before.stamp > _LONGEST_GAP:
        return None
    share = (stamp - before.stamp) / (after.stamp - before.stamp)
    turn = wrap_angle(after.pose.yaw - before.pose.yaw)
    return Pose(
        before.pose.x + share * (after.pose.x - before.pose.x),
        before.pose.y + share * (after.pose.y - before.pose.y),
        wrap_angle(before.pose.yaw + share * turn),
    )
