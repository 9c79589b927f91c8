"""Small ready-made signs for teams and lists of tasks too large to be drawn one by one."""

from __future__ import annotations

import math
from functools import lru_cache
from typing import TYPE_CHECKING, NamedTuple, Optional, Tuple, Union

import numpy as np

from rqt_mrta_py.model import RobotState
from rqt_mrta_py.render.canvas import Canvas, Point
from rqt_mrta_py.render.palette import INK, WHITE, Colour
from rqt_mrta_py.render.signs import diamond, light

if TYPE_CHECKING:
    from numpy.typing import NDArray

__all__ = ["HEADINGS", "LEAST_FOR_NOSE", "RobotStamp", "TaskStamp", "print_stamp"]

HEADINGS = 16
"""So many headings are told apart."""

LEAST_FOR_NOSE = 3.0
"""A light smaller than this has no room for a nose [pixels]."""

_Pixels = Tuple["NDArray[np.uint8]", "NDArray[np.bool_]"]


class RobotStamp(NamedTuple):
    """A robot as a sign: radius [pixels], heading of sixteen, state, colour of the task held or None."""

    radius: float
    heading: int
    state: RobotState
    task: Optional[Colour]


class TaskStamp(NamedTuple):
    """A task's place as a sign: from its centre to a corner [pixels], its colour."""

    radius: float
    colour: Colour


def print_stamp(canvas: Canvas, places: NDArray[np.float64], stamp: Union[RobotStamp, TaskStamp]) -> None:
    """Print a sign at many places, each at whole pixels; what lies beyond the canvas is cut off.

    Args:
        canvas: drawn upon.
        places: of the sign's middle (places, 2) [pixels]; later ones cover earlier ones.
        stamp: which sign.
    """
    picture, shown = _drawn(stamp)
    half = picture.shape[0] // 2
    for x, y in (np.rint(places).astype(np.intp) - half).tolist():
        canvas.paste(x, y, picture, shown)


@lru_cache(maxsize=2048)
def _drawn(stamp: Union[RobotStamp, TaskStamp]) -> _Pixels:
    """Draw a sign with a white border one pixel wide; give it with where it covers what is below."""
    half = math.ceil(stamp.radius + (3.0 if isinstance(stamp, TaskStamp) or stamp.radius < LEAST_FOR_NOSE else 7.0))
    picture = np.full((2 * half + 1, 2 * half + 1, 3), 255, dtype=np.uint8)
    cover = np.zeros((2 * half + 1, 2 * half + 1, 3), dtype=np.uint8)
    for image, plain in ((picture, False), (cover, True)):
        canvas = Canvas(image)
        if isinstance(stamp, TaskStamp):
            diamond(canvas, (half, half), stamp.radius + plain, WHITE if plain else stamp.colour)
        else:
            _draw_robot(canvas, (half, half), stamp, plain)
    return picture, cover > 127


def _draw_robot(canvas: Canvas, centre: Point, stamp: RobotStamp, plain: bool) -> None:
    """Draw a robot's light, ring and nose; plain: all in white, a pixel larger."""
    x, y = centre
    grown, ink = (1.0, WHITE) if plain else (0.0, INK)
    ring = stamp.radius + (1.8 if stamp.task else 0.6)
    if stamp.radius >= LEAST_FOR_NOSE:
        yaw = 2.0 * math.pi * stamp.heading / HEADINGS
        cos, sin = math.cos(yaw), -math.sin(yaw)
        tip, half = ring + 3.5 + grown, 0.7 * stamp.radius + grown
        corners = [(x + tip * cos, y + tip * sin), (x - half * sin, y + half * cos), (x + half * sin, y - half * cos)]
        canvas.polygon(corners, ink)
    canvas.disc(centre, ring + grown, WHITE if plain else stamp.task or INK)
    if not plain:
        light(canvas, centre, stamp.radius - 0.6, stamp.state)
