from __future__ import annotations

import math
from dataclasses import replace

import pytest
from hypothesis import given
from hypothesis import strategies as st

from rqt_mrta_py.hooks import ArmModel
from rqt_mrta_py.model import Pose

ARM = ArmModel(
    length=0.22,
    joint_ahead=0.12,
    magnet_ahead=0.03,
    joint_height=0.20,
    magnet_below=0.05,
    lowest=-1.0,
    highest=1.2,
    rate=0.5,
)


def test_the_angle_follows_from_the_height() -> None:
    # (0.26 - 0.20 + 0.05) / 0.22 = 0.5; (0.15 - 0.20 + 0.05) / 0.22 = 0.
    assert ARM.angle_at(0.26) == pytest.approx(math.pi / 6.0)
    assert ARM.angle_at(0.15) == pytest.approx(0.0)
    assert ARM.height_at(math.pi / 6.0) == pytest.approx(0.26)


def test_the_arm_reaches_farthest_when_level() -> None:
    assert ARM.reach_at(0.0) == pytest.approx(0.22 + 0.12 + 0.03)
    # 0.22 cos 60 = 0.11.
    assert ARM.reach_at(math.pi / 3.0) == pytest.approx(0.26)


def test_the_robot_stands_behind_its_magnet() -> None:
    base = ARM.base_pose(Pose(1.0, 2.0, math.pi / 2.0), math.pi / 3.0)
    assert (base.x, base.y, base.yaw) == pytest.approx((1.0, 1.74, math.pi / 2.0))


@given(st.floats(-5.0, 5.0), st.floats(-5.0, 5.0), st.floats(-3.0, 3.0), st.floats(-1.0, 1.2))
def test_magnet_and_base_tell_each_others_pose(x: float, y: float, yaw: float, angle: float) -> None:
    back = ARM.magnet_pose(ARM.base_pose(Pose(x, y, yaw), angle), angle)
    assert (back.x, back.y, back.yaw) == pytest.approx((x, y, yaw), abs=1e-12)
    assert ARM.angle_at(ARM.height_at(angle)) == pytest.approx(angle, abs=1e-9)


@pytest.mark.parametrize("height", [-0.1, 0.05 - 0.2, 0.5])
def test_heights_out_of_reach_are_refused_with_what_is_reached(height: float) -> None:
    # Between joint 1 and the magnet: 0.15 + 0.22 sin(-1.0) = -0.035, 0.15 + 0.22 sin(1.2) = 0.355.
    with pytest.raises(ValueError, match=r"it reaches -0\.035 to 0\.355 m"):
        ARM.angle_at(height)


@pytest.mark.parametrize(
    ("wrong", "complaint"),
    [
        ({"length": 0.0}, "length must be above 0"),
        ({"rate": -1.0}, "rate must be above 0"),
        ({"joint_ahead": math.nan}, "joint_ahead must be a finite number"),
        ({"lowest": 1.2}, "lowest 1.2 must be below highest 1.2"),
        ({"highest": 2.0}, "both within a quarter turn"),
    ],
)
def test_arms_that_cannot_be_are_refused(wrong: dict[str, float], complaint: str) -> None:
    with pytest.raises(ValueError, match=complaint):
        replace(ARM, **wrong)
