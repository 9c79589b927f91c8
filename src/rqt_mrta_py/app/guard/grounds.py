"""A reader of grounds that never stops the review for which it reads."""

from __future__ import annotations

from typing import Callable, List, Optional, Sequence

from rqt_mrta_py.app.guard.asking import guarded, wishes_of
from rqt_mrta_py.errors import HookError, MrtaError
from rqt_mrta_py.hooks import GroundsReader, Heard, Subscription
from rqt_mrta_py.hooks.answers import json_breach
from rqt_mrta_py.hooks.patience import Patience
from rqt_mrta_py.model import Ground
from rqt_mrta_py.wording import shown

__all__ = ["GuardedGrounds"]


class GuardedGrounds:
    """A reader of grounds that hears no more once it has failed; what it said before counts.

    Args:
        who: names it, for instance ``grounds reader of x``.
        make: makes it.
        patience: how long it may take.
        receive: is given what it says.

    Attributes:
        failure: what went wrong with it, in a line that names it; empty if nothing did.
    """

    def __init__(
        self, who: str, make: Callable[[], GroundsReader], patience: Patience, receive: Callable[[Ground], None]
    ) -> None:
        self.failure = ""
        self._who = who
        self._patience = patience
        self._receive = receive
        self._reader: Optional[GroundsReader] = None
        self._wishes: List[Subscription] = []
        try:
            with patience.limit(who):
                self._reader = make()
                self._wishes = wishes_of(who, self._reader)
        except MrtaError as error:
            self._give_up(error)

    def subscriptions(self) -> List[Subscription]:
        """Say what to hear; nothing if the reader cannot say it."""
        return self._wishes

    def hear(self, heard: Heard) -> None:
        """Take in one message."""
        if self._reader is None:
            return
        try:
            with self._patience.limit(self._who):
                grounds = _checked(self._who, guarded(self._who, self._reader.hear, heard))
        except MrtaError as error:
            self._give_up(error)
            return
        for ground in grounds:
            self._receive(ground)

    def _give_up(self, error: MrtaError) -> None:
        self._reader = None
        self.failure = str(error)


def _checked(who: str, answer: object) -> Sequence[Ground]:
    if isinstance(answer, tuple) and not answer:
        return ()
    if not isinstance(answer, (list, tuple)):
        raise HookError(f"{who}: answers {shown(answer)}; a sequence of Grounds is needed")
    for ground in answer:
        if not isinstance(ground, Ground):
            raise HookError(f"{who}: answers {shown(ground)}; a Ground is needed")
        texts = (ground.task, ground.text, ground.robot)
        if not all(isinstance(text, str) for text in texts) or not isinstance(ground.time, (int, float)):
            raise HookError(f"{who}: answers {shown(ground)}; a time and texts are needed")
        breach = json_breach([ground.time, {**guarded(who, dict, ground.values)}])
        if breach is not None:
            raise HookError(f"{who}: of a Ground of {shown(ground.task)} {breach}")
    return answer
