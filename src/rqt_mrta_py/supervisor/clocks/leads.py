"""Leads: how far stamps are ahead of receipts, and when that is more than chance."""

from __future__ import annotations

import math
from enum import Enum
from statistics import median
from typing import List, Optional

from rqt_mrta_py.hooks import Heard
from rqt_mrta_py.supervisor.agenda import whole_nanoseconds

__all__ = ["LEAST_TOLERANCE", "LeadWatch", "Verdict", "tolerance_of"]

LEAST_TOLERANCE = 0.5
"""Computers that are set by NTP agree to milliseconds, but a busy one may take so long for a message [s]."""
_ENOUGH = 3
"""Messages that must agree before anything is said."""
_NOTHING = Heard("", "", -math.inf, {})


def tolerance_of(timeout: float) -> float:
    """Say how far stamps and receipts of a topic may be apart.

    Args:
        timeout: how long a message of it counts [s].

    Returns:
        Half of that, at least 0.5 s: a clock that is off by more makes others believe a robot dead that is alive, or
        alive that is dead, for half as long again [s].
    """
    return max(LEAST_TOLERANCE, timeout / 2.0)


class Verdict(Enum):
    """What a watch concludes from a message."""

    OFF = "off"
    RIGHT = "right"


class LeadWatch:
    """Judges the leads of one robot on one topic.

    The lead of a message is its stamp minus its receipt: what the sender's clock is ahead of the receiver's, minus how
    long the message took. So a lead above 0 shows a clock ahead, and one below 0 a clock behind or a slow message. The
    watch is off when no message of at least three, over at least as long as is tolerated, came within the tolerance,
    so that a computer that stood still for a moment is no matter; it is right again when three, over as long, came
    within half of it.

    Args:
        tolerance: what is accepted, either way [s].

    Attributes:
        tolerance: see above.
        calm: whether the newest message was within it, and nothing is in doubt.
        off: whether stamps are off.
        first: the first message of those that are, or were.
        newest: the newest of them.
        right: the first message of those that are right again.
    """

    __slots__ = (
        "_back",
        "_candidates",
        "_leads",
        "_since",
        "_told",
        "calm",
        "first",
        "newest",
        "off",
        "right",
        "tolerance",
    )

    def __init__(self, tolerance: float) -> None:
        self.tolerance = tolerance
        self.calm = True
        self.off = False
        self.first = self.newest = self.right = _NOTHING
        self._since = 0.0
        self._candidates = 0
        self._back = False
        self._leads: List[float] = []
        self._told = 0.0

    @property
    def lead(self) -> float:
        """The middle one of the newest three leads that were off [s]."""
        return median(self._leads)

    @property
    def is_news(self) -> bool:
        """Whether stamps are off by another lead than was told."""
        return self.off and self.lead != self._told

    def judge(self, now: float, lead: float, message: Heard) -> Optional[Verdict]:
        """Take in a message; needed only if it is not calm, or the lead is not within the tolerance.

        Args:
            now: when it was received [s].
            lead: its stamp minus its receipt [s]; one that is no number is passed over.
            message: it.

        Returns:
            OFF: stamps are off, or by far more or less than was told; RIGHT: no more. None: nothing new.
        """
        if not math.isfinite(lead):
            return None
        return self._doubt(now, lead, message) if self.off else self._suspect(now, lead, message)

    def tell(self) -> float:
        """Give the lead [s], which counts as told."""
        self._told = self.lead
        return self._told

    def _suspect(self, now: float, lead: float, message: Heard) -> Optional[Verdict]:
        if abs(lead) <= self.tolerance:
            self.calm, self._candidates = True, 0
            return None
        if not self._candidates or (lead > 0.0) is not (self._leads[-1] > 0.0):
            self._leads, self._candidates = [], 0
            self._since, self.first = now, message
        self.calm = False
        self._note(lead, message)
        self.off = self._suffices(now)
        return Verdict.OFF if self.off else None

    def _doubt(self, now: float, lead: float, message: Heard) -> Optional[Verdict]:
        ahead = self._leads[-1] > 0.0
        if (lead > 0.0) is ahead and abs(lead) > self.tolerance / 2.0:
            self._back = False
            self._note(lead, message)
            far = abs(self.lead - self._told) > max(self.tolerance, abs(self._told) / 4.0)
            return Verdict.OFF if far else None
        if not self._back:
            self._back, self._candidates = True, 0
            self._since, self.right = now, message
        self._candidates += 1
        if not self._suffices(now):
            return None
        self.off, self._back, self.calm, self._candidates = False, False, True, 0
        return Verdict.RIGHT

    def _note(self, lead: float, message: Heard) -> None:
        self.newest = message
        self._candidates += 1
        self._leads = [*self._leads[1 - _ENOUGH :], lead]

    def _suffices(self, now: float) -> bool:
        return self._candidates >= _ENOUGH and whole_nanoseconds(now - self._since) >= self.tolerance
