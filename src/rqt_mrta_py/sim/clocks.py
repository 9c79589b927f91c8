"""Clocks of robots that are not quite right."""

from __future__ import annotations

__all__ = ["SLEW_RATE", "RobotClock"]

SLEW_RATE = 0.5
"""A clock that is set back loses so much for each true second [s/s]: it runs at half speed until it agrees."""


class RobotClock:
    """One robot's clock, right at first.

    Set forward, it jumps. Set back, it never runs backwards: it runs at half speed until it shows what it should, as a
    clock is slewed that programs rely on.
    """

    def __init__(self) -> None:
        self._target = 0.0
        self._begun = 0.0
        self._since = 0.0

    def shift(self, offset: float, now: float) -> None:
        """Set the clock.

        Args:
            offset: what it shall show minus the true time [s].
            now: the true time, not before that of any earlier call [s].
        """
        self._begun, self._since, self._target = max(self.offset(now), offset), now, offset

    def offset(self, now: float) -> float:
        """Give what it shows minus the true time [s], at a true time not before the newest shift [s]."""
        return max(self._target, self._begun - SLEW_RATE * (now - self._since))
