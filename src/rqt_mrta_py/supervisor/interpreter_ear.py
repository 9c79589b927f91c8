"""The ear of an architecture's interpreter: what it answers to messages is handed on, and who fails is named."""

from __future__ import annotations

from typing import Callable, Optional, Sequence, Tuple, Union

from rqt_mrta_py.hooks import AllocationInterpreter, AllocationSign, Applicability, Heard, Subscription
from rqt_mrta_py.supervisor.failures import checked, failure

__all__ = ["InterpreterEar", "Sign"]

Sign = Union[AllocationSign, Applicability]


class InterpreterEar:
    """Hears what an interpreter wants to hear.

    Args:
        interpreter: reads the architecture's own signs.
        architecture: its package, for errors.
        enter: called with each message first; lets time pass up to it.
        take: takes each sign, and the message that gave it.
    """

    def __init__(
        self,
        interpreter: AllocationInterpreter,
        architecture: str,
        enter: Callable[[Heard], None],
        take: Callable[[Sign, Heard], None],
    ) -> None:
        self._interpreter = interpreter
        self._who = f"interpreter of {architecture}"
        self._enter = enter
        self._take = take

    def subscriptions(self) -> Sequence[Subscription]:
        """Say what to hear.

        Raises:
            HookError: the interpreter raises; names it.
        """
        try:
            return [checked("a wish", wish, Subscription) for wish in self._interpreter.subscriptions()]
        except Exception as error:
            raise failure(self._who, error, "subscribing") from error

    @property
    def last_matters(self) -> Optional[Sequence[Subscription]]:
        """Of which subscriptions the last of messages that repeat one another matters; None: each of all messages."""
        if getattr(self._interpreter, "repeats_matter", True):
            return None
        wishes: Sequence[Subscription] = getattr(self._interpreter, "last_matters", None) or self.subscriptions()
        return wishes

    def hear(self, heard: Heard) -> None:
        """Take in a message.

        Raises:
            HookError: the interpreter raises, or answers no signs; names it.
        """
        self._enter(heard)
        for sign in self._ask(heard):
            self._take(sign, heard)

    def hear_again(self, heard: Heard) -> None:
        """Take in a message that says what the one before it said, so that the answer is known.

        Raises:
            HookError: as for ``hear``.
        """
        self._ask(heard)

    def _ask(self, heard: Heard) -> Tuple[Sign, ...]:
        try:
            signs = tuple(self._interpreter.hear(heard))
            for sign in signs:
                if not isinstance(sign, Applicability):
                    checked("a sign", sign, AllocationSign)
        except Exception as error:
            raise failure(self._who, error, f"hearing {heard.topic}") from error
        return signs
