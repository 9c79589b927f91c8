from __future__ import annotations

import math

import pytest
from hypothesis import given
from hypothesis import strategies as st

from rqt_mrta_py.model import Twist
from rqt_mrta_py.sim.mecanum import MecanumWheels, pulse_frequency, step_rate, within_wheel_speed

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


@pytest.mark.parametrize(
    ("speed", "step_angle_deg", "microsteps", "rate"),
    [
        # One turn a second: 360 / 1.8 = 200 whole steps, each of 16.
        (2.0 * math.pi, 1.8, 16, 3200.0),
        (2.0 * math.pi, 0.9, 1, 400.0),
        # Backwards at a quarter turn a second: 50 whole steps, each of 8.
        (-math.pi / 2.0, 1.8, 8, -400.0),
        # 0.03 m/s on wheels of 5 cm: 0.6 rad/s = 34.3775 degrees a second, 19.0986 whole steps.
        (0.6, 1.8, 16, 305.577),
        (0.0, 1.8, 16, 0.0),
    ],
)
def test_stepper_steps_as_its_wheel_turns(speed, step_angle_deg, microsteps, rate):
    assert step_rate(speed, math.radians(step_angle_deg), microsteps) == pytest.approx(rate, rel=1e-5)


@pytest.mark.parametrize(("angle", "microsteps"), [(0.0, 16), (-0.1, 16), (math.nan, 16), (0.1, 0)])
def test_stepper_without_steps_is_refused(angle, microsteps):
    with pytest.raises(ValueError, match="a stepper has a step angle above 0 and microsteps"):
        step_rate(1.0, angle, microsteps)


@pytest.mark.parametrize(("rate", "frequency"), [(3200.0, 6400.0), (-400.0, 800.0), (0.0, 0.0)])
def test_line_of_a_stepper_goes_up_and_down_at_each_step(rate, frequency):
    assert pulse_frequency(rate) == frequency
