"""What a range finder in the middle of a robot would see."""

from __future__ import annotations

import math
from typing import List, Tuple

import numpy as np
from numpy.typing import NDArray

from rqt_mrta_py.sim.bullet.engine import Engine

__all__ = ["cast_rays"]

_STEP_PAST = 1e-4
"""How far behind a surface of its own a robot looks on [m]."""
_CHUNK = 8192
"""Rays at once; PyBullet answers none of 16384."""


def cast_rays(
    engine: Engine,
    own_body: int,
    centre: Tuple[float, float, float],
    directions: NDArray[np.float64],
    max_range: float,
) -> NDArray[np.float64]:
    """Measure true distances in one plane, looking through the robot's own body.

    A ray that begins inside a convex shape does not hit it, so the box around the sensor is no obstacle; wheels and
    casters would be, and are looked past.

    Args:
        engine: whose bodies are seen.
        own_body: PyBullet's number of the body that is not seen.
        centre: where all rays begin [m], frame ``map``.
        directions: [rad] in the frame ``map``, shape (rays,).
        max_range: length of the rays [m].

    Returns:
        Distances from the centre [m], shape (rays,); infinity where nothing is hit.
    """
    starts = np.empty((directions.size, 3))
    starts[:] = centre
    ends = starts.copy()
    ends[:, 0] += max_range * np.cos(directions)
    ends[:, 1] += max_range * np.sin(directions)
    distances: List[float] = []
    for first in range(0, directions.size, _CHUNK):
        chunk = slice(first, first + _CHUNK)
        hits = engine.bullet.rayTestBatch(starts[chunk], ends[chunk], physicsClientId=engine.client)
        for index, (body, _, fraction, _, _) in enumerate(hits, first):
            if body == own_body:
                distances.append(_look_past(engine, own_body, centre, ends[index].tolist(), fraction))
            else:
                distances.append(fraction * max_range if body >= 0 else math.inf)
    return np.array(distances, dtype=np.float64)


def _look_past(
    engine: Engine, own_body: int, centre: Tuple[float, float, float], end: List[float], fraction: float
) -> float:
    """Follow one ray on from where it hit the robot itself, at a fraction of its length, to something else [m]."""
    length = math.dist(centre, end)
    travelled = fraction * length + _STEP_PAST
    while travelled < length:
        start = [a + (b - a) * travelled / length for a, b in zip(centre, end)]
        body, _, fraction, _, _ = engine.bullet.rayTest(start, end, physicsClientId=engine.client)[0]
        if body < 0:
            return math.inf
        travelled += fraction * (length - travelled)
        if body != own_body:
            return travelled
        travelled += _STEP_PAST
    return math.inf
