"""At which control ticks something slower than control is due, in exact arithmetic."""

from __future__ import annotations

import math
from fractions import Fraction

__all__ = ["Cycle"]


class Cycle:
    """Spreads the steps of a rate over control ticks.

    Step k (from 0) falls on tick ceil(k * control_rate / rate). Of a rate above the control rate, a step falls on every
    tick, once.

    Args:
        rate: steps a second [Hz]; taken as the nearest fraction with a denominator up to a million, so that 0.1 is
            one tenth.
        control_rate: control ticks a second [Hz].

    Raises:
        ValueError: a rate is not a finite number above 0.
    """

    def __init__(self, rate: float, control_rate: int) -> None:
        if not (math.isfinite(rate) and rate > 0.0):
            raise ValueError(f"a rate of {rate!r} Hz; it must be a finite number above 0")
        if control_rate <= 0:
            raise ValueError(f"a control rate of {control_rate!r} Hz; it must be above 0")
        exact = Fraction(rate).limit_denominator(1_000_000)
        # Far below one step in a mission, the nearest such fraction is 0; keep the exact value then.
        steps_per_tick = min(Fraction(1), (exact or Fraction(rate)) / control_rate)
        # Kept as two integers: a Fraction takes many times as long.
        self._steps, self._ticks = steps_per_tick.numerator, steps_per_tick.denominator

    def after(self, tick: int) -> int:
        """Give the first tick after this one on which a step falls.

        Args:
            tick: from -1; the steps that fell on it or before are taken as made.
        """
        # ceil(k / s) <= tick is k <= s * tick.
        next_step = tick * self._steps // self._ticks + 1
        return -(-next_step * self._ticks // self._steps)
