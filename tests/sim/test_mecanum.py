from __future__ import annotations

import pytest
from hypothesis import given
from hypothesis import strategies as st

from rqt_mrta_py.model import Twist
from rqt_mrta_py.sim.mecanum import MecanumWheels, within_wheel_speed

WHEELS = MecanumWheels(radius=0.05, half_lengths=0.25)

speeds = st.floats(-2.0, 2.0)


@pytest.mark.parametrize(
    ("twist", "expected"),
    [
        # 0.1 m/s over 0.05 m: 2 rad/s, all wheels alike.
        (Twist(0.1, 0.0, 0.0), (2.0, 2.0, 2.0, 2.0)),
        # To the left: the front right and the rear left wheel turn forwards, the others backwards.
        (Twist(0.0, 0.1, 0.0), (-2.0, 2.0, 2.0, -2.0)),
        # 0.4 rad/s at 0.25 m: 0.1 m/s; the right wheels turn forwards.
        (Twist(0.0, 0.0, 0.4), (-2.0, 2.0, -2.0, 2.0)),
        (Twist(0.1, 0.1, 0.4), (-2.0, 6.0, 2.0, 2.0)),
    ],
)
def test_wheels_turn_as_the_base_moves(twist: Twist, expected: tuple[float, ...]) -> None:
    assert WHEELS.speeds(twist) == pytest.approx(expected)


@given(speeds, speeds, speeds)
def test_what_wheels_are_told_is_what_the_base_does(vx: float, vy: float, wz: float) -> None:
    back = WHEELS.twist(WHEELS.speeds(Twist(vx, vy, wz)))
    assert (back.vx, back.vy, back.wz) == pytest.approx((vx, vy, wz), abs=1e-12)


def test_wheels_that_would_turn_too_fast_slow_the_base_down_and_not_aside() -> None:
    slowed = within_wheel_speed(WHEELS, Twist(0.1, 0.1, 0.4), 3.0)
    assert (slowed.vx, slowed.vy, slowed.wz) == pytest.approx((0.05, 0.05, 0.2))
    assert max(map(abs, WHEELS.speeds(slowed))) == pytest.approx(3.0)
    assert within_wheel_speed(WHEELS, Twist(0.1), 3.0) == Twist(0.1)
    assert within_wheel_speed(WHEELS, Twist(), 3.0) == Twist()
