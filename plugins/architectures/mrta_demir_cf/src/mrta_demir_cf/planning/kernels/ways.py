"""Robots on straight ways at unit speed: where they are, and which of them are near a place."""

from __future__ import annotations

from typing import NamedTuple, Tuple

import numpy as np

from mrta_demir_cf.planning.arrays import Floats
from mrta_demir_cf.planning.compiled import inner_kernel

__all__ = ["Ways", "arrive", "place_on_way", "places_on_ways", "set_out"]


class Ways(NamedTuple):
    """Where robots come from and go to; both are the same for those that wait.

    Attributes:
        starts: (M, 2) [m].
        goals: (M, 2) [m].
        departures: (M,) [s].
        arrivals: (M,) [s].
    """

    starts: Floats
    goals: Floats
    departures: Floats
    arrivals: Floats


@inner_kernel
def place_on_way(ways: Ways, robot: int, now: float) -> Tuple[float, float]:
    """Tell where a robot is, (x, y) [m]; at its goal where its way has no length."""
    start_x, start_y = ways.starts[robot, 0], ways.starts[robot, 1]
    span = ways.arrivals[robot] - ways.departures[robot]
    share = (now - ways.departures[robot]) / span if span > 0.0 else 1.0
    return (
        start_x + (ways.goals[robot, 0] - start_x) * share,
        start_y + (ways.goals[robot, 1] - start_y) * share,
    )


@inner_kernel
def places_on_ways(ways: Ways, now: float, places: Floats) -> None:
    """Write down where all robots are, (M, 2) [m]."""
    for robot in range(len(places)):
        places[robot, 0], places[robot, 1] = place_on_way(ways, robot, now)


@inner_kernel
def set_out(ways: Ways, robot: int, x: float, y: float, now: float) -> float:
    """Let a robot leave for a goal.

    Returns:
        The length of the way [m].
    """
    along_x, along_y = x - ways.starts[robot, 0], y - ways.starts[robot, 1]
    length = float(np.sqrt(along_x * along_x + along_y * along_y))
    ways.goals[robot, 0], ways.goals[robot, 1] = x, y
    ways.departures[robot], ways.arrivals[robot] = now, now + length
    return length


@inner_kernel
def arrive(ways: Ways, robot: int, now: float) -> None:
    """Let a robot be at its goal."""
    ways.starts[robot, 0], ways.starts[robot, 1] = ways.goals[robot, 0], ways.goals[robot, 1]
    ways.departures[robot] = now
