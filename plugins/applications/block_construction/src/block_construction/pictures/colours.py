"""Colours of blocks by their length."""

from __future__ import annotations

from typing import Iterable, Tuple

from rqt_mrta_py.hooks import Tint

__all__ = ["block_key", "block_tint"]

_COLOURS = (3, 0, 1, 4, 2)
"""Light blue, blue, vermilion, orange and purple for blocks of one, two, ... units; after the last the first again."""


def block_tint(units: int, lightness: float = 0.0) -> Tint:
    """Give the colour of blocks of a length."""
    return Tint(_COLOURS[(units - 1) % len(_COLOURS)], lightness)


def block_key(lengths: Iterable[int], lightness: float = 0.0) -> Tuple[Tuple[Tint, str], ...]:
    """Say which colour blocks of which length have."""
    return tuple((block_tint(units, lightness), f"{units} unit{'s' * (units > 1)}") for units in lengths)
