from __future__ import annotations

import math
from typing import List

import numpy as np
import pytest
from basic_behaviours.driving import Driver, Steering
from basic_behaviours.sight import Sight, SightReader

from rqt_mrta_py.model import Pose, Twist
from tests.plugins.basic_behaviours.kinematics import MODEL
from tests.plugins.basic_behaviours.perception import Perceived

HERE = Pose(6.0, 4.0)


def sight_with(*hits: int, distance: float = 0.6) -> Sight:
    """See things in these directions [degrees], nothing elsewhere."""
    perceived = Perceived()
    perceived.hear_scan([distance if -180 + 10 * ray in hits else math.inf for ray in range(36)])
    sight = SightReader().read(perceived)
    assert sight is not None
    return sight


def test_steering_takes_the_wish_where_there_is_room() -> None:
    assert Steering(MODEL).choose(sight_with(90), 0.2, room=0.8) == (0.2, True)


@pytest.mark.parametrize(("turn", "degrees"), [(0, -40), (-1, -40), (1, 40)])
def test_steering_passes_on_the_right_unless_told_otherwise(turn: int, degrees: int) -> None:
    # A thing 0.6 m ahead bars a disc of 0.3 m up to asin(0.3 / 0.6) = 30 degrees to either side.
    direction, as_wished = Steering(MODEL).choose(sight_with(0), 0.0, room=0.8, turn=turn)
    assert math.degrees(direction) in (pytest.approx(degrees), pytest.approx(math.copysign(30, degrees)))
    assert not as_wished


def test_steering_keeps_the_side_it_chose() -> None:
    steering = Steering(MODEL)
    # The left is free from 30 degrees on, the right from 70: left, although right is preferred by 29 degrees.
    first, _ = steering.choose(sight_with(0, -10, -20, -30, -40), 0.0, room=0.8)
    # Now the left is free from 50 degrees on and the right from 30: by itself right, but it stays with the left.
    second, _ = steering.choose(sight_with(0, 10, 20), 0.0, room=0.8)
    assert first > 0.0
    assert second > 0.0
    assert Steering(MODEL).choose(sight_with(0, 10, 20), 0.0, room=0.8)[0] < 0.0


def test_steering_takes_the_way_with_most_room_when_all_are_barred() -> None:
    # Nowhere 0.8 m; from 80 to 120 degrees 1 m less the disc's 0.3, for there the things at 0.65 m are passed
    # (0.65 sin 30 > 0.3); elsewhere hardly more than 0.4 m.
    perceived = Perceived()
    perceived.hear_scan([1.0 if 60 <= -180 + 10 * ray <= 140 else 0.65 for ray in range(36)])
    sight = SightReader().read(perceived)
    assert sight is not None
    direction, as_wished = Steering(MODEL).choose(sight, 0.0, room=0.8)
    assert math.degrees(direction) == pytest.approx(80)
    assert not as_wished


def test_velocities_brake_before_what_is_ahead_and_turn_on_the_spot_when_looking_back() -> None:
    steering = Steering(MODEL)
    # 0.32 m to the thing less the radius and 2 cm: 0.1 m of room, to be gone in one second.
    assert steering.velocities(sight_with(0, distance=0.32), 0.0, 0.3) == Twist(pytest.approx(0.1), 0.0, 0.0)
    assert steering.velocities(sight_with(), math.pi, 0.3) == Twist(0.0, 0.0, MODEL.max_turn_rate)
    assert steering.velocities(sight_with(), 0.0, 9.0).vx == MODEL.max_speed


def drive(driver: Driver, seconds: float, sight: Sight, start: float = 1.0) -> List[Twist]:
    """Drive for so long without coming from the spot."""
    ticks = range(round(seconds * 20))
    return [driver.drive(start + tick / 20, HERE, sight, 0.0, 0.3)[0] for tick in ticks]


def test_driver_backs_off_and_goes_elsewhere_when_it_does_not_come_from_the_spot() -> None:
    twists = drive(Driver(MODEL, np.random.default_rng(2)), 10.0, sight_with())
    # Patience of 6 s, one second back at half the speed, two seconds elsewhere, then as wished again.
    assert {twist.vx for twist in twists[:120]} == {0.3}
    assert {twist.vx for twist in twists[122:140]} == {-0.15}
    assert any(twist.wz != 0.0 for twist in twists[142:180])
    assert {(twist.vx, twist.wz) for twist in twists[182:]} == {(0.3, 0.0)}


def test_driver_does_not_back_into_what_is_behind() -> None:
    twists = drive(Driver(MODEL, np.random.default_rng(1)), 7.0, sight_with(-180, distance=0.2))
    assert {twist.vx for twist in twists[122:140]} == {0.0}


def test_driver_does_not_count_the_time_in_which_it_was_not_asked() -> None:
    driver = Driver(MODEL, np.random.default_rng(1))
    drive(driver, 5.0, sight_with())
    assert {twist.vx for twist in drive(driver, 5.0, sight_with(), start=60.0)} == {0.3}
