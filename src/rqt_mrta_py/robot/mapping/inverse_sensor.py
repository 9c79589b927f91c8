"""What one look of a range finder says of one cell, and how looks add up.

Of a cell with the probability p of being occupied the log-odds are l = ln(p / (1 - p)): 0 where nothing is known. Looks
are taken to be independent given the map (Moravec and Elfes 1985), so that their log-odds are added (Thrun, Burgard,
Fox, Probabilistic Robotics, chapter 9). The sum is bounded, so that what has been seen a thousand times can still be
unlearnt (the clamping update of Yguel et al. 2008; bounds and evidence are those of OctoMap, Hornung et al. 2013).
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

if TYPE_CHECKING:
    from numpy.typing import NDArray

__all__ = ["InverseSensor", "log_odds", "probability", "updated"]


@dataclass(frozen=True)
class InverseSensor:
    """How much a look tells, as log-odds.

    Attributes:
        hit: of a cell in which a ray ended, above 0; 0.85 is a probability of 0.70.
        passed: of a cell that a ray passed through, below 0; -0.4 is 0.40.
        lowest: of a cell, however often it was passed, below 0; -2 is 0.12.
        highest: of a cell, however often it was hit, above 0; 3.5 is 0.97.

    Raises:
        ValueError: a value is not on its side of 0; names it.
    """

    hit: float = 0.85
    passed: float = -0.4
    lowest: float = -2.0
    highest: float = 3.5

    def __post_init__(self) -> None:
        for name, side in (("hit", 1.0), ("passed", -1.0), ("lowest", -1.0), ("highest", 1.0)):
            value = getattr(self, name)
            if not (math.isfinite(value) and value * side > 0.0):
                raise ValueError(
                    f"{name}: must be a finite number {'above' if side > 0.0 else 'below'} 0 (got {value!r})"
                )


def log_odds(chance: float) -> float:
    """Give the log-odds of a probability between 0 and 1, both not included."""
    return math.log(chance / (1.0 - chance))


def probability(odds: float) -> float:
    """Give the probability of log-odds."""
    return 1.0 / (1.0 + math.exp(-odds))


def updated(odds: NDArray[np.float32], evidence: float, lowest: float, highest: float) -> NDArray[np.float32]:
    """Add the evidence of one look to cells: l' = min(max(l + evidence, lowest), highest).

    Args:
        odds: log-odds of the cells before the look, shape (cells,).
        evidence: log-odds of the inverse sensor model.
        lowest: bound of the sum.
        highest: bound of the sum.

    Returns:
        Log-odds after the look, shape (cells,).
    """
    after: NDArray[np.float32] = np.clip(odds + np.float32(evidence), np.float32(lowest), np.float32(highest))
    return after
