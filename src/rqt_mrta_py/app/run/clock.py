"""Mission time as an integer tick."""

from __future__ import annotations

from dataclasses import dataclass

from rqt_mrta_py.sim import first_tick_at

__all__ = ["RunClock"]

_NS = 1_000_000_000
_END_OF_TIME_NS = 2**32 * _NS


@dataclass(frozen=True)
class RunClock:
    """Mission time as an integer tick.

    Attributes:
        rate: ticks a second [Hz].
    """

    rate: int

    def stamp_ns(self, tick: int) -> int:
        """Give a tick's stamp [ns]; mission second s carries stamp s + 1, for ROS takes 0 as unset."""
        return _NS + tick * _NS // self.rate

    def stamp(self, tick: int) -> float:
        """Give a tick's stamp [s]."""
        return self.stamp_ns(tick) / _NS

    def ticks(self, seconds: float) -> int:
        """Give the tick at or next after a mission time [s]."""
        return first_tick_at(seconds, self.rate)

    def nearest(self, stamp_ns: int) -> int:
        """Give the tick whose stamp is next to a time [ns]; below 0 for times before the mission."""
        return ((stamp_ns - _NS) * self.rate + _NS // 2) // _NS

    def can_tell(self, tick: int) -> bool:
        """Tell whether a tick's stamp fits into ROS time, which has 2^32 seconds."""
        return self.stamp_ns(tick) < _END_OF_TIME_NS
