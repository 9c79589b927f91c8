from __future__ import annotations

import math

import pytest

from rqt_mrta_py.model import Twist
from rqt_mrta_py.sim.robot_models import DIFF_DRIVE
from rqt_mrta_py.sim.simulated_robot import SimulatedRobot


def robot(news=None):
    return SimulatedRobot("robot1", DIFF_DRIVE, set() if news is None else news)


def take(driver, vx=0.0, vy=0.0, wz=0.0):
    driver.take({"linear/x": vx, "linear/y": vy, "angular/z": wz})


def test_robot_stands_still_until_it_is_told_to_drive():
    driver = robot()
    assert driver.node == "/robot1/driver"
    assert driver.command(is_obeying=True) == Twist()


def test_robot_stands_still_when_its_command_is_too_old():
    driver = robot()
    take(driver, 0.2, wz=-0.4)
    assert driver.command(is_obeying=True) == Twist(0.2, 0.0, -0.4)
    assert driver.command(is_obeying=False) == Twist()
    assert driver.command(is_obeying=True) == Twist(0.2, 0.0, -0.4)


@pytest.mark.parametrize(
    ("told", "expected"),
    [
        ((0.9, 0.0, 0.0), (0.5, 0.0, 0.0)),
        ((-0.9, 0.0, 0.0), (-0.5, 0.0, 0.0)),
        ((0.6, 0.8, 0.0), (0.3, 0.4, 0.0)),
        ((0.0, 0.0, 5.0), (0.0, 0.0, 2.0)),
        ((0.1, 0.0, -5.0), (0.1, 0.0, -2.0)),
        ((0.5, 0.0, 2.0), (0.5, 0.0, 2.0)),
    ],
)
def test_robot_keeps_the_limits_of_its_model(told, expected):
    driver = robot()
    take(driver, *told)
    command = driver.command(is_obeying=True)
    assert (command.vx, command.vy, command.wz) == pytest.approx(expected)


@pytest.mark.parametrize("told", [(math.nan, 0.0, 0.0), (0.0, math.inf, 0.0), (0.0, 0.0, -math.inf)])
def test_robot_stands_still_when_told_what_is_no_number(told):
    driver = robot()
    take(driver, 0.3)
    take(driver, *told)
    assert driver.command(is_obeying=True) == Twist()


def test_stopped_robot_is_still_and_deaf():
    driver = robot()
    take(driver, 0.3)
    driver.stop()
    assert driver.is_stopped
    assert driver.command(is_obeying=True) == Twist()
    take(driver, 0.3)
    driver.resume()
    assert driver.command(is_obeying=True) == Twist()
    take(driver, 0.3)
    assert driver.command(is_obeying=True) == Twist(0.3, 0.0, 0.0)


def test_robot_enters_itself_when_something_befell_it_that_may_change_its_answer():
    news, told = set(), []
    driver = robot(news)
    for happening in (
        lambda: None,
        lambda: take(driver, 0.2),
        lambda: take(driver, 0.2),
        lambda: take(driver, 0.3),
        lambda: setattr(driver, "speed_factor", 0.5),
        driver.stop,
        driver.resume,
        lambda: None,
    ):
        happening()
        told.append(news == {"robot1"})
        driver.command(is_obeying=True)
        assert news == set()
    assert told == [True, True, False, True, True, True, True, False]
