"""Rays into ranges of bearings, against each ray looked at by itself."""

from __future__ import annotations

import math

import numpy as np
from hypothesis import given, settings
from hypothesis import strategies as st

from rqt_mrta_py.sim.planar.fan import Fan

ways = st.tuples(st.floats(-2 * math.pi, 2 * math.pi), st.floats(0.0, math.pi))


def beside(bearing, middle):
    """Give by how much a ray goes beside the middle of a range, the short way round."""
    return abs(math.remainder(bearing - middle, 2 * math.pi))


@settings(max_examples=100, deadline=None)
@given(st.lists(st.floats(-8.0, 8.0), min_size=1, max_size=80), st.lists(ways, min_size=1, max_size=5))
def test_fan_finds_every_ray_into_a_range_once_and_none_far_beside(bearings, ranges):
    fan = Fan(np.array(bearings))
    rows, rays = fan.towards(*np.array(ranges).T)
    assert len({*zip(rows.tolist(), rays.tolist())}) == rows.size
    for row, (middle, half_angle) in enumerate(ranges):
        found = set(rays[rows == row].tolist())
        sides = [beside(bearing, middle) for bearing in bearings]
        assert found >= {ray for ray, side in enumerate(sides) if side <= half_angle}
        assert found <= {ray for ray, side in enumerate(sides) if side <= half_angle + 0.01}


def test_fan_gives_rays_by_range():
    fan = Fan(np.array([0.0, math.pi / 2, math.pi, -math.pi / 2]))
    rows, rays = fan.towards(np.array([math.pi / 4, -math.pi / 2, 1.0]), np.array([1.0, 0.1, 0.0]))
    assert rows.tolist() == [0, 0, 1]
    assert rays.tolist() == [0, 1, 3]
