"""Student's t distribution."""

from __future__ import annotations

import math

__all__ = ["inner_probability", "two_sided_quantile"]

_HALVINGS = 200


def inner_probability(t: float, freedom: int) -> float:
    """Give the probability that a variable of Student's t distribution lies within -t and t.

    Source: Abramowitz and Stegun, Handbook of Mathematical Functions (1964), 26.7.3 and 26.7.4, which are exact.

    Args:
        t: at least 0.
        freedom: degrees of freedom, at least 1.
    """
    angle = math.atan(t / math.sqrt(freedom))
    sine, cosine = math.sin(angle), math.cos(angle)
    term = cosine if freedom % 2 else 1.0
    total = 0.0
    for power in range(1 if freedom % 2 else 0, freedom - 1, 2):
        total += term
        term *= cosine * cosine * (power + 1) / (power + 2)
    return (angle + sine * total) * 2.0 / math.pi if freedom % 2 else sine * total


def two_sided_quantile(probability: float, freedom: int) -> float:
    """Give the t for which ``inner_probability`` is a given one.

    Args:
        probability: above 0 and below 1.
        freedom: degrees of freedom, at least 1.
    """
    low, high = 0.0, 1.0
    while inner_probability(high, freedom) < probability:
        high *= 2.0
    for _ in range(_HALVINGS):
        middle = 0.5 * (low + high)
        if not low < middle < high:
            break
        if inner_probability(middle, freedom) < probability:
            low = middle
        else:
            high = middle
    return 0.5 * (low + high)
