"""Arrays of points, masks and distances: their types, their checks, and squared distances.

A point is a place (x, y) [m] in the frame of the map. Distances are compared as their squares, which are exact where
coordinates are integers, so that ties are ties.
"""

from __future__ import annotations

from typing import Tuple

import numpy as np
from numpy.typing import NDArray

__all__ = [
    "Floats",
    "Indices",
    "Mask",
    "checked_distances",
    "checked_mask",
    "checked_points",
    "checked_situation",
    "squared_distances",
]

Floats = NDArray[np.float64]
Indices = NDArray[np.intp]
Mask = NDArray[np.bool_]


def checked_points(name: str, points: Floats) -> Floats:
    """Accept places in the plane.

    Args:
        name: of the argument, for the error's text.
        points: (n, 2) [m], frame map; an empty list is no point.

    Returns:
        The same as float64, shape (n, 2).

    Raises:
        ValueError: the shape is another, or a coordinate is not finite.
    """
    array = np.asarray(points, dtype=np.float64)
    if array.size == 0 and array.ndim <= 2:
        return np.zeros((0, 2))
    if array.ndim != 2 or array.shape[1] != 2:
        raise ValueError(f"{name}: shape is {array.shape}; give (n, 2), one place (x, y) in a row")
    if not np.isfinite(array).all():
        row = int(np.flatnonzero(~np.isfinite(array).all(axis=1))[0])
        raise ValueError(f"{name}[{row}]: is {array[row].tolist()}; coordinates must be finite")
    return array


def checked_mask(name: str, mask: Mask, length: int) -> Mask:
    """Accept a mask with one entry for each of ``length`` things.

    Raises:
        ValueError: the shape or the type is another.
    """
    array = np.asarray(mask)
    if array.shape != (length,) or (array.dtype != np.bool_ and length):
        raise ValueError(f"{name}: shape is {array.shape} of {array.dtype}; give ({length},) of bool")
    return array.astype(np.bool_, copy=False)


def checked_distances(name: str, distances: Floats, length: int) -> Floats:
    """Accept one distance [m] to each of ``length`` places; infinite ones lead to places out of reach.

    Raises:
        ValueError: the shape is another, or a distance is NaN or negative.
    """
    array = np.asarray(distances, dtype=np.float64)
    if array.shape != (length,):
        raise ValueError(f"{name}: shape is {array.shape}; give ({length},)")
    wrong = ~(array >= 0.0)
    if wrong.any():
        index = int(np.flatnonzero(wrong)[0])
        raise ValueError(f"{name}[{index}]: is {array[index]:g} m; give at least 0 m, or inf for what is out of reach")
    return array


def checked_situation(robot: int, robots: Floats, targets: Floats, open: Mask) -> Tuple[Floats, Floats, Indices]:
    """Accept what a robot decides by.

    Args:
        robot: a row of ``robots``.
        robots: (M, 2) [m].
        targets: (N, 2) [m].
        open: (N,), which targets are open.

    Returns:
        Robots and targets as ``checked_points`` gives them; indices of open targets, rising.

    Raises:
        ValueError: a shape is wrong, a coordinate is not finite, or there is no such robot.
    """
    robots = checked_points("robots", robots)
    targets = checked_points("targets", targets)
    candidates = np.flatnonzero(checked_mask("open", open, len(targets)))
    if not 0 <= robot < len(robots):
        raise ValueError(f"robot: is {robot}; give a row of robots, 0 <= robot < {len(robots)}")
    return robots, targets, candidates


def squared_distances(place: Floats, points: Floats) -> Floats:
    """Give the squares of Euclidean distances.

    Args:
        place: (..., 2) [m].
        points: (n, 2) [m]; or what broadcasts with ``place``.

    Returns:
        (n,), or broadcast shape without its last axis [m^2].
    """
    along_x = points[..., 0] - place[..., 0]
    along_y = points[..., 1] - place[..., 1]
    squares: Floats = along_x * along_x + along_y * along_y
    return squares
