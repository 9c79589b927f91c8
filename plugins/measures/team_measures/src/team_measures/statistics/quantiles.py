"""Quantiles of a sample."""

from __future__ import annotations

import math
from typing import Optional, Sequence

__all__ = ["quantile"]


def quantile(values: Sequence[float], share: float) -> Optional[float]:
    """Give the value below which a share of a sample lies, between two of its values by the straight line.

    Source: Hyndman and Fan, Sample quantiles in statistical packages, The American Statistician 50 (1996), type 7.

    Args:
        values: in any order.
        share: from 0, the least, to 1, the greatest.

    Returns:
        The quantile; None of an empty sample.
    """
    if not values:
        return None
    ordered = sorted(values)
    place = share * (len(ordered) - 1)
    below = math.floor(place)
    above = min(below + 1, len(ordered) - 1)
    return ordered[below] + (place - below) * (ordered[above] - ordered[below])
