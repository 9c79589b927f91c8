"""Leaves out points that a straight line between their neighbours tells as well."""

from __future__ import annotations

import math
from typing import List, Sequence

__all__ = ["corners"]


def corners(times: Sequence[float], columns: Sequence[Sequence[float]], tolerances: Sequence[float]) -> List[int]:
    """Choose points so that straight lines from each to the next miss no other by more than a tolerance.

    One pass: from the last point chosen a cone of slopes is kept for each column that passes all points since within
    the tolerance; the first point outside ends it (Reumann and Witkam's strip, made exact by the cone of Williams 1978,
    "An efficient algorithm for the piecewise linear approximation of planar curves").

    Args:
        times: of the points, not decreasing.
        columns: values, all as many as times, finite.
        tolerances: one for each column, above 0.

    Returns:
        Places of the chosen points, first and last among them, in order.
    """
    count = len(times)
    if count <= 2:
        return list(range(count))
    if len(columns) == 1:
        return _corners_of_one(times, columns[0], tolerances[0])
    chosen = [0]
    anchor, at = 0, 1
    lows, highs = [-math.inf] * len(columns), [math.inf] * len(columns)
    while at < count:
        span = times[at] - times[anchor]
        rises = [column[at] - column[anchor] for column in columns]
        if span > 0.0 and all(low <= rise / span <= high for low, rise, high in zip(lows, rises, highs)):
            for number, (rise, tolerance) in enumerate(zip(rises, tolerances)):
                lows[number] = max(lows[number], (rise - tolerance) / span)
                highs[number] = min(highs[number], (rise + tolerance) / span)
            at += 1
            continue
        # The one before still fitted and is the next corner; two of one time both are.
        anchor = at - 1 if at > anchor + 1 else at
        at = anchor + 1
        chosen.append(anchor)
        lows, highs = [-math.inf] * len(columns), [math.inf] * len(columns)
    if chosen[-1] != count - 1:
        chosen.append(count - 1)
    return chosen


def _corners_of_one(times: Sequence[float], values: Sequence[float], tolerance: float) -> List[int]:
    """Do the same for one column, as all curves are, of which a page may have a hundred."""
    count = len(times)
    chosen = [0]
    anchor, at = 0, 1
    time, value, low, high = times[0], values[0], -math.inf, math.inf
    while at < count:
        span = times[at] - time
        if span > 0.0:
            rise = values[at] - value
            if low <= rise / span <= high:
                least, most = (rise - tolerance) / span, (rise + tolerance) / span
                low = max(low, least)
                high = min(high, most)
                at += 1
                continue
        anchor = at - 1 if at > anchor + 1 else at
        at = anchor + 1
        chosen.append(anchor)
        time, value, low, high = times[anchor], values[anchor], -math.inf, math.inf
    if chosen[-1] != count - 1:
        chosen.append(count - 1)
    return chosen
