"""Where the range finder has met something of late, whatever the map says."""

from __future__ import annotations

from typing import Dict, Tuple

import numpy as np

from basic_behaviours.sight import Sight
from rqt_mrta_py.model import Pose

__all__ = ["REMEMBERED", "SeenThings"]

REMEMBERED = 60.0
"""How long something is remembered after it was seen last [s]."""

_SEEN_WITHIN = 2.0
_SEEN_RADIUS = 0.02
_SPOT = 0.1


class SeenThings:
    """Remembers one spot for each 0.1 m in which something was met within 2 m of the robot, for a minute."""

    def __init__(self) -> None:
        self._spots: Dict[Tuple[int, int], Tuple[Pose, float]] = {}

    def clear(self) -> None:
        """Forget everything."""
        self._spots.clear()

    def see(self, now: float, pose: Pose, sight: Sight) -> None:
        """Add what is seen now; forget what was seen long ago."""
        near = sight.ranges < _SEEN_WITHIN
        directions = sight.bearings[near] + pose.yaw
        xs = (pose.x + sight.ranges[near] * np.cos(directions)).tolist()
        ys = (pose.y + sight.ranges[near] * np.sin(directions)).tolist()
        self._spots = {spot: what for spot, what in self._spots.items() if now - what[1] < REMEMBERED}
        for x, y in zip(xs, ys):
            self._spots[round(x / _SPOT), round(y / _SPOT)] = (Pose(x, y), now)

    def discs(self, since: float) -> Tuple[Tuple[Pose, float], ...]:
        """Give what was seen since a time [s], as obstacles for a Navigator."""
        return tuple((place, _SEEN_RADIUS) for place, seen in self._spots.values() if seen >= since)
