"""Rule: a robot falls silent on all its topics while it holds a task."""

from __future__ import annotations

from typing import Dict, List, Sequence, Tuple

from rqt_mrta_py.hooks import (
    AllocationEnded,
    AllocationStarted,
    Fact,
    Heard,
    IncidentBoard,
    RobotHeard,
    RobotSilent,
    RuleSetup,
    Subscription,
)
from rqt_mrta_py.model import Evidence, Outcome, Severity

__all__ = ["RobotSilentWithTask"]


class RobotSilentWithTask:
    """Puts up an error from the last message of a lost robot until it is heard again, and says who took over.

    Who takes over is the architecture's business; that nobody does is what to worry about.

    Fires: when a robot that holds a task says nothing on any topic for as long as a message on its busy and idle topics
    counts at most, and at least 2 s. One incident for each task that it held; it lasts from its last message until the
    robot is heard again.

    Does not fire: for a robot that holds nothing; for one that is silent about its task, but heard on some other topic.

    Args:
        setup: not needed.
    """

    causes = "The robot's computer, battery or radio has failed, its nodes were stopped, or it is out of reach."

    def __init__(self, setup: RuleSetup) -> None:
        self._start = 0.0
        self._last: Dict[str, Evidence] = {}
        self._holders: Dict[str, List[str]] = {}
        self._sentences: Dict[Tuple[str, str], str] = {}
        self._orphans: Dict[str, List[str]] = {}

    def subscriptions(self) -> Sequence[Subscription]:
        """Hear no message besides the facts."""
        return ()

    def hear(self, heard: Heard, board: IncidentBoard) -> None:
        """Take in nothing."""

    def wake(self, time: float, board: IncidentBoard) -> None:
        """Remember when the stream began [s]; sentences count from there."""
        self._start = time

    def finish(self, time: float, board: IncidentBoard) -> None:
        """Leave what is open as it is."""

    def notice(self, fact: Fact, board: IncidentBoard) -> None:
        """Follow who is silent, who was lost with a task, and who takes that task next."""
        if isinstance(fact, RobotSilent):
            self._last[fact.robot] = fact.last
        elif isinstance(fact, RobotHeard):
            self._return(fact, board)
        elif isinstance(fact, AllocationStarted):
            self._take_over(fact, board)
        elif isinstance(fact, AllocationEnded):
            self._holders[fact.task].remove(fact.robot)
            if fact.outcome is Outcome.LOST:
                self._lose(fact, board)

    def _lose(self, fact: AllocationEnded, board: IncidentBoard) -> None:
        last = self._last.get(fact.robot, fact.last)
        text = f"{fact.robot} fell silent while it held {fact.task}, last heard at {self._since_start(last.stamp)}"
        others = self._holders[fact.task]
        if others:
            text += f"; {' and '.join(others)} held it too"
        else:
            self._orphans.setdefault(fact.task, []).append(fact.robot)
        self._sentences[fact.robot, fact.task] = text
        board.open(
            key=_key(fact.robot, fact.task),
            severity=Severity.ERROR,
            start=max(last.stamp, self._start),
            text=text if others else f"{text}; nobody has taken over",
            robots=[fact.robot],
            tasks=[fact.task],
            evidence=[fact.last, last],
        )

    def _take_over(self, fact: AllocationStarted, board: IncidentBoard) -> None:
        self._holders.setdefault(fact.task, []).append(fact.robot)
        for lost in self._orphans.pop(fact.task, ()):
            if (lost, fact.task) in self._sentences:
                text = f"{self._sentences[lost, fact.task]}; {fact.robot} took over at {self._since_start(fact.time)}"
                self._sentences[lost, fact.task] = text
                board.amend(_key(lost, fact.task), text, [fact.message])

    def _return(self, fact: RobotHeard, board: IncidentBoard) -> None:
        for robot, task in [pair for pair in self._sentences if pair[0] == fact.robot]:
            text = f"{self._sentences.pop((robot, task))}; heard again at {self._since_start(fact.time)}"
            board.close(_key(robot, task), fact.time, text, [fact.message])

    def _since_start(self, time: float) -> str:
        return f"{time - self._start:.1f} s"


def _key(robot: str, task: str) -> str:
    # Ids of foreign bags may hold any character, so none of them can stand between the two.
    return f"{len(robot)} {robot} {task}"
