from __future__ import annotations

import math
from dataclasses import replace

import pytest

from rqt_mrta_py.hooks import GRIP_HALF_ANGLE
from rqt_mrta_py.sim.robot_models import MECANUM_ARM
from tests.hooks.garden import MOLE


@pytest.mark.parametrize("measure", ["reach", "max_load", "wheelbase"])
@pytest.mark.parametrize("value", [-0.1, math.nan, math.inf, "far"])
def test_gripper_of_a_robot_model_reaches_no_negative_way_and_bears_no_endless_load(measure, value):
    with pytest.raises(ValueError, match="must be finite and not negative") as raised:
        replace(MOLE, **{measure: value})
    assert str(raised.value) == f"robot model mole: {measure} must be finite and not negative (got {value!r})"


def test_robot_model_without_a_gripper_reaches_nothing():
    assert (MOLE.reach, MOLE.max_load) == (0.0, 0.0)


def test_gripper_takes_what_lies_within_thirty_degrees():
    assert math.degrees(GRIP_HALF_ANGLE) == pytest.approx(30.0)


@pytest.mark.parametrize("actuators", [("base",), ("base", "arm"), ("base", "magnet")])
def test_arm_of_a_robot_model_comes_with_the_actuators_arm_and_magnet(actuators):
    with pytest.raises(ValueError, match="robot model mecanum_arm: actuators arm and magnet go with an arm"):
        replace(MECANUM_ARM, actuators=actuators)


@pytest.mark.parametrize("actuator", ["arm", "magnet"])
def test_robot_model_without_an_arm_has_none_of_its_actuators(actuator):
    with pytest.raises(ValueError, match="robot model mole: actuators arm and magnet go with an arm"):
        replace(MOLE, actuators=("base", actuator))
