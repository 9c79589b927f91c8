"""Where a robot was: its recent trail and its whole path, both in bounded memory."""

from __future__ import annotations

from collections import deque
from typing import Deque, List, Tuple

__all__ = ["PathKeeper"]

_Point = Tuple[float, float, float]

_SPACING = 0.05
_LONGEST = 4000


class PathKeeper:
    """Keeps points of a path: (time [s], x [m], y [m]) each, oldest first.

    A point is kept once the robot has moved a few centimetres since the one before; the newest is always known. When
    the whole path outgrows its bound every other point is dropped and the spacing doubled. A clock that jumps back
    begins a new path.

    Args:
        trail: how far back the recent trail reaches [s].
        spacing: between two points that are kept [m].
        longest: the most points of a whole path; at least 2.
    """

    def __init__(self, trail: float, spacing: float = _SPACING, longest: int = _LONGEST) -> None:
        self._trail = trail
        self._spacing = spacing
        self._whole_spacing = spacing
        self._longest = longest
        self._recent: Deque[_Point] = deque()
        self._whole: List[_Point] = []
        self._newest: Tuple[_Point, ...] = ()

    def add(self, time: float, x: float, y: float) -> None:
        """Take in where the robot is.

        Args:
            time: on the stream's clock [s].
            x: in the frame ``map`` [m].
            y: in the frame ``map`` [m].
        """
        if self._newest and time < self._newest[0][0]:
            self._recent.clear()
            self._whole.clear()
            self._whole_spacing = self._spacing
        point = (time, x, y)
        self._newest = (point,)
        if not self._recent or _apart(self._recent[-1], point, self._spacing):
            self._recent.append(point)
        while self._recent and self._recent[0][0] < time - self._trail:
            self._recent.popleft()
        if not self._whole or _apart(self._whole[-1], point, self._whole_spacing):
            self._whole.append(point)
            if len(self._whole) > self._longest:
                del self._whole[1::2]
                self._whole_spacing *= 2.0

    def recent(self, now: float) -> Tuple[_Point, ...]:
        """Give the trail that ends at the newest point.

        Args:
            now: points older than the trail's length before it are left out [s].
        """
        oldest = now - self._trail
        return _ending_in(tuple(point for point in self._recent if point[0] >= oldest), self._newest)

    def whole(self) -> Tuple[_Point, ...]:
        """Give the whole path, which ends at the newest point."""
        return _ending_in(tuple(self._whole), self._newest)


def _apart(one: _Point, other: _Point, spacing: float) -> bool:
    dx, dy = other[1] - one[1], other[2] - one[2]
    return dx * dx + dy * dy >= spacing * spacing


def _ending_in(points: Tuple[_Point, ...], newest: Tuple[_Point, ...]) -> Tuple[_Point, ...]:
    return points if points[-1:] == newest else points + newest
