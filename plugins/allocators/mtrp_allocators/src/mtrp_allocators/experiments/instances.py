"""Random instances: robots and targets strewn evenly over a square of 100 m."""

from __future__ import annotations

from typing import TYPE_CHECKING, NamedTuple

import numpy as np

if TYPE_CHECKING:
    from numpy.typing import NDArray

__all__ = ["SIDE", "Instance", "random_instance"]

SIDE = 100.0
"""Of the square [m]."""


class Instance(NamedTuple):
    """Where robots start and where targets are.

    Attributes:
        robots: shape (robots, 2) [m].
        targets: shape (targets, 2) [m].
    """

    robots: NDArray[np.float64]
    targets: NDArray[np.float64]


def random_instance(robots: int, targets: int, seed: int) -> Instance:
    """Draw an instance; robots first, from a generator of its own for each size and seed.

    Args:
        robots: how many.
        targets: how many.
        seed: of this instance among those of its size.
    """
    generator = np.random.default_rng([robots, targets, seed])
    return Instance(generator.uniform(0.0, SIDE, (robots, 2)), generator.uniform(0.0, SIDE, (targets, 2)))
