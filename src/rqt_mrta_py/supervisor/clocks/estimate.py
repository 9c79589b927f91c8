"""Estimates that a few odd messages do not upset: pure functions of numbers."""

from __future__ import annotations

from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

__all__ = ["Line", "median_deviation", "promptest", "quantile", "robust_line"]

_Numbers = NDArray[np.float64]


class Line(NamedTuple):
    """A straight line: its value at an origin, and by how much it grows."""

    origin: float
    value: float
    slope: float

    def at(self, places: _Numbers) -> _Numbers:
        """Give its values at some places."""
        values: _Numbers = self.value + self.slope * (places - self.origin)
        return values


def robust_line(places: _Numbers, values: _Numbers, origin: float) -> Line:
    """Lay a line through points of which up to 29 in 100 may be anywhere.

    Theil (1950) and Sen (1968, "Estimates of the regression coefficient based on Kendall's tau"): the slope is the
    median of the slopes through any two points; the line then lies so that half of the points are above it.

    Args:
        places: shape (points,), at least one.
        values: shape (points,).
        origin: where the line's value is given.

    Returns:
        The line; it is level where all points are at one place.
    """
    first, second = np.triu_indices(len(places), 1)
    apart = places[second] - places[first]
    slopes = (values[second] - values[first])[apart != 0.0] / apart[apart != 0.0]
    slope = float(np.median(slopes)) if len(slopes) else 0.0
    return Line(origin, float(np.median(values - slope * (places - origin))), slope)


def promptest(places: NDArray[np.int64], leads: NDArray[np.int64]) -> NDArray[np.int64]:
    """Find, of messages in windows, the promptest one of each: the one with the largest lead.

    Args:
        places: number of each message's window, in no order, shape (messages,).
        leads: stamp minus receipt, shape (messages,).

    Returns:
        Indices of messages, by window; of equal leads the first message.
    """
    order = np.lexsort((np.arange(len(places)), -leads, places))
    kept: NDArray[np.int64] = order[np.unique(places[order], return_index=True)[1]]
    return kept


def quantile(values: NDArray[Any], share: float) -> float:
    """Give the smallest of some values that a share of them does not exceed.

    Args:
        values: at least one.
        share: above 0, at most 1.
    """
    rank = max(int(np.ceil(share * len(values))), 1) - 1
    return float(np.partition(values, rank)[rank])


def median_deviation(values: NDArray[Any]) -> float:
    """Give the median of how much values differ from their median."""
    return float(np.median(np.abs(values - np.median(values))))
