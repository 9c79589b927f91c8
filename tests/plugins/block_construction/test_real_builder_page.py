"""What the page about real robots says agrees with the robot's model and with the launch file."""

from __future__ import annotations

import math
import re
from pathlib import Path
from typing import List
from xml.etree import ElementTree

import pytest

from rqt_mrta_py.model import Twist
from rqt_mrta_py.sim.mecanum import MecanumWheels
from rqt_mrta_py.sim.robot_models import MECANUM_ARM

MICROSTEPS, STEP_ANGLE = 16, 1.8


@pytest.fixture
def page(root: Path) -> str:
    return (root / "docs" / "applications" / "real_builder.md").read_text(encoding="utf-8")


def numbers(cell: str) -> List[float]:
    return [float(each) for each in cell.split(",")]


def test_worked_numbers_are_those_of_the_models_wheels(page: str) -> None:
    """Steps a second by equation 3.9: 0.75 rad/s are 0.75 * 16 * 200 / (2 pi) = 382.0."""
    wheels = MecanumWheels(MECANUM_ARM.wheel_radius, (MECANUM_ARM.wheelbase + MECANUM_ARM.track) / 2.0)
    assert f"(r {wheels.radius:g} m, s {wheels.half_lengths:g} m)" in page
    rows = re.findall(r"^\| ([-\d., ]+) \| ([-\d., ]+) \| ([-\d., ]+) \|$", page, re.MULTILINE)
    assert len(rows) == 5
    for twist, speeds, steps in rows:
        found = wheels.speeds(Twist(*numbers(twist)))
        assert found == pytest.approx(numbers(speeds), abs=0.0005)
        per_second = [speed * MICROSTEPS * (360.0 / STEP_ANGLE) / (2.0 * math.pi) for speed in found]
        assert per_second == pytest.approx(numbers(steps), abs=0.05)
    assert numbers(rows[0][2])[0] == pytest.approx(0.75 * 16 * 200 / (2.0 * math.pi), abs=0.05)


def test_measures_are_those_of_the_model(page: str) -> None:
    arm = MECANUM_ARM.arm
    assert arm is not None
    for measure in (arm.length, arm.joint_ahead, arm.joint_height, arm.magnet_ahead, arm.magnet_below):
        assert f"{measure:.2f} m" in page


def test_the_launch_file_shown_gives_arguments_that_there_are(page: str, root: Path) -> None:
    (shown,) = re.findall(r"```xml\n(.*?)```", page, re.DOTALL)
    include = ElementTree.fromstring(shown).find("include")
    assert include is not None
    path = str(include.get("file")).replace("$(find block_construction)", "plugins/applications/block_construction")
    known = {each.get("name") for each in ElementTree.parse(root / path).getroot().findall("arg")}
    given = [str(each.get("name")) for each in include.findall("arg")]
    said = re.findall(r"(\w+):=", page)
    assert [name for name in (*given, *said) if name not in known] == []
    assert {"settings", "record", "supervisor"} <= set(said)
