"""Time as messages tell it: what is known of each connection's rate, gaps and clock. All times are in seconds."""

from __future__ import annotations

from dataclasses import dataclass
from typing import NamedTuple, Optional, Tuple

__all__ = ["ClockPair", "ConnectionTiming", "Gap", "RobotClock", "SenderClock", "TimingTable"]


class Gap(NamedTuple):
    """Nothing came on a connection between two messages, by their receipts [s]."""

    start: float
    end: float


@dataclass(frozen=True)
class SenderClock:
    """What header stamps tell of one sender's clock, held against receipts by one receiver.

    A lead is a stamp minus its receipt: the offset of the sender's clock minus the latency of the message. No latency
    is below 0, so the offset is at least the largest lead. How much larger it is, is the smallest latency, which
    messages that all go one way cannot tell.

    Attributes:
        stamped: how many messages have a stamp.
        offset: leads of the promptest messages, by a robust line through them, halfway between first and last [s].
        drift: how much that grows in a second [s/s].
        at_least: the largest lead: the sender's clock was ahead of the receiver's by at least so much, if that stamp
            tells when the message was sent [s].
        ahead: how many messages are stamped after their receipt.
        delay_median: half of the messages come later than the promptest by no more than this [s].
        delay_high: nineteen of twenty do [s].
    """

    stamped: int
    offset: float
    drift: float
    at_least: float
    ahead: int
    delay_median: float
    delay_high: float


@dataclass(frozen=True)
class ConnectionTiming:
    """One node on one topic, as its messages were received.

    Attributes:
        topic: resolved.
        type: ``pkg/Msg``.
        caller: resolved name of the node; empty if unknown.
        robot: in whose namespace the node is, else the topic; empty if in none's.
        messages: how many.
        start, end: receipt of the first and of the last one [s].
        rate: messages in a second, from the first to the last [Hz]; None for fewer than two, or of one moment.
        period: the middle one of the times between two messages [s]; None for fewer than two.
        jitter: by how much half of these times differ from it, at most [s]; None likewise.
        gaps: how many of these times are gaps; None where messages are not regular.
        longest_gaps: the longest of these, by start.
        longest: the longest of these times, whether a gap or not [s]; None for fewer than two.
        clock: of the sender; None where messages have no stamps: then there are only receipts.
    """

    topic: str
    type: str
    caller: str
    robot: str
    messages: int
    start: float
    end: float
    rate: Optional[float] = None
    period: Optional[float] = None
    jitter: Optional[float] = None
    gaps: Optional[int] = None
    longest_gaps: Tuple[Gap, ...] = ()
    longest: Optional[float] = None
    clock: Optional[SenderClock] = None


@dataclass(frozen=True)
class RobotClock:
    """One robot's clock, as the promptest of its connections shows it."""

    robot: str
    topic: str
    caller: str
    clock: SenderClock


class ClockPair(NamedTuple):
    """How far the clocks of two robots are apart, each of which received what the other sent.

    Attributes:
        robot: whose clock.
        other: that it is held against.
        at_least: robot's clock minus the other's is at least this [s].
        at_most: and at most this [s]; where it is less, no offset fits that stayed the same.
    """

    robot: str
    other: str
    at_least: float
    at_most: float


@dataclass(frozen=True)
class TimingTable:
    """All connections of a stream by topic, caller and type; the robots of which there are stamps, in their order.

    Attributes:
        connections: see above.
        robots: see above.
        pairs: of robots on both of which bags were recorded.
    """

    connections: Tuple[ConnectionTiming, ...] = ()
    robots: Tuple[RobotClock, ...] = ()
    pairs: Tuple[ClockPair, ...] = ()
