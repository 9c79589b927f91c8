"""What a target of its rough schedule costs a robot: EYH (Eq. 2) and UEM (Eq. 3).

S. Sariel, N. Erdogan, T. Balch, Incremental task selection and allocation for the real-world multiple travelling robot
problem, 2007. Letters of the paper: c_ji cost of target t_i for robot r_j, (b1, b2) the farthest pair in the rough
schedule, L = dist(b1, b2), alpha the weight of the distance.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Callable

import numpy as np

from mrta_demir_cf.planning.arrays import Floats, squared_distances
from mrta_demir_cf.planning.farthest_pair import farthest_pair

__all__ = ["ALPHA", "CostFunction", "FarthestAddition", "eyh_cost", "uem_cost"]

CostFunction = Callable[[Floats, Floats], Floats]
"""From the robot's distances to the targets of its schedule [m], (k,), and their places [m], (k, 2), to costs (k,)."""

ALPHA = 0.6
"""The weight of the distance that the paper found best."""


def eyh_cost(distances: Floats, targets: Floats) -> Floats:
    """Let the nearest target be the cheapest (EYH, Eq. 2).

        c_ji = dist(r_j, t_i)

    Args:
        distances: of the robot to the targets of its schedule, (k,) [m].
        targets: their places, (k, 2) [m], frame map.

    Returns:
        Costs, (k,) [m].
    """
    return distances


@dataclass(frozen=True)
class FarthestAddition:
    """The farthest-addition cost (UEM, Eq. 3).

        c_ji = alpha dist(r_j, t_i) + (1 - alpha) [ L - max(dist(t_i, b1), dist(t_i, b2)) ]

    The pair has to be covered in any case, so targets at the rim of the cell are drawn forward and inner ones pay.
    The robot's own place takes no part in the search of the pair. With alpha = 1 this is EYH.

    Differs from the paper: it leaves open what holds without a pair; for less than two targets the bracket is 0.

    Attributes:
        alpha: weight of the distance, 0 to 1.
    """

    alpha: float = ALPHA

    def __post_init__(self) -> None:
        if not 0.0 <= self.alpha <= 1.0:
            raise ValueError(f"alpha: is {self.alpha}; give a weight, 0 <= alpha <= 1")

    def __call__(self, distances: Floats, targets: Floats) -> Floats:
        """Give the costs of targets, see ``CostFunction``."""
        return self.alpha * distances + (1.0 - self.alpha) * inner_penalty(targets)


def uem_cost(alpha: float = ALPHA) -> FarthestAddition:
    """Weigh distance against being at the rim of the schedule; see ``FarthestAddition``.

    Raises:
        ValueError: alpha is not within 0 to 1.
    """
    return FarthestAddition(alpha)


def inner_penalty(targets: Floats) -> Floats:
    """Give the bracket of Eq. 3, L - max(dist(t_i, b1), dist(t_i, b2)), for each of some targets, (k, 2) [m]."""
    if len(targets) < 2:
        return np.zeros(len(targets))
    first, second = farthest_pair(targets)
    to_first = np.sqrt(squared_distances(targets[first], targets))
    to_second = np.sqrt(squared_distances(targets[second], targets))
    penalty: Floats = to_first[second] - np.maximum(to_first, to_second)
    return penalty
