"""Spans of time in words."""

from __future__ import annotations

__all__ = ["span_text"]

_UNITS = ((365.25 * 86400.0, "years"), (86400.0, "days"), (3600.0, "h"), (60.0, "min"))
_ENOUGH = 2.0


def span_text(seconds: float) -> str:
    """Write down a span of time.

    Args:
        seconds: how long, at least 0 [s].

    Returns:
        One decimal, in the largest unit of which there are two at least.
    """
    for length, unit in _UNITS:
        if seconds >= _ENOUGH * length:
            return f"{seconds / length:.1f} {unit}"
    return f"{seconds:.1f} s"
