"""Failures of plugins that take part in supervision: one sentence that says whose it is."""

from __future__ import annotations

from typing import TypeVar

from rqt_mrta_py.errors import HookError

__all__ = ["checked", "failure"]

_Value = TypeVar("_Value")


def checked(what: str, value: _Value, wanted: type) -> _Value:
    """Give a plugin's answer back if it is of a type.

    Raises:
        TypeError: it is not; says what was answered and what is accepted.
    """
    if not isinstance(value, wanted):
        raise TypeError(f"{what} is {value!r}; accepted is {wanted.__name__}")
    return value


def failure(who: str, error: Exception, doing: str = "") -> HookError:
    """Say whose failure an exception is; to be raised ``from`` it.

    Args:
        who: the plugin's part, for instance ``incident rule x``.
        error: what it raised.
        doing: what it was asked to do; empty if there is just one thing that it can do.
    """
    return HookError(f"{who}: {type(error).__name__}: {error}{f', {doing}' if doing else ''}")
