from __future__ import annotations

import math

import numpy as np
from hypothesis import example, given
from hypothesis import strategies as st

from rqt_mrta_py.model import wrap_angle
from rqt_mrta_py.sim.angles import wrap_angles


@given(st.one_of(st.floats(-20.0, 20.0), st.floats(allow_nan=False, allow_infinity=False)))
@example(math.pi)
@example(-math.pi)
@example(3 * math.pi)
@example(-2 * math.pi)
@example(math.nextafter(math.pi, 4.0) if hasattr(math, "nextafter") else math.pi)
def test_angles_are_wrapped_to_the_last_bit_as_one_is(angle):
    assert wrap_angles(np.array([angle])).tolist() == [wrap_angle(angle)]


def test_angles_that_are_not_finite_become_no_numbers_quietly():
    assert np.isnan(wrap_angles(np.array([math.inf, -math.inf, math.nan]))).all()


def test_angles_that_were_given_stay_as_they_are():
    given_angles = np.array([4.0, -4.0])
    wrap_angles(given_angles)
    assert given_angles.tolist() == [4.0, -4.0]
