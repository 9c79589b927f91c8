"""Estimates: means and shares with the intervals in which they lie at a confidence of 95 %."""

from __future__ import annotations

import math
from typing import NamedTuple, Optional, Sequence

from team_measures.statistics.student import two_sided_quantile

__all__ = ["CONFIDENCE", "Estimate", "estimated_mean", "estimated_share"]

CONFIDENCE = 0.95
_NORMAL_QUANTILE = 1.959963984540054
"""Of the standard normal distribution, two-sided, at this confidence."""


class Estimate(NamedTuple):
    """What is estimated from a sample.

    Attributes:
        value: the best guess.
        low, high: ends of its interval.
        number: size of the sample.
    """

    value: float
    low: float
    high: float
    number: int


def estimated_mean(values: Sequence[float]) -> Optional[Estimate]:
    """Estimate the mean of what a sample was drawn from, by Student's t.

    Returns:
        The mean, with the interval mean -/+ t s / sqrt(n), where s^2 is the sum of squared deviations over n - 1; None
        of an empty sample, and the interval is a point for a sample of one.
    """
    number = len(values)
    if not number:
        return None
    mean = math.fsum(values) / number
    if number == 1:
        return Estimate(mean, mean, mean, 1)
    deviation = math.sqrt(math.fsum((value - mean) ** 2 for value in values) / (number - 1))
    half = two_sided_quantile(CONFIDENCE, number - 1) * deviation / math.sqrt(number)
    return Estimate(mean, mean - half, mean + half, number)


def estimated_share(hits: int, number: int) -> Optional[Estimate]:
    """Estimate a probability from how often something happened.

    Source: Wilson, Probable inference, the law of succession, and statistical inference, Journal of the American
    Statistical Association 22 (1927). Unlike a mean's interval it is sound where something always happened.

    Args:
        hits: how often it happened.
        number: how often it could have.

    Returns:
        The share of hits, with its interval; None if it could never have happened.
    """
    if not number:
        return None
    share, square = hits / number, _NORMAL_QUANTILE**2
    centre = (share + square / (2 * number)) / (1 + square / number)
    half = _NORMAL_QUANTILE * math.sqrt(share * (1 - share) / number + square / (4 * number**2)) / (1 + square / number)
    return Estimate(share, max(0.0, centre - half), min(1.0, centre + half), number)
