"""What this room brings, registered like anything that strangers bring."""

from __future__ import annotations

from typing import Mapping

from rqt_mrta_py.hooks import (
    Link,
    LinkFactory,
    LinkSetup,
    RobotModel,
    Sensor,
    SensorContext,
    SensorFactory,
    World,
    WorldFactory,
    hookimpl,
)

__all__ = ["mrta_register_links", "mrta_register_robot_models", "mrta_register_sensors", "mrta_register_worlds"]


@hookimpl
def mrta_register_worlds() -> Mapping[str, WorldFactory]:
    """Name the worlds of this room."""
    return {"bullet": _bullet, "planar": _planar}


@hookimpl
def mrta_register_robot_models() -> Mapping[str, RobotModel]:
    """Name the robot models of this room."""
    from rqt_mrta_py.sim.robot_models import DIFF_DRIVE, OMNI_DRIVE

    return {model.name: model for model in (DIFF_DRIVE, OMNI_DRIVE)}


@hookimpl
def mrta_register_sensors() -> Mapping[str, SensorFactory]:
    """Name the sensors of this room."""
    return {"localiser": _localiser, "odometry": _odometry, "range_finder": _range_finder}


@hookimpl
def mrta_register_links() -> Mapping[str, LinkFactory]:
    """Name the radios of this room."""
    return {"lossy": _lossy, "perfect": _perfect}


def _bullet() -> World:
    from rqt_mrta_py.sim.bullet import BulletWorld

    return BulletWorld()


def _planar() -> World:
    from rqt_mrta_py.sim.planar import PlanarWorld

    return PlanarWorld()


def _localiser(context: SensorContext) -> Sensor:
    from rqt_mrta_py.sim.sensors import Localiser

    return Localiser(context)


def _odometry(context: SensorContext) -> Sensor:
    from rqt_mrta_py.sim.sensors import Odometry

    return Odometry(context)


def _range_finder(context: SensorContext) -> Sensor:
    from rqt_mrta_py.sim.sensors import RangeFinder

    return RangeFinder(context)


def _lossy(setup: LinkSetup) -> Link:
    from rqt_mrta_py.sim.radio import LossyLink

    return LossyLink(setup)


def _perfect(setup: LinkSetup) -> Link:
    from rqt_mrta_py.sim.radio import PerfectLink

    return PerfectLink.of(setup)
