"""Words that messages of every room share: the value received, and what would have been accepted."""

from __future__ import annotations

from difflib import get_close_matches
from typing import Iterable, Optional

__all__ = ["accepted", "nearest", "printable", "shown"]

_LONGEST = 60
_MOST = 12


def nearest(name: str, known: Iterable[str]) -> Optional[str]:
    """Find the known name that a mistyped one probably means.

    Args:
        name: as received.
        known: what would have been accepted.

    Returns:
        The closest of the known names; None if none comes close.
    """
    matches = get_close_matches(name[:_LONGEST], list(known), n=1, cutoff=0.6)
    return matches[0] if matches else None


def accepted(name: str, known: Iterable[str]) -> str:
    """Say what is accepted instead of an unknown name.

    Args:
        name: as received.
        known: what would have been accepted, in the order to be shown.

    Returns:
        ``nearest is 'x'``, or the names accepted where none comes close.
    """
    names = list(known)
    match = nearest(name, names)
    if match is not None:
        return f"nearest is {match!r}"
    if not names:
        return "there is none"
    rest = f" and {len(names) - _MOST} more" if len(names) > _MOST else ""
    return f"accepted: {', '.join(names[:_MOST])}{rest}"


def shown(value: object) -> str:
    """Quote a value as received, in one line, cut where it is long."""
    text = repr(value)
    if "\n" in text:
        text = " ".join(text.split())
    return text if len(text) <= _LONGEST else f"{text[:_LONGEST]}..."


def printable(text: str, kept: str = "") -> str:
    r"""Write a text so that a terminal shows it and obeys nothing in it: a name from a bag may hold commands.

    Args:
        text: as received.
        kept: characters that stand as they are though they are no printable ones, for instance the ends of lines.

    Returns:
        The text with whatever is not printable (``str.isprintable``) escaped as Python does: ``\x1b``, ``\u202e``.
    """
    if text.isprintable():
        return text
    return "".join(
        character
        if character.isprintable() or character in kept
        else character.encode("unicode_escape").decode("ascii")
        for character in text
    )
