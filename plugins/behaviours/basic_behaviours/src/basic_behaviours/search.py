"""A search of an area: along lanes, looking around at the beginning of each, and what of it is left to do."""

from __future__ import annotations

import math
from typing import List, NamedTuple, Optional, Sequence

from basic_behaviours.area import Lane, from_nearer_end
from rqt_mrta_py.model import Pose, wrap_angle

__all__ = ["LookAround", "Search", "SearchStop"]

_FULL_TURN = 2.0 * math.pi - 0.2
_LONGEST_TURN = 15.0


class SearchStop(NamedTuple):
    """A place that a search leads to.

    Attributes:
        place: in the frame ``map``.
        tolerance: how near is there [m].
        look_around: True if the robot has to turn round there.
    """

    place: Pose
    tolerance: float
    look_around: bool


class Search:
    """Gives one stop after the other, until the area was searched from beginning to end.

    Args:
        laid: the lanes.
        tolerance: how near to their ends the robot has to come [m].
    """

    def __init__(self, laid: Sequence[Lane], tolerance: float) -> None:
        self._lanes = laid
        self._tolerance = tolerance
        self._stops: List[SearchStop] = []
        self._reached = False

    @property
    def stop(self) -> Optional[SearchStop]:
        """Where to go next; None if the search is over."""
        return self._stops[0] if self._stops else None

    @property
    def reached_any(self) -> bool:
        """Tell whether the robot came to any stop since the search began."""
        return self._reached

    def begin(self, pose: Pose) -> None:
        """Begin, or begin anew, at the end of the lanes that is nearer to the robot's pose."""
        self._stops = [
            SearchStop(place, self._tolerance, index == 0)
            for lane in from_nearer_end(self._lanes, pose)
            for index, place in enumerate(lane)
        ]
        self._reached = False

    def leave(self, *, reached: bool) -> None:
        """Go on to the next stop.

        Args:
            reached: False if there was no way to this one.
        """
        self._reached = self._reached or reached
        del self._stops[0]


class LookAround:
    """One turn round on the spot."""

    def __init__(self) -> None:
        self._turned = 0.0
        self._yaw: Optional[float] = None
        self._since = 0.0

    def begin(self) -> None:
        """Begin a turn."""
        self._turned, self._yaw = 0.0, None

    def is_over(self, now: float, yaw: float) -> bool:
        """Take in where the robot heads [rad] at a time [s]; tell whether it has turned round, or tried for long."""
        if self._yaw is None:
            self._yaw, self._since = yaw, now
        self._turned += wrap_angle(yaw - self._yaw)
        self._yaw = yaw
        return abs(self._turned) >= _FULL_TURN or now - self._since > _LONGEST_TURN
