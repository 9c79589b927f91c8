"""Codes of cells: which part of which block lies there (Dantas 2017, section 5.3)."""

from __future__ import annotations

from typing import Dict, FrozenSet, Iterable, Tuple

from rqt_mrta_py.hooks import BlockPlacement, Voxel

__all__ = ["FAULTS", "cell_codes", "codes_of"]

_MIDDLE, _LEFT, _RIGHT, _SINGLE, _LOWER, _UPPER = 1, 2, 3, 4, 5, 6

FAULTS: FrozenSet[Tuple[int, int]] = frozenset(
    [(code, code) for code in (_LEFT, _RIGHT, _SINGLE, _LOWER, _UPPER)]
    + [(_SINGLE, end) for end in (_LEFT, _RIGHT, _LOWER, _UPPER)]
    + [(end, _SINGLE) for end in (_LEFT, _RIGHT, _LOWER, _UPPER)]
)
"""Codes of a cell and of the one above it that are a connection fault: block ends that coincide (equation 5.4)."""


def codes_of(length: int) -> Tuple[int, ...]:
    """Give the codes of a block's cells, from its first cell on.

    Args:
        length: signed: above 0 along x, below 0 along y.

    Returns:
        Of a block along x 2, 1 ..., 3; along y 5, 1 ..., 6; of one unit 4.
    """
    units = abs(length)
    if units == 1:
        return (_SINGLE,)
    first, last = (_LEFT, _RIGHT) if length > 0 else (_LOWER, _UPPER)
    return (first, *(_MIDDLE,) * (units - 2), last)


def cell_codes(placements: Iterable[BlockPlacement]) -> Dict[Voxel, int]:
    """Give the code of each covered cell."""
    return {cell: code for each in placements for cell, code in zip(each.cells(), codes_of(each.length))}
