"""Rule: what a robot says is old when it is received."""

from __future__ import annotations

from typing import Sequence

from rqt_mrta_py.hooks import RuleSetup
from rqt_mrta_py.supervisor.clocks.stamped_off import StampIncidents
from rqt_mrta_py.supervisor.clocks.words import span_text

__all__ = ["MessageFromThePast"]


class MessageFromThePast(StampIncidents):
    """Puts up a warning while all that a robot says on a monitored topic was stamped long before it was received.

    How far counts is told by the topic's timeout: half of it, at least 0.5 s; how long, by the same. A clock that is
    behind and messages that are long under way look alike where they are received; the sentence says so.

    Args:
        setup: not needed.
    """

    causes = (
        "The robot's clock is behind the clock of whoever received (no NTP or chrony, set by hand), or its messages "
        "wait: a full queue, an overloaded computer, a slow radio. Where it is so of all robots: a recording that was "
        "played back, or the receiver's clock is ahead."
    )

    def __init__(self, setup: RuleSetup) -> None:
        super().__init__(ahead=False, text=_text)


def _text(robot: str, topics: Sequence[str], lead: float) -> str:
    return (
        f"what {robot} says on {' and '.join(topics)} is up to {span_text(-lead)} old when it is received: "
        "its clock is behind, or its messages are under way for so long"
    )
