"""The tables of Dantas (2017) about simulated builds, as data."""

from __future__ import annotations

from typing import Mapping, NamedTuple

__all__ = ["BUILDS", "NOISE_LIMITS", "Build"]


class Build(NamedTuple):
    """What one robot takes in simulation, of tables 10, 12, 14 and 16.

    Attributes:
        fetching_minutes, placing_minutes: time of manipulation and assembly [min].
        fetching, placing: ways of both [m].
        blocks: that are placed.
    """

    fetching_minutes: float
    placing_minutes: float
    fetching: float
    placing: float
    blocks: int


BUILDS: Mapping[str, Build] = {
    "tower": Build(36.0, 48.0, 38.4, 46.1, 30),
    "dam": Build(21.0, 36.0, 19.9, 38.3, 19),
    "pyramid": Build(49.0, 71.0, 61.1, 72.7, 46),
    "station": Build(26.0, 36.0, 30.1, 35.2, 23),
}

NOISE_LIMITS: Mapping[float, bool] = {0.008: True, 0.02: False, 0.03: False}
"""Whether the cistern stood, by the greatest error of poses [m] (figure 48)."""
