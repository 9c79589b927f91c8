from __future__ import annotations

import math

import numpy as np
import pytest

from rqt_mrta_py.errors import SimError
from rqt_mrta_py.hooks import Heard, Outgoing
from rqt_mrta_py.model import Pose, RobotSetup, SensorSetup, Twist
from rqt_mrta_py.sim.mount import cast_together
from rqt_mrta_py.sim.plugin import mrta_register_sensors
from rqt_mrta_py.sim.robot_models import DIFF_DRIVE
from rqt_mrta_py.sim.simulated_robot import SimulatedRobot
from tests.sim.doubles import StillWorld

START = Pose(1.0, 2.0, 0.5)
WORLD = StillWorld(seen=[1.5])
SENSORS = (
    SensorSetup("odometry", "odom", 10.0),
    SensorSetup("range_finder", "scan", 5.0),
    SensorSetup("localiser", "pose", 20.0),
)


def robot(sensors=SENSORS, factories=None):
    setup = RobotSetup("robot1", "diff_drive", START, tuple(sensors))
    known = mrta_register_sensors() if factories is None else factories
    return SimulatedRobot(setup, DIFF_DRIVE, known, 20, np.random.default_rng(1))


def tell(driver, at, vx=0.0, vy=0.0, wz=0.0):
    ((subscription, hear),) = driver.listeners()
    fields = {"linear/x": vx, "linear/y": vy, "angular/z": wz}
    hear(Heard("/robot1/cmd_vel", subscription.type, at, fields))


def sense(driver, tick):
    due = driver.due(tick)
    return driver.sense(tick / 20 + 1, START, due, cast_together(WORLD, "still", due), WORLD)


def topics(driver, tick):
    return [outgoing.topic for outgoing in sense(driver, tick)]


def test_robot_hears_cmd_vel_in_its_own_namespace():
    driver = robot()
    ((subscription, _),) = driver.listeners()
    assert driver.node == "/robot1/driver"
    assert (subscription.topic, subscription.type) == ("cmd_vel", "geometry_msgs/Twist")
    assert set(subscription.fields) == {"linear/x", "linear/y", "angular/z"}


def test_robot_runs_each_sensor_at_its_rate_in_file_order_with_transforms_last():
    driver = robot()
    heard = [topics(driver, tick) for tick in range(5)]
    full = ["odom", "scan", "pose", "/tf"]
    assert heard == [full, ["pose"], ["odom", "pose", "/tf"], ["pose"], full]


def test_robot_without_sensors_says_nothing():
    assert topics(robot(sensors=()), 0) == []


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


def test_stopped_robot_is_silent_still_and_deaf():
    driver = robot()
    tell(driver, 1.0, vx=0.3)
    driver.stop()
    assert driver.is_stopped
    assert topics(driver, 0) == []
    assert driver.command(1.0) == Twist()
    tell(driver, 1.1, vx=0.3)
    driver.resume()
    assert driver.command(1.1) == Twist()
    assert topics(driver, 4) == ["odom", "scan", "pose", "/tf"]
    tell(driver, 1.2, vx=0.3)
    assert driver.command(1.2) == Twist(0.3, 0.0, 0.0)


def test_robot_takes_sensors_that_strangers_bring():
    class Thermometer:
        def __init__(self, context):
            self.topic = context.setup.topic
            self.rays = None

        def sense(self, moment):
            return (Outgoing(self.topic, "sensor_msgs/Temperature", {"temperature": 20.0 + moment.truth.x}),)

    driver = robot([SensorSetup("thermometer", "warmth", 1.0)], {"thermometer": Thermometer})
    (outgoing,) = sense(driver, 0)
    assert outgoing == Outgoing("warmth", "sensor_msgs/Temperature", {"temperature": 21.0})


def test_robot_tells_the_problems_of_all_its_sensors_at_once():
    sensors = [
        SensorSetup("odometry", "odom", 50.0),
        SensorSetup("localiser", "pose", 10.0, {"position_noise": -1}),
        SensorSetup("range_finder", "scan", 10.0, {"rays": 2.5}),
    ]
    with pytest.raises(SimError) as caught:
        robot(sensors)
    assert str(caught.value).splitlines() == [
        "robot robot1: sensor odometry on odom: rate must be above 0, at most the control rate of 20 Hz (got 50.0)",
        "robot robot1: sensor localiser on pose: parameter position_noise: must be a number at least 0 (got -1)",
        "robot robot1: sensor range_finder on scan: parameter rays: must be a whole number from 1 to 3600 (got 2.5)",
    ]
