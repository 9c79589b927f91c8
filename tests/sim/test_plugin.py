from __future__ import annotations

import math

import pluggy
import pytest

from rqt_mrta_py.hooks import PROJECT, HookSpecs
from rqt_mrta_py.sim import plugin
from rqt_mrta_py.sim.bullet import BulletWorld
from rqt_mrta_py.sim.planar import PlanarWorld
from rqt_mrta_py.sim.radio import LossyLink, PerfectLink
from rqt_mrta_py.sim.robot_models import (
    CARRIER,
    DIFF_DRIVE,
    MECANUM_ARM,
    OMNI_DRIVE,
    SMALL_DIFF_DRIVE,
    STRONG_CARRIER,
)
from rqt_mrta_py.sim.sensors import Bumper, Detector, Localiser, Odometry, RangeFinder
from tests.sim.radio.support import link_setup
from tests.sim.sensors.support import context


def test_plugin_keeps_the_contract_and_registers_what_the_room_brings():
    manager = pluggy.PluginManager(PROJECT)
    manager.add_hookspecs(HookSpecs)
    manager.register(plugin)
    manager.check_pending()
    (worlds,) = manager.hook.mrta_register_worlds()
    (models,) = manager.hook.mrta_register_robot_models()
    (sensors,) = manager.hook.mrta_register_sensors()
    (team_sensors,) = manager.hook.mrta_register_team_sensors()
    assert {name: type(factory()) for name, factory in worlds.items()} == {"bullet": BulletWorld, "planar": PlanarWorld}
    assert models == {
        "carrier": CARRIER,
        "diff_drive": DIFF_DRIVE,
        "mecanum_arm": MECANUM_ARM,
        "omni_drive": OMNI_DRIVE,
        "small_diff_drive": SMALL_DIFF_DRIVE,
        "strong_carrier": STRONG_CARRIER,
    }
    kinds = {kind: type(factory(context(kind, "topic"))) for kind, factory in sensors.items()}
    assert kinds == {"bumper": Bumper, "detector": Detector}
    kinds = {kind: type(factory([context(kind, "topic")])) for kind, factory in team_sensors.items()}
    assert kinds == {"localiser": Localiser, "odometry": Odometry, "range_finder": RangeFinder}


@pytest.mark.parametrize("model", [DIFF_DRIVE, SMALL_DIFF_DRIVE, CARRIER, STRONG_CARRIER], ids=lambda model: model.name)
def test_robot_on_two_wheels_fits_into_its_own_radius(model):
    corner = math.hypot(model.length / 2, model.width / 2)
    wheel = model.track / 2 + model.wheel_radius
    assert max(corner, wheel) <= model.radius
    assert 2 * model.wheel_radius < model.sensor_height < model.height


def test_strong_carrier_takes_more_and_is_slower_and_larger_than_a_carrier():
    assert STRONG_CARRIER.max_load > CARRIER.max_load > 0.0
    assert STRONG_CARRIER.max_speed < CARRIER.max_speed
    assert STRONG_CARRIER.radius > CARRIER.radius
    assert STRONG_CARRIER.capabilities - CARRIER.capabilities == {"carry:heavy"}


def test_all_robots_see_in_one_plane():
    assert {model.sensor_height for model in plugin.mrta_register_robot_models().values()} == {0.12}


def test_omni_drive_fits_into_its_own_radius_wheels_and_all():
    assert math.hypot(OMNI_DRIVE.length / 2, OMNI_DRIVE.width / 2) <= OMNI_DRIVE.radius
    assert OMNI_DRIVE.track <= OMNI_DRIVE.width
    assert 2 * OMNI_DRIVE.wheel_radius < OMNI_DRIVE.sensor_height < OMNI_DRIVE.height


def test_mecanum_arm_fits_into_its_own_radius_with_its_arm_up():
    assert math.hypot(MECANUM_ARM.length / 2, MECANUM_ARM.width / 2) <= MECANUM_ARM.radius
    assert MECANUM_ARM.arm.reach_at(math.pi / 2) == pytest.approx(MECANUM_ARM.radius)
    assert MECANUM_ARM.track <= MECANUM_ARM.width
    assert MECANUM_ARM.wheelbase + 2 * MECANUM_ARM.wheel_radius <= MECANUM_ARM.length
    assert 2 * MECANUM_ARM.wheel_radius < MECANUM_ARM.sensor_height < MECANUM_ARM.height


@pytest.mark.parametrize("level", range(5))
def test_magnet_of_a_mecanum_arm_reaches_the_middles_of_blocks_of_seven_centimetres_on_five_levels(level):
    angle = MECANUM_ARM.arm.angle_at(0.035 + 0.07 * level)
    assert MECANUM_ARM.arm.height_at(angle) == pytest.approx(0.035 + 0.07 * level)


def test_plugin_registers_the_radios_of_the_room():
    links = plugin.mrta_register_links()
    made = {kind: type(factory(link_setup({}))) for kind, factory in links.items()}
    assert made == {"lossy": LossyLink, "perfect": PerfectLink}
