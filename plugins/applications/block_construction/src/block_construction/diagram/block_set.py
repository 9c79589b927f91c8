"""Blocks: their bodies, and the slots of the grid they lie in (Dantas 2017, section 5.1)."""

from __future__ import annotations

from typing import Iterable, NamedTuple, Tuple

from block_construction.errors import ConstructionError

__all__ = ["BODY_HEIGHT", "BODY_WIDTH", "DEFAULT_LENGTHS", "LONGEST", "PITCH", "BodySize", "block_lengths", "body_size"]

PITCH = 0.08
"""Edge of one cell of the grid [m]."""
BODY_WIDTH = 0.07
"""Of every block [m]."""
BODY_HEIGHT = 0.07
"""Of every block, and so the height from one level to the next in the finished structure [m]."""
_BODY_LENGTH = 0.06
"""Of a block's body, for each of its units [m]."""
DEFAULT_LENGTHS = (1, 2, 3)
"""Units of the blocks that the source's experiments have."""
LONGEST = 16
"""Units of the longest block that is accepted."""


class BodySize(NamedTuple):
    """Length, width and height of a block's body [m]; it is shorter than its slot, so that it can be put in."""

    length: float
    width: float
    height: float


def body_size(units: int) -> BodySize:
    """Give the body of a block of so many units; it lies in the middle of its slot."""
    return BodySize(_BODY_LENGTH * units, BODY_WIDTH, BODY_HEIGHT)


def block_lengths(given: Iterable[int]) -> Tuple[int, ...]:
    """Check a set of blocks.

    Args:
        given: units of the blocks that there are.

    Returns:
        The same, growing, each once.

    Raises:
        ConstructionError: a length is below 1 or above 16, or there is no block of one unit, without which not every
            structure can be covered.
    """
    lengths = tuple(sorted(set(given)))
    wrong = next((length for length in lengths if not 1 <= length <= LONGEST), None)
    if wrong is not None:
        raise ConstructionError(f"blocks of {wrong} units; accepted are 1 to {LONGEST}")
    if not lengths or lengths[0] != 1:
        found = ", ".join(map(str, lengths)) or "none"
        raise ConstructionError(f"blocks of {found} units; a block of 1 unit must be among them")
    return lengths
