"""Tells from what DEMiR-CF robots say why one of them let a task go."""

from __future__ import annotations

from typing import Dict, List, Mapping, Optional, Sequence, Tuple, Union

from mrta_demir_cf.message_kinds import SUBSCRIPTIONS, CancelReason, Kind, WarnedState
from mrta_demir_cf.messages import Message, read_message
from rqt_mrta_py.hooks import AllocationSign, Applicability, Heard, InterpreterSetup, Subscription
from rqt_mrta_py.model import Outcome

__all__ = ["REASONS", "DemirCfInterpreter"]

REASONS: Mapping[CancelReason, Tuple[Outcome, str]] = {
    CancelReason.DEARER_REQUEST: (Outcome.YIELDED, "another requested a task at less (path)"),
    CancelReason.DEARER_NEIGHBOUR: (Outcome.YIELDED, "another requested a task near by at less (time)"),
    CancelReason.CHANGED_SCHEDULE: (Outcome.GAVE_UP, "no longer possible"),
    CancelReason.IMPROVED: (Outcome.PREEMPTED, "another task is nearer"),
    CancelReason.PARALLEL: (Outcome.YIELDED, "another carries it out at less"),
    CancelReason.HANDED_OVER: (Outcome.YIELDED, "another requested it at less"),
    CancelReason.AWARD_REFUSED: (Outcome.YIELDED, "refused"),
    CancelReason.FAILURE: (Outcome.FAILED, "it was away"),
    CancelReason.OPERATOR: (Outcome.PREEMPTED, "recalled by an operator"),
}
"""What the reason of a cancellation makes of an allocation, and how it is said."""


class DemirCfInterpreter:
    """Reads all that robots say to one another.

    A robot holds a task from its first execution message on. A robot that has been told that a task is over stops
    without a word; its next message, whatever it says, shows it.

    Args:
        setup: not needed; robots and tasks need not be known beforehand.
    """

    def __init__(self, setup: InterpreterSetup) -> None:
        self._held: Dict[str, str] = {}
        self._told_over: Dict[str, str] = {}

    def subscriptions(self) -> Sequence[Subscription]:
        """Say what to hear: all that robots say to one another."""
        return SUBSCRIPTIONS

    def hear(self, heard: Heard) -> Sequence[Union[AllocationSign, Applicability]]:
        """Answer what a robot still holds, how its time with a task ended, or whether a task can be reached."""
        message = read_message(heard)
        if isinstance(message, str):
            return ()
        if message.kind is Kind.WARNING and message.state in (WarnedState.COMPLETED, WarnedState.UNACHIEVABLE):
            self._told_over[message.recipient] = message.task
            return ()
        held = self._held.get(message.robot)
        signs: List[Union[AllocationSign, Applicability]] = []
        if held is not None:
            ending = self._ending(message, held)
            if ending is not None:
                del self._held[message.robot]
                signs.append(AllocationSign(message.robot, held, *ending))
        if message.kind in (Kind.UNACHIEVABILITY, Kind.NEW_TASK):
            # What one robot has found to be out of reach, or within it again, all others believe.
            signs.append(Applicability("", message.task, message.kind is Kind.NEW_TASK))
        if message.kind is Kind.EXECUTION:
            self._held[message.robot] = message.task
            signs.append(AllocationSign(message.robot, message.task))
        return signs

    def _ending(self, message: Message, held: str) -> Optional[Tuple[Outcome, str]]:
        """Tell how a message ends its sender's time with a task; None if it does not."""
        if message.task == held:
            if message.kind is Kind.COMPLETION:
                return Outcome.DONE, ""
            if message.kind is Kind.UNACHIEVABILITY:
                return Outcome.FAILED, "it cannot get there"
            if message.kind is Kind.AWARD:
                return Outcome.PREEMPTED, f"awarded to {message.winner}"
            if message.kind is Kind.CANCELLATION:
                known = REASONS.get(message.reason) if message.reason is not None else None
                return known or (Outcome.GAVE_UP, "without a reason")
            if message.kind is not Kind.REQUEST:
                return None
        elif message.kind not in (Kind.REQUEST, Kind.EXECUTION, Kind.HELLO):
            return None
        if self._told_over.get(message.robot) == held:
            return Outcome.YIELDED, "another had ended it"
        return Outcome.GAVE_UP, "without a reason"
