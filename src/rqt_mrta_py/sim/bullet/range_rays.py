"""What a range finder in the middle of a robot would see."""

from __future__ import annotations

from typing import Tuple

import numpy as np
from numpy.typing import NDArray

from rqt_mrta_py.sim.bullet.engine import Engine

__all__ = ["cast_rays"]

_STEP_PAST = 1e-4
"""How far behind a surface of its own a robot looks on [m]."""
_CHUNK = 16384
"""PyBullet takes so many rays at once."""


def cast_rays(
    engine: Engine,
    own_body: int,
    centre: Tuple[float, float, float],
    directions: NDArray[np.float64],
    max_range: float,
) -> NDArray[np.float64]:
    """Measure true distances in one plane, looking through the robot's own body.

    A ray that begins inside a convex shape does not hit it, so the box around the sensor is no obstacle; wheels and
    casters would be.

    Args:
        engine: whose bodies are seen.
        own_body: PyBullet's number of the body that is not seen.
        centre: where all rays begin [m], frame ``map``.
        directions: [rad] in the frame ``map``, shape (rays,).
        max_range: length of the rays [m].

    Returns:
        Distances from the centre [m], shape (rays,); infinity where nothing is hit.
    """
    unit = np.zeros((directions.size, 3))
    np.cos(directions, out=unit[:, 0])
    np.sin(directions, out=unit[:, 1])
    ends = np.asarray(centre) + max_range * unit
    distances = np.full(directions.size, np.inf)
    starts = np.tile(np.asarray(centre, dtype=np.float64), (directions.size, 1))
    travelled = np.zeros(directions.size)
    pending = np.arange(directions.size)
    while pending.size:
        bodies, fractions = _first_hits(engine, starts[pending], ends[pending])
        reached = travelled[pending] + fractions * (max_range - travelled[pending])
        own = bodies == own_body
        other = (bodies >= 0) & ~own
        distances[pending[other]] = reached[other]
        pending, reached = pending[own], reached[own] + _STEP_PAST
        inside = reached < max_range
        pending, reached = pending[inside], reached[inside]
        travelled[pending] = reached
        starts[pending] = np.asarray(centre) + reached[:, np.newaxis] * unit[pending]
    return distances


def _first_hits(
    engine: Engine, starts: NDArray[np.float64], ends: NDArray[np.float64]
) -> Tuple[NDArray[np.int64], NDArray[np.float64]]:
    """Give for each ray the body that it hits first (-1: none) and at which fraction of its length."""
    bodies = np.empty(len(starts), dtype=np.int64)
    fractions = np.empty(len(starts))
    for first in range(0, len(starts), _CHUNK):
        chunk = slice(first, first + _CHUNK)
        hits = engine.bullet.rayTestBatch(starts[chunk], ends[chunk], physicsClientId=engine.client)
        bodies[chunk] = [hit[0] for hit in hits]
        fractions[chunk] = [hit[2] for hit in hits]
    return bodies, fractions
