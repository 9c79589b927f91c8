"""Readers of a robot's own sensors, by the names that ``sensors/sensor<i>/plugin_name`` gives."""

from __future__ import annotations

import math
from typing import Optional

from mrta_alliance.equations import TIME_TOLERANCE
from rqt_mrta_py.hooks import Heard, RobotSensorSetup, SensorReading, Subscription

__all__ = ["AnyMessage", "Scan"]


class AnyMessage:
    """A sensor that is up to date while it speaks, whatever it says (``mrta_alliance/any_message``).

    Implements RobotSensor. Its newest message is kept for the horizon, and not less than the timeout.
    """

    def __init__(self, setup: RobotSensorSetup) -> None:
        """Start without a message.

        Args:
            setup: see there.
        """
        self._topic = setup.topic
        self._timeout = setup.timeout
        self._horizon = max(setup.timeout, setup.horizon)
        self._newest: Optional[Heard] = None

    def subscription(self) -> Subscription:
        """Say what to hear: messages of any type, and nothing of their content."""
        return Subscription(self._topic)

    def hear(self, heard: Heard) -> None:
        """Take in one message."""
        self._newest = heard

    def read(self, now: float) -> SensorReading:
        """Tell how the sensor stands at a time [s]."""
        newest = self._newest
        if newest is not None and now - newest.receipt > self._horizon + TIME_TOLERANCE:
            newest = None
        fresh = newest is not None and now - newest.receipt <= self._timeout + TIME_TOLERANCE
        return SensorReading(self._topic, fresh, newest)


class Scan(AnyMessage):
    """A range finder that is up to date while it sees something (``mrta_alliance/scan``); implements RobotSensor.

    A scan counts if one of its rays ends within the sensor's reach. One that is covered, blinded or broken speaks on,
    but of rays that are too short, endless or not a number (REP 117).
    """

    def subscription(self) -> Subscription:
        """Say what to hear: ranges and their limits."""
        return Subscription(self._topic, "sensor_msgs/LaserScan", ("ranges", "range_min", "range_max"))

    def hear(self, heard: Heard) -> None:
        """Take in one scan, if it sees anything."""
        low, high = heard.fields["range_min"], heard.fields["range_max"]
        if any(math.isfinite(each) and low <= each <= high for each in heard.fields["ranges"]):
            super().hear(heard)
