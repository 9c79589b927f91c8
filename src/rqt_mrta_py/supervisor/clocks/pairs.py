"""Two clocks by which each other's messages were received: how far they are apart, bounded on both sides."""

from __future__ import annotations

from itertools import combinations
from typing import Mapping, Tuple

from rqt_mrta_py.model.timing import ClockPair

__all__ = ["clock_pairs"]


def clock_pairs(leads: Mapping[str, Mapping[str, float]]) -> Tuple[ClockPair, ...]:
    """Bound the offset between each two robots that have received from one another.

    A lead is offset minus latency, and no latency is below 0. With A's clock minus B's as the offset o, what B received
    from A says ``lead_A <= o``, what A received from B ``lead_B <= -o``; so ``lead_A <= o <= -lead_B``, whose width is
    the sum of the two shortest latencies.

    Source: the inequality behind NTP's sample of a round trip (RFC 5905, section 8). Differs from there: the two
    messages of a round trip need not answer each other, and no middle is taken, for that supposes equal latencies.

    Args:
        leads: by the robot by whose clock receipts are, then by the robot that sent: the largest lead [s].

    Returns:
        The pairs of which both directions are known, in the order of ``leads``.
    """
    return tuple(
        ClockPair(robot, other, leads[other][robot], 0.0 - leads[robot][other])
        for robot, other in combinations(leads, 2)
        if robot in leads[other] and other in leads[robot]
    )
