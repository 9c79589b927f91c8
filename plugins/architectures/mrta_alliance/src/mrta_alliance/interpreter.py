"""Tells from what ALLIANCE robots say why one of them let a task go.

Robots publish their motivations all the time, and in them whether a behaviour set is active and what just moved it.
Works alike on our agents and on the original nodes.
"""

from __future__ import annotations

from typing import Dict, List, Mapping, Sequence, Set, Tuple, Union

from mrta_alliance.messages import COMMUNICATION_TOPIC, COMMUNICATION_TYPE, MOTIVATION_TOPICS, MOTIVATION_TYPE
from rqt_mrta_py.hooks import AllocationSign, Applicability, Heard, InterpreterSetup, Subscription
from rqt_mrta_py.model import Outcome, normalise_id

__all__ = ["AllianceInterpreter"]

# As long as one announcement keeps a robot busy in rqt_mrta.xml.
_ANNOUNCED_FOR = 2.0

_SUBSCRIPTIONS = (
    Subscription(
        MOTIVATION_TOPICS,
        MOTIVATION_TYPE,
        ("header/frame_id", "task_id", "acquiescent", "suppressed", "resetted", "applicable", "active"),
    ),
    Subscription(COMMUNICATION_TOPIC, COMMUNICATION_TYPE, ("header/frame_id", "task_id")),
)


class AllianceInterpreter:
    """Reads Motivation messages, and announcements for who else is on a task."""

    # What a message says of one robot and one task holds until another one says it differently.
    repeats_matter = False
    # Who announced what when is remembered; what motivations say counts whenever it was said.
    last_matters = (_SUBSCRIPTIONS[1],)

    def __init__(self, setup: InterpreterSetup) -> None:
        """Start knowing nothing; robots and tasks need not be known beforehand."""
        self._holding: Set[Tuple[str, str]] = set()
        self._inapplicable: Set[Tuple[str, str]] = set()
        self._announced: Dict[str, Dict[str, float]] = {}

    def subscriptions(self) -> Sequence[Subscription]:
        """Say what to hear: all robots' motivations and announcements."""
        return _SUBSCRIPTIONS

    def hear(self, heard: Heard) -> Sequence[Union[AllocationSign, Applicability]]:
        """Answer whether a robot still holds a task, how its time with it ended, or whether it could take it."""
        robot = normalise_id(heard.fields["header/frame_id"])
        task = heard.fields["task_id"]
        if heard.topic == COMMUNICATION_TOPIC:
            self._announced.setdefault(task, {})[robot] = heard.receipt
            return ()
        key = (robot, task)
        if heard.fields["active"]:
            self._holding.add(key)
            return (AllocationSign(robot, task),)
        applicable = heard.fields["applicable"]
        if key not in self._holding and applicable is (key not in self._inapplicable):
            return ()
        signs: List[Union[AllocationSign, Applicability]] = []
        if key in self._holding:
            self._holding.remove(key)
            outcome, text = self._ending(robot, task, heard.receipt, heard.fields)
            signs.append(AllocationSign(robot, task, outcome, text))
        if applicable is (key in self._inapplicable):
            (self._inapplicable.discard if applicable else self._inapplicable.add)(key)
            signs.append(Applicability(robot, task, applicable))
        return tuple(signs)

    def _ending(self, robot: str, task: str, now: float, fields: Mapping[str, bool]) -> Tuple[Outcome, str]:
        if fields["acquiescent"]:
            others = sorted(
                other
                for other, receipt in self._announced.get(task, {}).items()
                if other != robot and receipt > now - _ANNOUNCED_FOR
            )
            if others:
                return Outcome.YIELDED, f"acquiescent: yields to {', '.join(others)}"
            return Outcome.GAVE_UP, "acquiescent: nobody else is on the task"
        if not fields["applicable"]:
            return Outcome.FAILED, "no longer applicable"
        if fields["resetted"]:
            return Outcome.PREEMPTED, "reset by another robot's first announcement"
        if fields["suppressed"]:
            return Outcome.PREEMPTED, "suppressed by another behaviour set"
        return Outcome.GAVE_UP, "no longer active, without a reason"
