"""A planar range finder."""

from __future__ import annotations

import math
from typing import Dict, Sequence

import numpy as np
from numpy.typing import NDArray

from rqt_mrta_py.hooks import Column, RayPattern, SensorContext, TeamMoment, TeamOutgoing
from rqt_mrta_py.sim.picking import picked
from rqt_mrta_py.sim.sensing.rays import MOST_RAYS
from rqt_mrta_py.sim.sensors.ahead import Ahead
from rqt_mrta_py.sim.sensors.settings import SensorSettings

__all__ = ["RangeFinder"]

_FULL_TURN = 2 * math.pi


class RangeFinder:
    """Publishes sensor_msgs/LaserScan from the robot's centre, in ``<robot>/base_link``.

    A measured range is true range + N(0, noise + noise_per_metre * true range); every ray is lost with probability
    ``dropout``. As REP-117 says: nothing seen is +inf, too near to be measured is -inf.

    Parameters in a scenario:
        rays: how many, evenly spread, at most 3600; 36.
        fov: angle between first and last ray, centred on the heading; a full turn (2 pi, the default) has no last
            ray on top of the first [rad].
        min_range, max_range: what can be measured, up to 1e6; 0.05 and 4 [m].
        noise: standard deviation at no distance, up to 1000; 0.01 [m].
        noise_per_metre: what it grows by, up to 1000; 0.01 [m/m].
        dropout: 0.005.
    """

    def __init__(self, contexts: Sequence[SensorContext]) -> None:
        settings = SensorSettings(contexts)
        rays = settings.whole("rays", 36, most=MOST_RAYS)
        fov = settings.number("fov", _FULL_TURN, above=True, most=_FULL_TURN + 1e-4)
        self._min_range = settings.number("min_range", 0.05)
        self._max_range = settings.number("max_range", 4.0, above=True, most=1e6)
        if self._max_range <= self._min_range:
            settings.refuse("max_range", self._max_range, f"must be above min_range ({self._min_range:g})")
        self._noise = settings.number("noise", 0.01, most=1e3)
        self._noise_per_metre = settings.number("noise_per_metre", 0.01, most=1e3)
        self._dropout = settings.number("dropout", 0.005, most=1.0)
        settings.finish()
        self._robots = tuple([context.robot_id for context in contexts])
        self._frames = tuple([f"{context.robot_id}/base_link" for context in contexts])
        self._topic = contexts[0].setup.topic
        self._normal = Ahead([context.random.standard_normal for context in contexts], rays)
        self._uniform = Ahead([context.random.random for context in contexts], rays)
        self._bearings = _bearings(rays, fov)
        increment = float(self._bearings[1] - self._bearings[0]) if rays > 1 else 0.0
        self._constant = {
            "angle_min": float(self._bearings[0]),
            "angle_max": float(self._bearings[-1]),
            "angle_increment": increment,
            "scan_time": 1.0 / contexts[0].setup.rate,
            "range_min": self._min_range,
            "range_max": self._max_range,
        }

    @property
    def rays(self) -> RayPattern:
        """The rays it wants cast."""
        return RayPattern(self._bearings, self._max_range)

    def sense(self, moment: TeamMoment) -> Sequence[TeamOutgoing]:
        """Measure once; takes as many random numbers whatever is seen."""
        true = moment.ranges
        if true is None:
            raise ValueError("a range finder was handed no ranges")
        drawn, chance = self._normal.take(moment.members), self._uniform.take(moment.members)
        # Noise of a finite range, for infinity times a noise of nothing is no number. In place, for making arrays takes
        # longer than filling them.
        measured = np.minimum(true, self._max_range)
        measured *= self._noise_per_metre
        measured += self._noise
        measured *= drawn
        measured += true
        lost = chance < self._dropout
        lost |= measured > self._max_range
        np.putmask(measured, measured < self._min_range, -np.inf)
        np.putmask(measured, lost, np.inf)
        columns: Dict[str, Column] = {
            "header/stamp": moment.now,
            "header/frame_id": picked(self._frames, moment.members),
            **self._constant,
            "ranges": measured,
        }
        return (TeamOutgoing(self._topic, "sensor_msgs/LaserScan", picked(self._robots, moment.members), columns),)


def _bearings(rays: int, fov: float) -> NDArray[np.float64]:
    """Spread rays evenly, symmetric about the heading unless they go all around [rad]."""
    places = np.arange(rays, dtype=np.float64)
    if fov > _FULL_TURN - 1e-4:
        return -math.pi + places * (_FULL_TURN / rays)
    return (places - (rays - 1) / 2) * (fov / max(1, rays - 1))
