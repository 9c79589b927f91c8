"""Equations 3.1 to 3.12 of ALLIANCE, one pure function each; 3.11 and 3.12 are 3.9 and 3.10 with a threshold of 1.

Sources: L. E. Parker, "ALLIANCE: an architecture for fault tolerant multirobot cooperation", IEEE Transactions on
Robotics and Automation 14(2), 1998; in the numbering and polarity of the dissertation behind rqt_mrta (Leite 2017).
Parker defines suppression, reset and acquiescence as factors that are 0 when they strike; here, as in the
dissertation, they are conditions that are true when they strike.

Letters of the paper, and their names here; robot r_i, its behaviour set c_ij, another robot r_k:

* t, dt: ``now`` and the time since the cycle before [s]
* theta: ``threshold``, the motivation at which a behaviour set becomes active [1]
* tau_i: ``timeout``, the longest silence after which another robot counts as stopped [s]
* psi_ij, lambda_ij: ``yielding_delay`` and ``giving_up_delay`` [s]
* phi_ij(k, t): ``patience``, how long r_i lets r_k try the task [s]; r_k announces it as expected duration
* delta_fast_ij: ``fast_rate``, growth of motivation in one cycle while nobody carries out the task [1]
* delta_slow_ij(k, t): growth in one cycle while r_k does [1]
* rho_i: ``spin_rate``, how often r_i evaluates its motivations [Hz]

Motivation grows by ``impatience`` once a cycle, so a rate in the parameters is a growth per cycle, and motivation
grows by rate times spin rate each second, as in the original nodes.

Times are float seconds. Counted from 1970 they are exact to a quarter of a microsecond only, so an instant is met
within ``TIME_TOLERANCE``.
"""

from __future__ import annotations

import math
from typing import Iterable, NamedTuple, Protocol, Sequence

__all__ = [
    "TIME_TOLERANCE",
    "Announcements",
    "OtherRobot",
    "acquiescent",
    "active",
    "active_for",
    "applicable",
    "impatience",
    "inhibited",
    "motivation",
    "received",
    "reset",
    "slow_rate",
    "time_to_activation",
]

TIME_TOLERANCE = 1e-6


class OtherRobot(Protocol):
    """What r_i knows of one other robot r_k that announced the task of c_ij."""

    @property
    def patience(self) -> float:
        """phi_ij(k, t), the expected duration of the newest announcement, above 0 [s]."""
        ...

    def received(self, after: float, until: float) -> bool:
        """Judge whether an announcement was received within a window (equation 3.3) [s]."""
        ...


class Announcements(NamedTuple):
    """The announcements of one other robot r_k, as the equations take them.

    Attributes:
        times: when announcements were received, ascending, the first one ever included [s].
        noticed: at which cycle of r_i the first of them was taken in [s].
        patience: phi_ij(k, t), the expected duration of the newest one, above 0 [s].
    """

    times: Sequence[float]
    noticed: float
    patience: float

    def received(self, after: float, until: float) -> bool:
        """Judge whether one of them was received within a window (equation 3.3) [s]."""
        return received(self.times, after, until)


def applicable(sensory_feedback: bool, possible: bool) -> bool:
    """Judge whether the behaviour set can do anything in the present state of the environment (equation 3.1).

    Differs from the paper: there the sensors alone decide; here a task that is over, or that the robot's behaviour
    could not carry out now, is no longer applicable either.

    Args:
        sensory_feedback: what the sensory evaluator says; True for a behaviour set without sensors.
        possible: whether the task is still open and the robot's behaviour for it could be carried out.
    """
    return sensory_feedback and possible


def inhibited(others_active: Iterable[bool]) -> bool:
    """Judge whether another behaviour set of the same robot is active (equation 3.2).

    Args:
        others_active: for every other behaviour set of r_i, whether it is active at t.
    """
    return any(others_active)


def received(times: Sequence[float], after: float, until: float) -> bool:
    """Judge whether a message was received within a window (equation 3.3).

    Differs from the paper: its window [t1, t2] is closed, so that a message exactly at t1 also ends the window
    before it, and 3.4 loses a reset. Here the window is (t1, t2], and what ends before it begins is empty.

    Args:
        times: of receipt, ascending [s].
        after: t1 [s].
        until: t2 [s].
    """
    earliest = after + TIME_TOLERANCE
    latest = until + TIME_TOLERANCE
    for time in reversed(times):
        if time <= earliest:
            return False
        if time <= latest:
            return True
    return False


