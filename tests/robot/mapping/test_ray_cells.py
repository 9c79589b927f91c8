"""Cells on rays, by hand and held against points strewn along each ray."""

from __future__ import annotations

import math
from typing import Set, Tuple

import numpy as np
from hypothesis import given
from hypothesis import strategies as st

from rqt_mrta_py.robot.mapping.ray_cells import ray_cells


def cells(x: float, y: float, direction: float, length: float) -> Set[Tuple[int, int]]:
    columns, rows = ray_cells(x, y, np.array([direction]), np.array([length]))
    return set(zip(columns.tolist(), rows.tolist()))


def test_a_ray_along_a_row_passes_each_cell_up_to_its_end() -> None:
    assert cells(0.5, 0.5, 0.0, 2.2) == {(0, 0), (1, 0), (2, 0)}
    assert cells(0.5, 0.5, math.pi, 2.2) == {(0, 0), (-1, 0), (-2, 0)}


def test_a_slanting_ray_passes_what_it_cuts() -> None:
    """From (0.5, 0.25) with slope 1 it crosses x = 1 at y = 0.75 and y = 1 at x = 1.25, and ends in (1.9, 1.65)."""
    assert cells(0.5, 0.25, math.pi / 4.0, 1.4 * math.sqrt(2.0)) == {(0, 0), (1, 0), (1, 1)}


def test_a_ray_within_a_cell_passes_that_cell_alone() -> None:
    assert cells(3.2, 4.2, 1.0, 0.3) == {(3, 4)}


def test_a_ray_through_a_corner_goes_on_in_its_direction() -> None:
    assert cells(0.0, 0.0, -2.0, 0.1) == {(0, 0), (-1, -1)}


def test_many_rays_are_those_one_by_one() -> None:
    directions, lengths = np.array([0.1, 2.0, 4.0]), np.array([3.0, 0.4, 7.5])
    columns, rows = ray_cells(2.3, 5.6, directions, lengths)
    alone = [cells(2.3, 5.6, *ray) for ray in zip(directions.tolist(), lengths.tolist())]
    assert set(zip(columns.tolist(), rows.tolist())) == set().union(*alone)


@given(st.floats(-3.0, 3.0), st.floats(-3.0, 3.0), st.floats(-math.pi, math.pi), st.floats(0.0, 6.0))
def test_all_cells_along_a_ray_are_listed_and_no_other_one(x: float, y: float, direction: float, length: float) -> None:
    found = cells(x, y, direction, length)
    xs = x + math.cos(direction) * np.linspace(0.0, length, 200)
    ys = y + math.sin(direction) * np.linspace(0.0, length, 200)
    slack = 1e-9
    clear = (np.abs(xs - np.round(xs)) > slack) & (np.abs(ys - np.round(ys)) > slack)
    strewn = set(zip(np.floor(xs[clear]).astype(int).tolist(), np.floor(ys[clear]).astype(int).tolist()))
    assert strewn <= found
    for column, row in found:
        # The ray must come within a hair of the square.
        beyond_x = np.maximum(np.maximum(column - xs, xs - column - 1.0), 0.0)
        beyond_y = np.maximum(np.maximum(row - ys, ys - row - 1.0), 0.0)
        assert np.hypot(beyond_x, beyond_y).min() <= length / 199.0 + 1e-6
