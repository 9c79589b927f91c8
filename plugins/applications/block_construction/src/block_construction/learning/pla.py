"""The parameterised learning automaton (PLA): parameters are learned, probabilities follow from them.

Symbols: u_i parameter and p_i probability of action i, b reward from 0 to 1, l1 rate, h(u) a function that is 0 up to
|u| = L and falls off beyond, with K how steeply and n in which power, s_i normal noise.
"""

from __future__ import annotations

import math
from typing import Any

from block_construction.learning.stops import greatest

__all__ = ["boltzmann", "log_gradient", "parameter_change", "restoring_force"]


def boltzmann(parameters: Any, probabilities: Any) -> None:
    """Give the probabilities of an automaton's actions.

        p_i = exp(u_i) / sum_j exp(u_j)

    Args:
        parameters: u.
        probabilities: p; written to.

    Dantas (2017), equation 2.5, with the greatest parameter taken off all, which changes nothing and never overflows.
    """
    highest = greatest(parameters)
    total = 0.0
    for action in range(parameters.size):
        probabilities[action] = math.exp(parameters[action] - highest)
        total += probabilities[action]
    for action in range(parameters.size):
        probabilities[action] /= total


def log_gradient(p: float, chosen: bool) -> float:
    """Give d ln p_a / d u_i, where a is the action that was chosen.

        1 - p_i if i = a, else - p_i

    Dantas (2017), equation 2.8.
    """
    return 1.0 - p if chosen else -p


def restoring_force(u: float, k: float, bound: float, n: int) -> float:
    """Give h'(u), which holds parameters near the bounds: 0 within them.

        h(u) = - K (u - L)^(2n) for u >= L;  - K (u + L)^(2n) for u <= -L

    Args:
        u: the parameter.
        k: K.
        bound: L.
        n: half the power.

    Dantas (2017), the derivative of equation 2.7.
    """
    if -bound <= u <= bound:
        return 0.0
    beyond = u - bound if u > 0.0 else u + bound
    # Multiplied out: powers of floats are not the same to the last bit everywhere.
    power = beyond
    for _ in range(2 * n - 2):
        power *= beyond
    return -2.0 * n * k * power


def parameter_change(b: float, gradient: float, force: float, noise: float, l1: float) -> float:
    """Give what is added to a parameter.

        l1 b d ln g / d u_i + l1 h'(u_i) + noise

    Args:
        b: reward.
        gradient: as ``log_gradient`` gives it.
        force: as ``restoring_force`` gives it.
        noise: l1 s_i, or as printed sqrt(l1) s_i.
        l1: rate.

    Dantas (2017), equation 2.6, and with the gradient of 2.8 equations 2.9 and 2.10.
    """
    return l1 * b * gradient + l1 * force + noise
