"""Routes: which targets each robot visits, in which order; open paths, nobody returns."""

from __future__ import annotations

from typing import TYPE_CHECKING, NamedTuple, Sequence, Tuple

import numpy as np

if TYPE_CHECKING:
    from numpy.typing import NDArray

__all__ = ["Distances", "Routes", "distances", "makespan", "route_lengths", "total_length"]

Routes = Tuple[Tuple[int, ...], ...]
"""Of each robot the indices of its targets, in the order of visiting."""


class Distances(NamedTuple):
    """What the ways between places cost.

    Attributes:
        starts: from robots to targets, shape (robots, targets) [m].
        between: from target to target, symmetric, shape (targets, targets) [m].
    """

    starts: NDArray[np.float64]
    between: NDArray[np.float64]


def distances(robots: NDArray[np.float64], targets: NDArray[np.float64]) -> Distances:
    """Measure the straight ways.

    Args:
        robots: where they start, shape (robots, 2) [m].
        targets: where they are, shape (targets, 2) [m].

    Raises:
        ValueError: a coordinate is not finite, or the shapes are others.
    """
    for name, places in (("robots", robots), ("targets", targets)):
        if places.ndim != 2 or places.shape[1] != 2:
            raise ValueError(f"{name}: an array of x and y of each is expected, got the shape {places.shape}")
        if not np.isfinite(places).all():
            raise ValueError(
                f"{name}: {np.argmin(np.isfinite(places).all(axis=1))} has a coordinate that is not finite"
            )
    return Distances(_apart(robots, targets), _apart(targets, targets))


def route_lengths(ways: Distances, routes: Sequence[Sequence[int]]) -> NDArray[np.float64]:
    """Measure each robot's route [m].

    Args:
        ways: between all places.
        routes: of as many robots.
    """
    lengths = np.zeros(len(routes))
    for robot, route in enumerate(routes):
        if route:
            stops = np.asarray(route)
            lengths[robot] = ways.starts[robot, stops[0]] + ways.between[stops[:-1], stops[1:]].sum()
    return lengths


def total_length(ways: Distances, routes: Sequence[Sequence[int]]) -> float:
    """Measure all routes together: the path objective [m]."""
    return float(route_lengths(ways, routes).sum())


def makespan(ways: Distances, routes: Sequence[Sequence[int]]) -> float:
    """Measure the longest route: the time objective, at unit speed [m]."""
    return float(route_lengths(ways, routes).max(initial=0.0))


def _apart(first: NDArray[np.float64], second: NDArray[np.float64]) -> NDArray[np.float64]:
    x, y = np.moveaxis(first[:, None] - second[None], 2, 0)
    return np.asarray(np.hypot(x, y), dtype=np.float64)
