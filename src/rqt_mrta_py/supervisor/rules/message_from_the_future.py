"""Rule: what a robot says is stamped after it was received."""

from __future__ import annotations

from typing import Sequence

from rqt_mrta_py.hooks import RuleSetup
from rqt_mrta_py.supervisor.clocks.stamped_off import StampIncidents
from rqt_mrta_py.supervisor.clocks.words import span_text

__all__ = ["MessageFromTheFuture"]


class MessageFromTheFuture(StampIncidents):
    """Puts up a warning while all that a robot says on a monitored topic carries stamps from the future.

    How far counts is told by the topic's timeout: half of it, at least 0.5 s; how long, by the same. No message arrives
    before it was sent, so the robot's clock is ahead, by at least the figure that is told.

    Args:
        setup: not needed.
    """

    causes = (
        "The robot's clock is ahead of the clock of whoever received: nothing sets them to each other (NTP, chrony), "
        "or one was set by hand. Where years lie between: stamps of a simulated /clock beside receipts of wall time, "
        "or the other way round."
    )

    def __init__(self, setup: RuleSetup) -> None:
        super().__init__(ahead=True, text=_text)


def _text(robot: str, topics: Sequence[str], lead: float) -> str:
    return (
        f"{robot}'s clock is ahead: what it says on {' and '.join(topics)} is stamped up to {span_text(lead)} "
        "after it was received"
    )
