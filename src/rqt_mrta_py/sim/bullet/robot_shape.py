"""What a robot of BulletWorld looks like: a box, perhaps on wheels and casters, all in the frame of its body.

A differential drive is one compound shape with its casters, the wheels are spheres: two links instead of four bodies.
Casters at the height of the wheels would carry most of the weight and let the wheels skid, so they stand off the floor.
"""

from __future__ import annotations

from typing import NamedTuple, Tuple

from rqt_mrta_py.hooks import RobotModel

__all__ = ["Ball", "RobotShape", "shape_of", "shape_of_mecanum"]

_GROUND_CLEARANCE = 0.01
"""From the top of the wheels' radius to the underside of the body [m]."""
_CASTER_CLEARANCE = 0.001
_CASTER_INSET = 0.01
_CENTRE_OF_MASS_DROP = 0.01
"""How far the centre of mass lies below the middle of the body [m]."""

_Vector = Tuple[float, float, float]


class Ball(NamedTuple):
    """A wheel or a caster: centre and radius [m]."""

    centre: _Vector
    radius: float


class RobotShape(NamedTuple):
    """A robot in the frame of its body, whose origin is the centre of mass.

    Attributes:
        frame_height: of the origin above the floor while the robot stands [m].
        box_centre: [m].
        box_half_size: half of length, width, height [m].
        wheels: left and right; none of a mecanum drive.
        casters: front and rear; none of a mecanum drive.
    """

    frame_height: float
    box_centre: _Vector
    box_half_size: _Vector
    wheels: Tuple[Ball, ...]
    casters: Tuple[Ball, ...]


def shape_of(model: RobotModel) -> RobotShape:
    """Give the shape of a model's robots, which have a differential drive."""
    underside = model.wheel_radius + _GROUND_CLEARANCE
    frame_height = (underside + model.height) / 2 - _CENTRE_OF_MASS_DROP
    wheel_drop = model.wheel_radius - frame_height
    caster_radius = underside / 2
    caster_x = model.length / 2 - caster_radius - _CASTER_INSET
    caster_z = caster_radius + _CASTER_CLEARANCE - frame_height
    return RobotShape(
        frame_height=frame_height,
        box_centre=(0.0, 0.0, _CENTRE_OF_MASS_DROP),
        box_half_size=(model.length / 2, model.width / 2, (model.height - underside) / 2),
        wheels=(
            Ball((0.0, model.track / 2, wheel_drop), model.wheel_radius),
            Ball((0.0, -model.track / 2, wheel_drop), model.wheel_radius),
        ),
        casters=(Ball((caster_x, 0.0, caster_z), caster_radius), Ball((-caster_x, 0.0, caster_z), caster_radius)),
    )


def shape_of_mecanum(model: RobotModel) -> RobotShape:
    """Give the shape of a model's robots, which have a mecanum drive: a chassis around its wheels."""
    return RobotShape(
        frame_height=(_GROUND_CLEARANCE + model.height) / 2,
        box_centre=(0.0, 0.0, 0.0),
        box_half_size=(model.length / 2, model.width / 2, (model.height - _GROUND_CLEARANCE) / 2),
        wheels=(),
        casters=(),
    )
