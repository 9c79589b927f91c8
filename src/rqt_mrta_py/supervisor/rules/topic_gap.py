"""Rule: a robot that has spoken regularly on a topic says nothing there."""

from __future__ import annotations

from typing import Dict, Optional, Sequence, Set, Tuple

from rqt_mrta_py.hooks import (
    AllocationEnded,
    Fact,
    Heard,
    IncidentBoard,
    RobotHeard,
    RobotSilent,
    RuleSetup,
    Subscription,
    TopicHeard,
    TopicSilent,
)
from rqt_mrta_py.model import Outcome, Severity
from rqt_mrta_py.supervisor.agenda import due_after
from rqt_mrta_py.supervisor.clocks.words import span_text
from rqt_mrta_py.supervisor.topics import Topics

__all__ = ["TopicGap"]

_Key = Tuple[str, str]
"""Robot and topic."""


class TopicGap:
    """Puts up a warning from the last message to the next on an idle topic on which the robot used to speak regularly.

    A gap is longer than the topic's timeout, and than three times the usual period. It is judged when it ends, or when
    it has lasted by so much longer as a robot may be silent altogether: then it is known whether the robot is. One that
    is lost with its task is told of by ``robot_silent_with_task``, and not here as well. So a gap with which the stream
    ends counts only if it was judged by then: nodes that are shut down one after the other leave such gaps.

    Args:
        setup: the architecture says how long a robot may be silent.
    """

    causes = (
        "The node hangs, has died or was restarted, or its computer was overloaded; or the receiver was, or was out of "
        "the robot's reach, which leaves gaps on all topics at once."
    )

    def __init__(self, setup: RuleSetup) -> None:
        self._silence = Topics(setup.mission.architecture).silence
        self._start: Optional[float] = None
        self._silent: Set[str] = set()
        self._lost: Set[str] = set()
        self._unjudged: Dict[_Key, TopicSilent] = {}
        self._sentences: Dict[_Key, str] = {}

    def subscriptions(self) -> Sequence[Subscription]:
        """Hear no message besides the facts."""
        return ()

    def hear(self, heard: Heard, board: IncidentBoard) -> None:
        """Take in nothing."""

    def wake(self, time: float, board: IncidentBoard) -> None:
        """Judge gaps that have lasted long enough; at first remember when the stream began [s]."""
        if self._start is None:
            self._start = time
        for fact in [fact for fact in self._unjudged.values() if self._due(fact) <= time]:
            self._judge(fact, board)

    def finish(self, time: float, board: IncidentBoard) -> None:
        """Leave what is open as it is."""

    def notice(self, fact: Fact, board: IncidentBoard) -> None:
        """Follow who is silent, where, and who was lost with a task."""
        if isinstance(fact, TopicSilent):
            self._unjudged[fact.robot, fact.topic] = fact
            board.wake_at(self._due(fact))
        elif isinstance(fact, TopicHeard):
            self._end(fact, board)
        elif isinstance(fact, RobotSilent):
            self._silent.add(fact.robot)
        elif isinstance(fact, RobotHeard):
            self._silent.discard(fact.robot)
            if fact.robot in self._lost:
                self._lost.discard(fact.robot)
                for key in [key for key in self._unjudged if key[0] == fact.robot]:
                    del self._unjudged[key]
        elif isinstance(fact, AllocationEnded) and fact.outcome is Outcome.LOST:
            self._lost.add(fact.robot)

    def _due(self, fact: TopicSilent) -> float:
        return due_after(fact.time, self._silence)

    def _judge(self, fact: TopicSilent, board: IncidentBoard) -> None:
        key = fact.robot, fact.topic
        del self._unjudged[key]
        if fact.robot in self._lost:
            return
        since = self._since_start(fact.last.stamp)
        if fact.robot in self._silent:
            text = f"{fact.robot} fell silent on all its topics at {since}"
        else:
            text = f"{fact.robot} fell silent on {fact.topic} at {since}, though it is heard on others"
        text += (
            f"; it used to be heard every {span_text(fact.period) if fact.period >= 1.0 else f'{fact.period:.2g} s'}"
        )
        self._sentences[key] = text
        board.open(_text_of(key), Severity.WARNING, fact.last.stamp, text, robots=[fact.robot], evidence=[fact.last])

    def _end(self, fact: TopicHeard, board: IncidentBoard) -> None:
        key = fact.robot, fact.topic
        unjudged = self._unjudged.get(key)
        if unjudged is not None:
            self._judge(unjudged, board)
        text = self._sentences.pop(key, None)
        if text is not None:
            text = f"{text}; heard again at {self._since_start(fact.time)}"
            board.close(_text_of(key), fact.time, text, [fact.message])

    def _since_start(self, time: float) -> str:
        return f"{time - (self._start or 0.0):.1f} s"


def _text_of(key: _Key) -> str:
    # Ids of foreign bags may hold any character, so none of them can stand between the two.
    return f"{len(key[0])} {key[0]} {key[1]}"
