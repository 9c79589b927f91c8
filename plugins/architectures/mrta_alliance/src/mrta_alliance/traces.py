"""What changes over time, kept for pictures: little where little changes, and nothing lost that an eye could see."""

from __future__ import annotations

import math
from array import array
from bisect import bisect_left, bisect_right
from typing import List, Sequence, Tuple

__all__ = ["SILENCE", "Slope", "Steps", "thinned"]

SILENCE = 2.0
"""Nothing is drawn across a longer silence: nobody knows what was then [s]."""

Points = Tuple[Tuple[float, ...], Tuple[float, ...]]
"""Times, not decreasing, and as many values; a NaN breaks the line."""


class Slope:
    """A value that moves between the moments at which it is told; while it stands still only the ends count."""

    def __init__(self) -> None:
        self._times = array("d")
        self._values = array("d")

    def add(self, time: float, value: float) -> None:
        """Take in a value.

        Args:
            time: when it was told [s]; a time before the last one counts as that, for bags may be played in a loop.
            value: NaN where there is none.
        """
        times, values = self._times, self._values
        if times:
            time = max(time, times[-1])
            if time - times[-1] > SILENCE and not math.isnan(values[-1]):
                times.append(times[-1])
                values.append(math.nan)
        if len(times) > 1 and _alike(values[-2], values[-1]) and _alike(values[-1], value):
            times[-1] = time
            return
        times.append(time)
        values.append(value)

    def between(self, start: float, end: float) -> Points:
        """Give the points from ``start`` to ``end`` [s], and those just outside that a line comes from and leads to."""
        first = max(bisect_left(self._times, start) - 1, 0)
        last = bisect_right(self._times, end) + 1
        return tuple(self._times[first:last]), tuple(self._values[first:last])

    def at(self, time: float) -> float:
        """Give the newest value that was kept by a time [s]; NaN if there was none."""
        return _newest(self._times, self._values, time)


class Steps:
    """A value that lasts until another one is told."""

    def __init__(self) -> None:
        self._times = array("d")
        self._values = array("d")
        self._heard = -math.inf

    def add(self, time: float, value: float) -> None:
        """Take in a value.

        Args:
            time: when it was told [s]; as in Slope.
            value: from then on.
        """
        time = max(time, self._heard)
        if self._times and time - self._heard > SILENCE:
            self._times.append(self._heard)
            self._values.append(math.nan)
        self._heard = time
        if not self._values or not _alike(self._values[-1], value):
            self._times.append(time)
            self._values.append(value)

    def between(self, start: float, end: float) -> Points:
        """Give the value at ``start``, if any, every change up to ``end``, and when it was last told by then [s]."""
        first = max(bisect_right(self._times, start) - 1, 0)
        last = bisect_right(self._times, end)
        if last <= first:
            return (), ()
        times = [max(time, start) for time in self._times[first:last]]
        values = list(self._values[first:last])
        if not math.isnan(values[-1]):
            until = self._heard if last == len(self._times) else self._times[last]
            times.append(max(min(until, end), times[-1]))
            values.append(values[-1])
        return tuple(times), tuple(values)

    def at(self, time: float) -> float:
        """Give the value that holds at a time [s]; NaN if there was none."""
        return _newest(self._times, self._values, time)

    def largest(self) -> float:
        """Give the largest value so far; 0 if none was above."""
        return max([0.0, *(value for value in self._values if value < math.inf)])


def thinned(points: Points, most: int) -> Points:
    """Leave out points that no picture could show.

    Args:
        points: any number of them.
        most: about so many remain, at least 8.

    Returns:
        The points themselves if they are few. Else the time is cut into equal parts, and of each the first and last
        point remain, the lowest and highest, and breaks: neither peaks nor falls are lost.
    """
    times, values = points
    if len(times) <= most:
        return points
    part = (times[-1] - times[0]) / (most // 4)
    if part <= 0.0:
        return points
    kept: List[int] = []
    begin = 0
    while begin < len(times):
        edge = times[0] + part * (math.floor((times[begin] - times[0]) / part) + 1)
        after = max(bisect_left(times, edge, begin), begin + 1)
        kept += _telling(values, begin, after)
        begin = after
    return tuple(times[index] for index in kept), tuple(values[index] for index in kept)


def _newest(times: array[float], values: array[float], time: float) -> float:
    index = bisect_right(times, time) - 1
    return values[index] if index >= 0 else math.nan


def _telling(values: Sequence[float], begin: int, end: int) -> List[int]:
    """Choose the points of one part that are seen, in order."""
    chosen = {begin, end - 1}
    known = [index for index in range(begin, end) if not math.isnan(values[index])]
    chosen.update(index for index in range(begin, end) if math.isnan(values[index]))
    if known:
        chosen.add(min(known, key=values.__getitem__))
        chosen.add(max(known, key=values.__getitem__))
    return sorted(chosen)


def _alike(one: float, other: float) -> bool:
    return one == other or (math.isnan(one) and math.isnan(other))
