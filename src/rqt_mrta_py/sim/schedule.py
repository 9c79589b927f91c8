"""When something that has a rate is due, counted in ticks: float time never adds up."""

from __future__ import annotations

import math
from fractions import Fraction

__all__ = ["Schedule", "first_tick_at"]

_WITHIN = 1e-6
"""A moment so close after a tick, in ticks, counts as on it; floats of seconds are not exact."""


class Schedule:
    """The ticks at which something with a rate is due: the first, then as evenly as ticks allow.

    Args:
        rate: how often a second; above 0, at most the control rate [Hz].
        control_rate: ticks a second [Hz].

    Raises:
        ValueError: the rate is out of its bounds.
    """

    def __init__(self, rate: float, control_rate: int) -> None:
        if not (math.isfinite(rate) and 0 < rate <= control_rate):
            raise ValueError(f"rate must be above 0, at most the control rate of {control_rate} Hz (got {rate!r})")
        # Far below one time in a mission, the nearest such fraction is 0; keep the exact value then.
        per_tick = (Fraction(rate).limit_denominator(10**6) or Fraction(rate)) / control_rate
        self._numerator, self._denominator = per_tick.numerator, per_tick.denominator

    def is_due(self, tick: int) -> bool:
        """Tell whether it is due at a tick, counted from 0."""
        # What is left of the whole times it was due by now is less than what one tick adds.
        return tick * self._numerator % self._denominator < self._numerator


def first_tick_at(time: float, control_rate: int) -> int:
    """Give the first tick that does not come before a mission time.

    Args:
        time: [s].
        control_rate: ticks a second [Hz].
    """
    return math.ceil(time * control_rate - _WITHIN)
