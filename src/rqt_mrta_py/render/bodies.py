"""Loose bodies in the arena: boxes of their size and turn, coloured by kind, paler the higher they lie."""

from __future__ import annotations

import math
from typing import List, NamedTuple, Sequence, Tuple

from rqt_mrta_py.hooks import BodySight
from rqt_mrta_py.model import Pose
from rqt_mrta_py.render.canvas import Canvas, Point
from rqt_mrta_py.render.floor import ArenaMap, somewhere
from rqt_mrta_py.render.palette import BODY_COLOURS, INK, WHITE, Colour, mix

__all__ = ["PlacedBody", "draw_bodies", "place_bodies"]

_SMALLEST = 3.5
"""Half the length or width of the smallest box drawn [pixels]."""
_PALEST = 0.7
_HIGHEST = 0.3
"""What lies so high, or higher, is palest [m]."""


class PlacedBody(NamedTuple):
    """A box to be drawn: its four corners from the map's upper left corner [pixels], and its colour."""

    corners: Tuple[Point, ...]
    colour: Colour


def place_bodies(bodies: Sequence[BodySight], place: ArenaMap) -> Tuple[Sequence[PlacedBody], Sequence[PlacedBody]]:
    """Say where boxes are drawn, one for each body that is anywhere near; what lies higher comes later.

    Args:
        bodies: all of them; kinds have their colours by the order of their names.
        place: from metres to pixels.

    Returns:
        Those that lie about, then those that are held.
    """
    kinds = {kind: number for number, kind in enumerate(sorted({body.kind for body in bodies}))}
    lying: List[PlacedBody] = []
    held: List[PlacedBody] = []
    for body in sorted(bodies, key=lambda each: each.lift):
        pose = somewhere(Pose(body.x, body.y))
        if pose is not None:
            colour = BODY_COLOURS[kinds[body.kind] % len(BODY_COLOURS)]
            paleness = 0.0 if body.held else _PALEST * min(body.lift / _HIGHEST, 1.0)
            placed = PlacedBody(_corners(body, place.inside(pose), place.scale), mix(colour, WHITE, paleness))
            (held if body.held else lying).append(placed)
    return lying, held


def draw_bodies(canvas: Canvas, bodies: Sequence[PlacedBody]) -> None:
    """Draw boxes.

    Args:
        canvas: of the map.
        bodies: to be drawn.
    """
    for corners, colour in bodies:
        canvas.polygon(corners, colour)
        canvas.line(corners, INK, closed=True)


def _corners(body: BodySight, centre: Point, scale: float) -> Tuple[Point, ...]:
    """Give the corners of a box in turn; on pictures y grows downwards."""
    ahead, aside = (max(side * scale / 2.0, _SMALLEST) for side in (body.length, body.width))
    cos, sin = math.cos(body.yaw), math.sin(body.yaw)
    return tuple(
        (centre[0] + x * ahead * cos - y * aside * sin, centre[1] - x * ahead * sin - y * aside * cos)
        for x, y in ((-1, -1), (1, -1), (1, 1), (-1, 1))
    )
