"""At which control ticks something slower than control is due, in exact arithmetic."""

from __future__ import annotations

import math
from fractions import Fraction

__all__ = ["Cycle"]


class Cycle:
    """Spreads the steps of a rate over control ticks.

    Step k (from 0) is due at tick ceil(k * control_rate / rate). A rate above the control rate is due at every tick,
    once. Steps that fell into ticks which were skipped are made up for by one step, at once.

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
        # Kept as two integers: asked at every tick of every robot, a Fraction takes many times as long.
        self._steps, self._ticks = steps_per_tick.numerator, steps_per_tick.denominator
        self._last_step = -1

    def due(self, tick: int) -> bool:
        """Tell whether a step falls on this tick, or fell on one skipped since the last call; asked once per tick."""
        # ceil(k / s) <= tick is k <= s * tick.
        step = tick * self._steps // self._ticks
        if step <= self._last_step:
            return False
        self._last_step = step
        return True
