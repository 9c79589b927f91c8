"""Where a robot was: its recent trail and its whole path, both in bounded memory."""

from __future__ import annotations

from collections import deque
from typing import Deque, List, Optional, Tuple

__all__ = ["PathKeeper"]

_Point = Tuple[float, float, float]

_SPACING = 0.05
_MOST = 400
_LONGEST = 4000


class PathKeeper:
    """Keeps points of a path: (time [s], x [m], y [m]) each, oldest first.

    A point is kept once the robot has moved a little since the one before; the newest is always known. When the
    whole path outgrows its bound every other point is dropped and the spacing doubled. A clock that jumps back
    begins a new path.

    Args:
        trail: how far back the recent trail reaches [s].
        spacing: between two points that are kept [m].
        most: the most points of the recent trail; at least 1.
        longest: the most points of a whole path; at least 2.
    """

    __slots__ = (
        "_longest",
        "_recent",
        "_recent_x",
        "_recent_y",
        "_square",
        "_trail",
        "_whole",
        "_whole_square",
        "newest",
    )

    def __init__(self, trail: float, spacing: float = _SPACING, most: int = _MOST, longest: int = _LONGEST) -> None:
        self._trail = trail
        self._square = self._whole_square = spacing * spacing
        self._longest = longest
        self._recent: Deque[_Point] = deque(maxlen=most)
        # Of the newest point kept: asked for with every message, so not looked up in the deque.
        self._recent_x = self._recent_y = 0.0
        self._whole: List[_Point] = []
        self.newest: Optional[_Point] = None

    def add(self, time: float, x: float, y: float) -> None:
        """Take in where the robot is.

        Args:
            time: on the stream's clock [s].
            x: in the frame ``map`` [m].
            y: in the frame ``map`` [m].
        """
        newest = self.newest
        if newest is not None and time < newest[0]:
            self._recent.clear()
            self._whole.clear()
            self._whole_square = self._square
        self.newest = (time, x, y)
        dx, dy = x - self._recent_x, y - self._recent_y
        if dx * dx + dy * dy < self._square and self._recent:
            if self._recent[0][0] < time - self._trail:
                self._forget(time - self._trail)
            return
        self._keep(time, x, y)

    def recent(self, now: float) -> Tuple[_Point, ...]:
        """Give the trail that ends at the newest point.

        Args:
            now: points older than the trail's length before it are left out [s].
        """
        recent, oldest = self._recent, now - self._trail
        if recent and recent[0][0] >= oldest:
            points = tuple(recent)
        else:
            points = tuple(point for point in recent if point[0] >= oldest)
        return self._ending_in_newest(points)

    def fades(self, trail: Tuple[_Point, ...], now: float) -> bool:
        """Tell whether a trail given earlier begins with a point that is too old by now [s]."""
        return len(trail) > 1 and trail[0][0] < now - self._trail

    def whole(self) -> Tuple[_Point, ...]:
        """Give the whole path, which ends at the newest point."""
        return self._ending_in_newest(tuple(self._whole))

    def _keep(self, time: float, x: float, y: float) -> None:
        point = (time, x, y)
        self._recent.append(point)
        self._recent_x, self._recent_y = x, y
        self._forget(time - self._trail)
        if self._whole:
            dx, dy = x - self._whole[-1][1], y - self._whole[-1][2]
            if dx * dx + dy * dy < self._whole_square:
                return
        self._whole.append(point)
        if len(self._whole) > self._longest:
            del self._whole[1::2]
            self._whole_square *= 4.0

    def _forget(self, oldest: float) -> None:
        while self._recent and self._recent[0][0] < oldest:
            self._recent.popleft()

    def _ending_in_newest(self, points: Tuple[_Point, ...]) -> Tuple[_Point, ...]:
        if self.newest is None or (points and points[-1] == self.newest):
            return points
        return points + (self.newest,)
