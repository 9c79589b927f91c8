from __future__ import annotations

import math

import pytest
from hypothesis import given
from hypothesis import strategies as st

from rqt_mrta_py.model import Pose, wrap_angle


@pytest.mark.parametrize(
    ("angle", "wrapped"),
    [(0.0, 0.0), (math.pi, math.pi), (-math.pi, math.pi), (3 * math.pi, math.pi), (-1.0, -1.0), (7.0, 0.716814692820)],
)
def test_wrap_angle_brings_into_the_half_open_turn(angle: float, wrapped: float) -> None:
    assert wrap_angle(angle) == pytest.approx(wrapped, abs=1e-9)


@given(st.floats(-1e6, 1e6))
def test_wrap_angle_keeps_the_direction(angle: float) -> None:
    wrapped = wrap_angle(angle)
    assert -math.pi < wrapped <= math.pi
    assert math.cos(wrapped) == pytest.approx(math.cos(angle), abs=1e-9)
    assert math.sin(wrapped) == pytest.approx(math.sin(angle), abs=1e-9)


@pytest.mark.parametrize(
    ("yaw", "bearing"),
    [(0.0, math.pi / 4), (math.pi / 4, 0.0), (math.pi / 2, -math.pi / 4), (-math.pi, -3 * math.pi / 4)],
)
def test_bearing_counts_counter_clockwise_from_the_heading(yaw: float, bearing: float) -> None:
    assert Pose(1.0, 1.0, yaw).bearing(Pose(3.0, 3.0)) == pytest.approx(bearing)


def test_distance_is_euclidean_and_disregards_headings() -> None:
    assert Pose(1.0, 2.0, 3.0).distance(Pose(4.0, 6.0)) == 5.0
