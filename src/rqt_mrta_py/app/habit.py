"""How the messages of one connection are heard, for whoever need not take in all of them."""

from __future__ import annotations

from typing import NamedTuple, Optional, Tuple

from rqt_mrta_py.transport.routes import MetWish

__all__ = ["Habit", "is_stamp"]


class Habit(NamedTuple):
    """How the messages of a connection are heard.

    Attributes:
        at_once: each must be taken in before any that follows, on whatever topic.
        each: somebody wants to hear each, though it says nothing new to the supervisor.
        wakes: whoever does is a rule, which may ask to be woken.
        timed: the supervisor holds receipts, and stamps if there are any, against one another.
        said: fields that must differ for it to say anything new; None if it says nothing but that its robot is heard.
        again: what the interpreter hears, of the last message before anything changes too.
    """

    at_once: bool
    each: bool
    wakes: bool
    timed: bool
    said: Optional[Tuple[str, ...]]
    again: Tuple[MetWish, ...]


def is_stamp(path: str) -> bool:
    """Tell whether a field says when a message was sent, in which all messages differ."""
    return path.rsplit("/", maxsplit=1)[-1] == "stamp"
