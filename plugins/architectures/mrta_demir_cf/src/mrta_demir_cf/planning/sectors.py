"""How far a robot's Voronoi cell can reach, by looking at six sectors of 60 degrees around the robot.

If another robot stands in a sector at the distance D, then every point of that sector farther away than D is nearer to
that robot (the angle between both is at most 60 degrees). So the nearest robot of each sector bounds the cell there,
and where no robot stands, the rectangle around all targets does. The bounds are only used to leave out what need not be
looked at, and are widened by more than rounding can do.
"""

from __future__ import annotations

import numpy as np

from mrta_demir_cf.planning.arrays import Floats

__all__ = ["SECTORS", "WIDER", "reach_in_sector", "sector_of"]

SECTORS = 6

WIDER = 1.0 + 1e-9

_SLOPE = float(np.sqrt(3.0))


def sector_of(along_x: float, along_y: float) -> int:
    """Tell in which sector a direction lies, 0 to 5, against the clock from the x axis."""
    if along_y >= 0.0:
        if along_x > 0.0 and along_y < _SLOPE * along_x:
            return 0
        if along_x < 0.0 and along_y < -_SLOPE * along_x:
            return 2
        return 1
    if along_x < 0.0 and along_y > _SLOPE * along_x:
        return 3
    if along_x > 0.0 and along_y > -_SLOPE * along_x:
        return 5
    return 4


def reach_in_sector(sector: int, place: Floats, low: Floats, high: Floats) -> float:
    """Give how far the part of a rectangle is that lies in a sector around a place [m].

    Args:
        sector: see ``sector_of``.
        place: (2,) [m]; the rectangle is widened to hold it.
        low: smallest coordinates of the rectangle, (2,) [m].
        high: largest coordinates, (2,) [m].
    """
    left, right = min(low[0], place[0]) - place[0], max(high[0], place[0]) - place[0]
    lower, upper = min(low[1], place[1]) - place[1], max(high[1], place[1]) - place[1]
    farthest = 0.0
    for along_x in (left, right):
        for along_y in (lower, upper):
            if sector_of(along_x, along_y) == sector:
                farthest = max(farthest, np.sqrt(along_x * along_x + along_y * along_y))
    for edge in (sector, sector + 1):
        cosine, sine = np.cos(edge * np.pi / 3.0), np.sin(edge * np.pi / 3.0)
        length = np.inf
        if abs(cosine) > 1e-9:
            length = min(length, (right if cosine > 0.0 else left) / cosine)
        if abs(sine) > 1e-9:
            length = min(length, (upper if sine > 0.0 else lower) / sine)
        farthest = max(farthest, length)
    return float(farthest) * WIDER
