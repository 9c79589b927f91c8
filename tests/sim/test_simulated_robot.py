from __future__ import annotations

import math

import pytest
from hypothesis import given
from hypothesis import strategies as st

from rqt_mrta_py.hooks import Heard
from rqt_mrta_py.model import Twist
from rqt_mrta_py.sim.robot_models import DIFF_DRIVE
from rqt_mrta_py.sim.simulated_robot import SimulatedRobot


def robot():
    return SimulatedRobot("robot1", DIFF_DRIVE)


def tell(driver, at, vx=0.0, vy=0.0, wz=0.0):
    ((subscription, hear),) = driver.listeners()
    fields = {"linear/x": vx, "linear/y": vy, "angular/z": wz}
    hear(Heard("/robot1/cmd_vel", subscription.type, at, fields))


def test_robot_hears_cmd_vel_in_its_own_namespace():
    driver = robot()
    ((subscription, _),) = driver.listeners()
    assert driver.node == "/robot1/driver"
    assert (subscription.topic, subscription.type) == ("cmd_vel", "geometry_msgs/Twist")
    assert set(subscription.fields) == {"linear/x", "linear/y", "angular/z"}


def test_robot_stands_still_until_it_is_told_to_drive():
    assert robot().command(1.0) == Twist()


def test_robot_obeys_its_newest_command_for_half_a_second():
    driver = robot()
    tell(driver, 2.0, vx=0.2, wz=-0.4)
    assert driver.command(2.0) == Twist(0.2, 0.0, -0.4)
    tell(driver, 2.1, vx=0.3)
    assert driver.command(2.6) == Twist(0.3, 0.0, 0.0)
    assert driver.command(2.65) == Twist()
    tell(driver, 3.0, vx=0.1)
    assert driver.command(3.0) == Twist(0.1, 0.0, 0.0)


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
    tell(driver, 1.0, *told)
    command = driver.command(1.0)
    assert (command.vx, command.vy, command.wz) == pytest.approx(expected)


@pytest.mark.parametrize("told", [(math.nan, 0.0, 0.0), (0.0, math.inf, 0.0), (0.0, 0.0, -math.inf)])
def test_robot_stands_still_when_told_what_is_no_number(told):
    driver = robot()
    tell(driver, 1.0, vx=0.3)
    tell(driver, 1.1, *told)
    assert driver.command(1.1) == Twist()


def test_stopped_robot_is_still_and_deaf():
    driver = robot()
    tell(driver, 1.0, vx=0.3)
    driver.stop()
    assert driver.is_stopped
    assert driver.command(1.0) == Twist()
    tell(driver, 1.1, vx=0.3)
    driver.resume()
    assert driver.command(1.1) == Twist()
    tell(driver, 1.2, vx=0.3)
    assert driver.command(1.2) == Twist(0.3, 0.0, 0.0)


SPEEDS = st.sampled_from([0.0, 0.1, 0.3, math.nan])
HAPPENINGS = st.one_of(
    st.tuples(st.just("tell"), SPEEDS),
    st.tuples(st.sampled_from(["stop", "resume"])),
    st.tuples(st.just("slow"), st.sampled_from([0.0, 0.5, 1.0])),
    st.tuples(st.just("wait"), st.sampled_from([0.05, 0.1, 0.45, 0.5, 0.55, 3.0])),
)


@given(st.lists(st.tuples(HAPPENINGS, st.booleans()), max_size=30))
def test_robot_that_need_not_be_asked_would_answer_the_same(happenings):
    """Whatever befalls it, and whoever asks when: a twin that is always asked tells what is right."""
    driver, twin, now, told = robot(), robot(), 1.0, None
    for (what, *value), looks in happenings:
        now += value[0] if what == "wait" else 0.0
        for each in (driver, twin):
            if what == "tell":
                tell(each, now, vx=value[0])
            elif what == "slow":
                each.speed_factor = value[0]
            elif what != "wait":
                getattr(each, what)()
        if looks:
            if driver.needs_asking(now):
                told = driver.command(now)
            expected = twin.command(now)
            assert (told or Twist()) == expected


def test_robot_that_goes_on_as_commanded_need_not_be_asked_again():
    driver = robot()
    assert driver.needs_asking(1.0)
    driver.command(1.0)
    assert not driver.needs_asking(1.05)
    tell(driver, 1.05, vx=0.2)
    assert driver.needs_asking(1.05)
    driver.command(1.05)
    tell(driver, 1.3, vx=0.2)
    assert not driver.needs_asking(1.8)
    assert driver.needs_asking(1.85)
