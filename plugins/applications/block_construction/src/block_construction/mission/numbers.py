"""How numbers are written in files that are made: short, and the same everywhere."""

from __future__ import annotations

from typing import Iterable

__all__ = ["listed", "number"]

_DIGITS = 6
_WHOLE = 1e16
"""Floats from here on are written with an exponent, which YAML reads as text."""


def number(value: float) -> str:
    """Write a number to six digits behind the point, without zeros at the end.

    Args:
        value: finite.
    """
    rounded = round(value, _DIGITS)
    # Rounding may leave a negative zero.
    if not rounded or 1e-4 <= abs(rounded) < _WHOLE:
        return repr(rounded + 0.0)
    return f"{rounded:.6f}" if abs(rounded) < 1.0 else f"{rounded:.1f}"


def listed(values: Iterable[float]) -> str:
    """Write a list of numbers; whole ones as such."""
    return f"[{', '.join(str(value) if isinstance(value, int) else number(value) for value in values)}]"
