"""What this room brings, registered like anything that strangers bring."""

from __future__ import annotations

from typing import Mapping, Sequence

from rqt_mrta_py.hooks import (
    Link,
    LinkFactory,
    LinkSetup,
    RobotModel,
    Sensor,
    SensorContext,
    SensorFactory,
    TeamSensor,
    TeamSensorFactory,
    World,
    WorldFactory,
    hookimpl,
)

__all__ = [
    "mrta_register_links",
    "mrta_register_robot_models",
    "mrta_register_sensors",
    "mrta_register_team_sensors",
    "mrta_register_worlds",
]


@hookimpl
def mrta_register_worlds() -> Mapping[str, WorldFactory]:
    """Name the worlds of this room."""
    return {"bullet": _bullet, "planar": _planar}


@hookimpl
def mrta_register_robot_models() -> Mapping[str, RobotModel]:
    """Name the robot models of this room."""
    from rqt_mrta_py.sim.robot_models import (
        CARRIER,
        DIFF_DRIVE,
        MECANUM_ARM,
        OMNI_DRIVE,
        SMALL_DIFF_DRIVE,
        STRONG_CARRIER,
    )

    models = (CARRIER, DIFF_DRIVE, MECANUM_ARM, OMNI_DRIVE, SMALL_DIFF_DRIVE, STRONG_CARRIER)
    return {model.name: model for model in models}


@hookimpl
def mrta_register_sensors() -> Mapping[str, SensorFactory]:
    """Name the sensors of this room that measure robot by robot."""
    return {"bumper": _bumper, "detector": _detector}


@hookimpl
def mrta_register_team_sensors() -> Mapping[str, TeamSensorFactory]:
    """Name the sensors of this room that measure on many robots at once."""
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


def _bumper(context: SensorContext) -> Sensor:
    from rqt_mrta_py.sim.sensors import Bumper

    return Bumper(context)


def _detector(context: SensorContext) -> Sensor:
    from rqt_mrta_py.sim.sensors import Detector

    return Detector(context)


def _localiser(contexts: Sequence[SensorContext]) -> TeamSensor:
    from rqt_mrta_py.sim.sensors import Localiser

    return Localiser(contexts)


def _odometry(contexts: Sequence[SensorContext]) -> TeamSensor:
    from rqt_mrta_py.sim.sensors import Odometry

    return Odometry(contexts)


def _range_finder(contexts: Sequence[SensorContext]) -> TeamSensor:
    from rqt_mrta_py.sim.sensors import RangeFinder

    return RangeFinder(contexts)


def _lossy(setup: LinkSetup) -> Link:
    from rqt_mrta_py.sim.radio import LossyLink

    return LossyLink(setup)


def _perfect(setup: LinkSetup) -> Link:
    from rqt_mrta_py.sim.radio import PerfectLink

    return PerfectLink.of(setup)
