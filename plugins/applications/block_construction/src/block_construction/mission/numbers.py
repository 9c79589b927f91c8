"""How numbers are written in files that are made: short, and the same everywhere."""

from __future__ import annotations

from typing import Iterable

__all__ = ["listed", "number"]

_DIGITS = 6


def number(value: float) -> str:
    """Write a number to six digits behind the point, without zeros at the end.

    Args:
        value: finite.
    """
    rounded = round(value, _DIGITS)
    # Rounding may leave a negative zero.
    return repr(rounded + 0.0) if abs(rounded) >= 1e-4 or not rounded else f"{rounded:.6f}"


def listed(values: Iterable[float]) -> str:
    """Write a list of numbers; whole ones as such."""
    return f"[{', '.join(str(value) if isinstance(value, int) else number(value) for value in values)}]"
