"""What a plugin's part raises where its answer is needed, told with whose part it is."""

from __future__ import annotations

from typing import Any, Callable, Dict, List, Mapping, TypeVar

from rqt_mrta_py.errors import HookError, MrtaError
from rqt_mrta_py.hooks import Subscription
from rqt_mrta_py.wording import shown

__all__ = ["guarded", "made", "makers", "wishes_of"]

_Answer = TypeVar("_Answer")


def guarded(who: str, ask: Callable[..., _Answer], *arguments: Any) -> _Answer:
    """Ask a plugin's part.

    Args:
        who: names it, for instance ``monitor panel x``.
        ask: what to call.
        arguments: to call it with.

    Returns:
        Its answer.

    Raises:
        HookError: it raised; says who and what. Errors that already speak to the user pass as they are, and so does
            that the reader of a pipe has gone.
    """
    try:
        return ask(*arguments)
    except (MrtaError, BrokenPipeError):
        raise
    except Exception as error:
        raise HookError(f"{who}: {type(error).__name__}: {error}") from error


def made(who: str, factory: Callable[[Any], Any], setup: object, *needs: str) -> Any:
    """Let a plugin make a part.

    Args:
        who: names the part.
        factory: makes it.
        setup: what it is made from.
        needs: methods and properties that the part must have.

    Returns:
        The part.

    Raises:
        HookError: the factory raised, or made what is no such part.
    """
    part = guarded(who, factory, setup)
    for need in needs:
        if not guarded(who, hasattr, part, need):
            raise HookError(f"{who}: made {shown(part)}, which has no {need!r}")
    return part


def makers(kind: str, factories: Mapping[str, Callable[..., Any]], *needs: str) -> Dict[str, Callable[..., Any]]:
    """Give factories that check what they make, for whoever makes parts out of our sight.

    Args:
        kind: of the parts, for instance ``sensor``.
        factories: by name.
        needs: as for ``made``.
    """

    def maker(name: str, factory: Callable[..., Any]) -> Callable[..., Any]:
        return lambda *setup: made(f"{kind} {name}", lambda _: factory(*setup), None, *needs)

    return {name: maker(name, factory) for name, factory in factories.items()}


def wishes_of(who: str, listener: Any) -> List[Subscription]:
    """Ask a plugin's part what it wants to hear.

    Raises:
        HookError: it raised, or answers anything but subscriptions.
    """
    return guarded(who, lambda: [_wish(wish) for wish in listener.subscriptions()])


def _wish(wish: object) -> Subscription:
    if not (isinstance(wish, Subscription) and isinstance(wish.topic, str) and isinstance(wish.type, str)):
        raise TypeError(f"wants to hear {shown(wish)}; a Subscription is needed")
    if not isinstance(wish.fields, tuple):
        raise TypeError(f"wants to hear {shown(wish)}; its fields must be a tuple of paths")
    return wish