def reset(others: Iterable[Announcements], before: float, now: float) -> bool:
    """Judge whether some robot announced the task for the first time since the cycle before (equation 3.4).

    Each other robot resets a behaviour set once in its life, lest a robot that fails again and again keep the task
    from being done.

    Differs from the paper: what counts is the cycle at which r_i takes the first message in, not when it was received.
    One that came at the very moment of the cycle before, but after it, would otherwise reset nothing.

    Args:
        others: the robots heard of this task.
        before: t - dt, the cycle before [s].
        now: t [s].
    """
    # Noticed is when the first message came, so there is none before it.
    return any(received((other.noticed,), before, now) for other in others)


def active_for(delay: float, active_since: float, now: float) -> bool:
    """Judge whether a behaviour set that is active has been so for more than a delay (equation 3.5).

    Args:
        delay: D [s].
        active_since: when it became active [s].
        now: t [s].
    """
    return now - active_since > delay + TIME_TOLERANCE


def acquiescent(
    others: Iterable[OtherRobot],
    active_since: float,
    now: float,
    *,
    timeout: float,
    yielding_delay: float,
    giving_up_delay: float,
) -> bool:
    """Judge whether an active behaviour set lets its task go (equation 3.6); one that is not active never does.

    Differs from the dissertation's prose, which counts psi from the other robot's start: equation, Parker and the
    original nodes count how long c_ij itself has been active.

    Args:
        others: the robots heard of this task.
        active_since: when the behaviour set became active [s].
        now: t [s].
        timeout: tau_i [s].
        yielding_delay: psi_ij [s].
        giving_up_delay: lambda_ij [s].
    """
    if active_for(giving_up_delay, active_since, now):
        return True
    return active_for(yielding_delay, active_since, now) and any(other.received(now - timeout, now) for other in others)


def slow_rate(threshold: float, patience: float) -> float:
    """Give the growth of motivation while another robot is on the task: delta_slow_ij(k, t) = theta / phi_ij(k, t).

    Args:
        threshold: theta [1].
        patience: phi_ij(k, t), above 0 [s].
    """
    return threshold / patience


def impatience(others: Iterable[OtherRobot], now: float, timeout: float, threshold: float, fast_rate: float) -> float:
    """Give the growth of motivation in this cycle (equation 3.7).

    Differs from the paper: its printed minimum has no index set; it runs over K, the robots heard within tau and
    first heard less than phi ago. The fast rate bounds it, so that a robot that announces a duration too short to
    slow anybody down speeds nobody up. A robot's head start, which multiplies it, is ours (see ``parameters``).

    Args:
        others: the robots heard of this task.
        now: t [s].
        timeout: tau_i [s].
        threshold: theta [1].
        fast_rate: delta_fast_ij [1].
    """
    slowed_by = (
        slow_rate(threshold, other.patience)
        for other in others
        if other.received(now - timeout, now) and not other.received(0.0, now - other.patience)
    )
    return min((fast_rate, *slowed_by))


def motivation(
    previous: float,
    growth: float,
    *,
    is_applicable: bool,
    is_inhibited: bool,
    is_reset: bool,
    is_acquiescent: bool,
    threshold: float,
) -> float:
    """Give the motivation of a behaviour set (equation 3.8), no higher than the threshold.

    Differs from the paper: the dissertation prints the product with inhibited, reset and acquiescent themselves,
    which would let motivation grow only while all three strike. Its text, Parker's definitions of opposite polarity
    and the original nodes agree on their negations. And growth ends at the threshold, as in the original nodes.

    Args:
        previous: motivation_ij(t - dt), 0 at first [1].
        growth: impatience_ij(t) [1].
        is_applicable: applicable_ij(t).
        is_inhibited: inhibited_ij(t).
        is_reset: reset_ij(t).
        is_acquiescent: acquiescent_ij(t).
        threshold: theta [1].
    """
    if not is_applicable or is_inhibited or is_reset or is_acquiescent:
        return 0.0
    return min(previous + growth, threshold)


def active(value: float, threshold: float) -> bool:
    """Judge whether motivation has reached the threshold (equation 3.9; 3.11 with a threshold of 1).

    Args:
        value: motivation_ij(t) [1].
        threshold: theta [1].
    """
    return value >= threshold


def time_to_activation(value: float, growth: float, threshold: float, spin_rate: float, *, is_blocked: bool) -> float:
    """Estimate when a behaviour set will become active if its impatience stays (equation 3.10; 3.12 with theta 1).

    Args:
        value: motivation_ij(t) [1].
        growth: impatience_ij(t), per cycle [1].
        threshold: theta [1].
        spin_rate: rho_i [Hz].
        is_blocked: whether one of the four conditions of 3.8 strikes.

    Returns:
        The time from now [s]; 0 when active; NaN where it is undefined: motivation does not grow.
    """
    if is_blocked or growth <= 0.0:
        return math.nan
    return (threshold - value) / (growth * spin_rate)
