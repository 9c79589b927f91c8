"""How the original nodes time what they do; chosen by ``strict_original``.

They are the C++ nodes high_level and low_level of the ROS package alliance. What is said here was read in its public
sources and checked against a recording of 1.0.6, which shows all but a missed reset and a wrong inhibition. What the
nodes do otherwise than the equations (in brackets: what the equations say):

* A cycle evaluates first and takes in afterwards what came, so that a message counts one cycle later.
* Announcements count at their stamps, and are ignored unless later than the newest of the same robot (at receipt).
* An announcement is held for tau, and a window is looked at in steps of a tenth of tau. So a robot counts as silent
  only 2 tau after its last announcement (tau), and first heard only a tenth of tau after its first one.
* A behaviour set is reset once in its life, for the first robot heard (once for each other robot).
* A set is inhibited by the last change of any other set: whether that one became active then (while any is active).
* The first announcement goes out one period after activation, and a timer, once started, runs until it finds nothing
  active. A timer that falls due just when a cycle ends is found in the next. A task that is let go still counts as
  carried out in that cycle.
* There are no extensions: neither head start nor fairness.

Each behaviour set of the original reads the clock anew, some tens of microseconds apart; here a cycle has one time.
Stamps and durations that abort the original nodes are survived as ever (see ``communication``).
"""

from __future__ import annotations

from typing import Dict, List, Optional

from mrta_alliance.parameters import AllianceParameters
from mrta_alliance.timing import Timing
from rqt_mrta_py.hooks import Heard

__all__ = ["AS_ORIGINAL", "BroadcastTimer", "HeldAnnouncements", "HeldHistory", "ToggledInhibition"]

# What the timer's own thread needs to be heard of before a cycle ends [s].
_TIMER_LAG = 1e-3


def _ticks(seconds: float) -> int:
    """Give whole microseconds: float seconds since 1970 are not exact to more."""
    return round(seconds * 1e6)


class HeldAnnouncements:
    """The announcements of one other robot, each held for a while; implements OtherRobot."""

    def __init__(self, stamp: float, timeout: float, patience: float) -> None:
        """Begin with the first announcement.

        Args:
            stamp: of the announcement [s].
            timeout: tau, how long one is held [s].
            patience: its expected duration [s].
        """
        self.patience = patience
        self.newest = _ticks(stamp)
        self._start = self.newest
        self._timeout = _ticks(timeout)
        self._begins = [0]
        self._ends = [self._timeout]

    def hold(self, stamp: float, patience: float) -> None:
        """Take in a further announcement; one that is not later than the newest is ignored.

        Args:
            stamp: of the announcement [s].
            patience: its expected duration [s].
        """
        self.patience = patience
        if _ticks(stamp) <= self.newest:
            return
        self.newest = _ticks(stamp)
        passed = self.newest - self._start
        if self._ends[-1] < passed:
            self._begins.append(passed)
            self._ends.append(passed + self._timeout)
        else:
            self._ends[-1] = passed + self._timeout

    def received(self, after: float, until: float) -> bool:
        """Judge whether an announcement is held at an instant of a window that is looked at [s]."""
        return self.held_within(_ticks(after), _ticks(until))

    def held_within(self, after: int, until: int) -> bool:
        """Judge as ``received`` does, by whole microseconds."""
        stride = max(1, self._timeout // 10)
        return any(
            self._holds(instant) for instant in range(max(0, after - self._start), until - self._start + 1, stride)
        )

    def _holds(self, passed: int) -> bool:
        return any(begin < passed <= end for begin, end in zip(reversed(self._begins), reversed(self._ends)))


class HeldHistory:
    """Announcements of one task as the original nodes remember them; implements TaskHistory."""

    def __init__(self, timeout: float) -> None:
        """Start with an empty memory.

        Args:
            timeout: tau [s].
        """
        self._timeout = timeout
        self._peers: Dict[str, HeldAnnouncements] = {}
        self._newest: Optional[int] = None
        self._resetted = False

    def remember(self, robot: str, message: Heard, now: float) -> None:
        """Take in an announcement."""
        stamp, duration = message.fields["header/stamp"], message.fields["expected_duration"]
        if robot in self._peers:
            self._peers[robot].hold(stamp, duration)
        else:
            self._peers[robot] = HeldAnnouncements(stamp, self._timeout, duration)
        self._newest = _ticks(stamp)

    def others(self) -> List[HeldAnnouncements]:
        """List the robots that announced the task, in the order of their first announcements."""
        return list(self._peers.values())

    def resets(self, before: float, now: float) -> bool:
        """Judge as the original does: once, when something is held since the newest announcement and nothing before."""
        newest = self._newest
        if self._resetted or newest is None:
            return False
        others = self._peers.values()
        self._resetted = any(other.held_within(newest, _ticks(now)) for other in others) and not any(
            other.held_within(0, newest) for other in others
        )
        return self._resetted


class ToggledInhibition:
    """Inhibited as the last change of another set says; wrong with two others; implements Inhibition."""

    def __init__(self) -> None:
        """Start with nothing active."""
        self._changes: Dict[str, bool] = {}

    def note(self, task: str, active: bool) -> None:
        """Remember a change; the newest stands last."""
        if self._changes.get(task, False) != active:
            self._changes.pop(task, None)
            self._changes[task] = active

    def inhibits(self, task: str) -> bool:
        """Tell whether the newest change of any other set was to active."""
        return next((self._changes[other] for other in reversed(self._changes) if other != task), False)


class BroadcastTimer:
    """Announces one period after activation and then as a timer falls due; implements Announcer."""

    def __init__(self, period: float) -> None:
        """Start without a timer.

        Args:
            period: of announcements [s].
        """
        self._period = period
        self._due: Optional[float] = None
        self._before: Optional[str] = None

    def due(self, task: Optional[str], now: float) -> Optional[str]:
        """Tell which task to announce now, if any."""
        held, self._before = task or self._before, task
        if self._due is None:
            self._due = None if held is None else now + self._period
            return None
        if now < self._due + _TIMER_LAG:
            return None
        self._due = None if held is None else max(self._due + self._period, now)
        return held


def _held(told: AllianceParameters) -> HeldHistory:
    return HeldHistory(told.timeout_duration)


AS_ORIGINAL = Timing(
    hears_first=False,
    extended=False,
    history=_held,
    inhibition=ToggledInhibition,
    announcer=BroadcastTimer,
)
"""What ``strict_original`` chooses."""
