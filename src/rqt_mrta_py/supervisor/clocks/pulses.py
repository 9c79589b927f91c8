"""Pulses: that a robot speaks regularly on a topic, and that it does so no more."""

from __future__ import annotations

import math
from bisect import bisect_left
from typing import Sequence

from rqt_mrta_py.hooks import Heard
from rqt_mrta_py.supervisor.agenda import whole_nanoseconds

__all__ = ["Pulse"]

_REGULAR = 5
"""So many beats make a pulse."""
_MISSED = 3
"""So many periods without a beat are a gap, if a message counts for less."""
_GRAIN = 0.05
"""What comes within this share of the timeout after a beat belongs to it: a robot may have a topic for each task."""
_LEARNED = 3
_NOTHING = Heard("", "", -math.inf, {})


class Pulse:
    """How one robot speaks on a topic that says that it is idle, which some do all the time and some only while idle.

    A robot that says that it is busy need not say more, unless it was heard to say both; and one that has never spoken
    regularly is never missed.

    Args:
        robot: its id.
        topic: as the architecture declares it.
        timeout: how long a message of it counts [s].

    Attributes:
        robot, topic: see above.
        silent: whether there is a gap; whoever notices that it has begun, or ended, says so here.
    """

    __slots__ = (
        "_beat",
        "_beats",
        "_between",
        "_busy_at",
        "_busy_message",
        "_busy_until",
        "_grain",
        "_heard_at",
        "_limit",
        "_message",
        "_spoken",
        "_timeout",
        "robot",
        "silent",
        "topic",
    )

    def __init__(self, robot: str, topic: str, timeout: float) -> None:
        self.robot = robot
        self.topic = topic
        self.silent = False
        self._timeout = timeout
        self._grain = timeout * _GRAIN
        self._heard_at = self._beat = self._busy_at = self._busy_until = -math.inf
        self._message = self._busy_message = _NOTHING
        self._beats = 0
        self._spoken = 0.0
        self._between = 0
        self._limit = math.inf

    @property
    def period(self) -> float:
        """How long it took from beat to beat on the average, gaps left out [s]; infinity before there are two."""
        return self._spoken / (self._beats - 1) if self._beats > 1 else math.inf

    @property
    def is_regular(self) -> bool:
        """Whether it has been heard often enough to be missed."""
        return self._beats >= _REGULAR

    @property
    def is_steady(self) -> bool:
        """Whether it is missed as soon as its last message counts no more, for it comes often enough."""
        return self.is_regular and not self.silent and self._limit <= self._timeout

    @property
    def last(self) -> Heard:
        """The newest message that shows that the robot is well."""
        return self._message if self.says_both or self._heard_at >= self._busy_at else self._busy_message

    @property
    def due(self) -> float:
        """When it is missed, if nothing comes until then [s]; infinity if it never is."""
        if not self.is_regular or self.silent:
            return math.inf
        due = self._heard_at + self._limit
        if not self.says_both:
            due = max(due, self._busy_at + self._limit, self._busy_until)
        return whole_nanoseconds(due)

    def hear(self, now: float, message: Heard) -> bool:
        """Take in a message of the topic.

        Args:
            now: when it was received [s].
            message: it.

        Returns:
            Whether it makes a pulse of what was none, ends a gap, or lets one begin after a shorter time than before.
        """
        self._message = message
        self._heard_at = now
        beat = self._beat
        if now - beat < self._grain:
            return self.silent
        if self.silent:
            self._spoken += self.period
        elif self._beats:
            self._spoken += now - (beat if self.says_both else max(beat, self._busy_at))
        self._beat = now
        self._beats += 1
        limit = self._limit
        self._learn()
        return self.silent or self._beats == _REGULAR or self._limit < limit

    def hear_together(self, times: Sequence[float], last: Heard) -> None:
        """Take in messages of the topic as ``hear`` takes them one by one, while it is a steady pulse.

        Args:
            times: when they were received, in order [s]; nobody has said meanwhile that the robot is busy, unless it
                says both.
            last: the last of them.
        """
        if not times:
            return
        beat, grain, place = self._beat, self._grain, 0
        while True:
            # Whether a message belongs to the beat is decided by the difference, as it is for one alone.
            place = bisect_left(times, beat + grain, place)
            while place and not times[place - 1] - beat < grain:
                place -= 1
            while place < len(times) and times[place] - beat < grain:
                place += 1
            if place == len(times):
                break
            now = times[place]
            self._spoken += now - (beat if self.says_both else max(beat, self._busy_at))
            self._beats += 1
            beat = now
        self._beat = beat
        self._learn()
        self._heard_at = times[-1]
        self._message = last

    def hear_busy(self, now: float, until: float, message: Heard) -> bool:
        """Take in that the robot says that it is busy.

        Args:
            now: when that was received [s].
            until: how long it counts [s].
            message: it.

        Returns:
            Whether it ends a gap, or shows that the robot may be missed though it says this.
        """
        both = self.says_both
        if self._busy_at < self._heard_at and now < self._busy_until:
            self._between += 1
        self._busy_at, self._busy_message = now, message
        self._busy_until = max(until, self._busy_until)
        return not both and (self.silent or self.says_both)

    def _learn(self) -> None:
        """Learn after what time it is missed."""
        self._limit = max(self._timeout, _MISSED * self.period)

    @property
    def says_both(self) -> bool:
        """Whether it was heard to say that it is idle while it is busy."""
        return self._between >= _LEARNED
