"""What the rules on stamps share: a robot is named once, from the first message to the last on any of its topics."""

from __future__ import annotations

from typing import Callable, Dict, Sequence

from rqt_mrta_py.hooks import ClockOff, ClockRight, Fact, Heard, IncidentBoard, Subscription
from rqt_mrta_py.model import Severity

__all__ = ["StampIncidents"]


class StampIncidents:
    """Puts up a warning for each robot whose stamps are off to one side, on however many topics.

    Args:
        ahead: whether to the side of the future.
        text: the sentence, of a robot, its topics in order, and the greatest lead of either sign so far [s].
    """

    causes: str

    def __init__(self, ahead: bool, text: Callable[[str, Sequence[str], float], str]) -> None:
        self._ahead = ahead
        self._text = text
        # By robot: its topics that were or are off, each with whether it still is; and the greatest lead.
        self._topics: Dict[str, Dict[str, bool]] = {}
        self._leads: Dict[str, float] = {}

    def subscriptions(self) -> Sequence[Subscription]:
        """Hear no message besides the facts."""
        return ()

    def hear(self, heard: Heard, board: IncidentBoard) -> None:
        """Take in nothing."""

    def wake(self, time: float, board: IncidentBoard) -> None:
        """Look at nothing."""

    def finish(self, time: float, board: IncidentBoard) -> None:
        """Leave what is open as it is."""

    def notice(self, fact: Fact, board: IncidentBoard) -> None:
        """Follow whose stamps are off."""
        if isinstance(fact, ClockOff):
            if (fact.lead > 0.0) is self._ahead:
                self._off(fact, board)
        elif isinstance(fact, ClockRight):
            self._right(fact, board)

    def _off(self, fact: ClockOff, board: IncidentBoard) -> None:
        robot = fact.robot
        topics = self._topics.setdefault(robot, {})
        is_new = fact.topic not in topics
        topics[fact.topic] = True
        self._leads[robot] = max(self._leads.get(robot, fact.lead), fact.lead, key=abs)
        text = self._text(robot, tuple(topics), self._leads[robot])
        evidence = [fact.first, fact.message] if is_new else []
        if len(topics) > 1 or not is_new:
            board.amend(robot, text, evidence)
        else:
            board.open(robot, Severity.WARNING, fact.first.stamp, text, robots=[robot], evidence=evidence)

    def _right(self, fact: ClockRight, board: IncidentBoard) -> None:
        topics = self._topics.get(fact.robot, {})
        if fact.topic not in topics:
            return
        topics[fact.topic] = False
        if not any(topics.values()):
            board.close(fact.robot, fact.time, evidence=[fact.message])
            del self._topics[fact.robot], self._leads[fact.robot]
