"""Times as people read them, and axes to lay them out on."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Tuple

from rqt_mrta_py.hooks import MonitorView

__all__ = ["Axis", "TimeAxis", "elapsed", "last_second", "mission_span", "number", "seconds", "ticks", "whole_seconds"]

_TIME_STEPS = (0.1, 0.2, 0.5, 1, 2, 5, 10, 15, 20, 30, 60, 120, 300, 600, 900, 1800, 3600, 7200, 14400, 43200, 86400)
_SHORTEST_SPAN = 10.0


@dataclass(frozen=True)
class Axis:
    """A straight scale from values to pixels.

    Attributes:
        low, high: values at its ends.
        first, last: where its ends are [pixels].
    """

    low: float
    high: float
    first: float
    last: float

    def __call__(self, value: float) -> float:
        """Give the place of a value [pixels]; beyond the ends it is the nearer end."""
        share = (value - self.low) / (self.high - self.low) if self.high > self.low else 0.0
        return self.first + min(max(share, 0.0), 1.0) * (self.last - self.first)


@dataclass(frozen=True)
class TimeAxis(Axis):
    """An axis of times on the stream's clock, labelled in mission time.

    Attributes:
        zero: when mission time is 0 [s].
    """

    zero: float = 0.0

    def ticks(self, most: int) -> Tuple[Tuple[float, str], ...]:
        """Give round times on this axis with their labels.

        Args:
            most: how many at most, two or more.

        Returns:
            (time on the stream's clock [s], label in ``unit``) each, in order.
        """
        span, scale = self.high - self.low, self._scale
        step = next((s for s in _TIME_STEPS if span / s <= most - 1), None)
        if step is None:
            step = scale * _round_step(span / (most - 1) / scale)
        first = math.ceil((self.low - self.zero) / step - 1e-9)
        last = math.floor((self.high - self.zero) / step + 1e-9)
        return tuple((self.zero + k * step, _label(k * step, step, scale)) for k in range(first, last + 1))

    @property
    def unit(self) -> str:
        """Name the unit of the labels."""
        return {1.0: "s", 60.0: "min", 3600.0: "h"}[self._scale]

    @property
    def _scale(self) -> float:
        longest = self.high - self.zero
        return 1.0 if longest <= 900.0 else 60.0 if longest <= 4 * 3600.0 else 3600.0


def _label(time: float, step: float, scale: float) -> str:
    """Write a round time in its unit: whole and half ones as numbers, others as minutes and seconds or the like."""
    if scale == 1.0 or (2.0 * step / scale).is_integer() or step < 1.0:
        return number(time / scale)
    whole, part = divmod(round(time * 60.0 / scale), 60)
    return f"{whole}:{part:02d}"


def mission_span(view: MonitorView) -> Tuple[float, float]:
    """Give when a mission starts and when it shall end, or as much as is known of it [s].

    Args:
        view: the mission; without a planned duration the end moves on in steps.
    """
    start = view.now if view.record.start is None else view.record.start
    gone = max(view.now - start, 0.0)
    if view.duration is None:
        return start, start + _step_up(gone)
    return start, start + max(view.duration, gone, 1e-3)


def last_second(view: MonitorView, time: float) -> float:
    """Give the last whole second of the mission at or before a time, both on the stream's clock [s]."""
    zero = view.now if view.record.start is None else view.record.start
    # Stamps are nanoseconds; their differences in floats fall short of whole seconds now and then.
    return zero + math.floor(time - zero + 1e-6)


def elapsed(view: MonitorView, time: float) -> float:
    """Turn a time on the stream's clock into mission time [s]; 0 before the first message."""
    return 0.0 if view.record.start is None else time - view.record.start


def seconds(duration: float) -> str:
    """Write a time: ``62.0 s``, from a quarter of an hour on ``1:02:05 h``."""
    if abs(duration) < 899.95:
        return f"{duration + 0.0:.1f} s"
    whole = round(abs(duration))
    return f"{'-' if duration < 0 else ''}{whole // 3600}:{whole // 60 % 60:02d}:{whole % 60:02d} h"


def whole_seconds(duration: float) -> str:
    """Write a time like ``seconds`` without tenths, rounded down."""
    return f"{math.floor(duration + 1e-6)} s" if 0.0 <= duration < 899.95 else seconds(duration)


def number(value: float) -> str:
    """Write a number with as many digits as it needs, six at most."""
    text = f"{value:.6g}"
    return "0" if text == "-0" else text


def ticks(low: float, high: float, most: int) -> Tuple[float, ...]:
    """Give round numbers from ``low`` to ``high``, in order: two where it can be, for one alone tells no scale.

    Args:
        low: where they begin.
        high: where they end.
        most: how many there may be, two or more.
    """
    if not high > low:
        return (low,)
    step = _round_step((high - low) / (most - 1))
    found = _multiples(low, high, step)
    finer = _multiples(low, high, _round_step(step * 0.4)) if len(found) < 2 else found
    return finer if len(finer) <= most else found


def _multiples(low: float, high: float, step: float) -> Tuple[float, ...]:
    return tuple(k * step for k in range(math.ceil(low / step - 1e-9), math.floor(high / step + 1e-9) + 1))


def _round_step(least: float) -> float:
    """Give the smallest of 1, 2, 5 times a power of ten that is not below ``least``."""
    power = 10.0 ** math.floor(math.log10(least))
    return next(factor * power for factor in (1.0, 2.0, 5.0, 10.0) if factor * power >= least * (1.0 - 1e-9))


def _step_up(gone: float) -> float:
    """Give a span that holds ``gone`` [s] and stays the same for a while: 10, 12.5, 16 ... seconds."""
    span = _SHORTEST_SPAN
    while span < gone:
        span *= 1.25
    return span
