"""Picking what belongs to some robots of many, which mostly are all of them."""

from __future__ import annotations

from typing import TYPE_CHECKING, Tuple, TypeVar

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

__all__ = ["picked"]

_Thing = TypeVar("_Thing")


def picked(things: Tuple[_Thing, ...], places: NDArray[np.intp]) -> Tuple[_Thing, ...]:
    """Pick things by their places.

    Args:
        things: one for each robot.
        places: rising, each once.

    Returns:
        As many as there are places; the very tuple that was given where all are picked.
    """
    return things if len(things) == places.size else tuple([things[place] for place in places.tolist()])
