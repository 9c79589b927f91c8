"""Loose bodies in the arena: small boxes, coloured by kind."""

from __future__ import annotations

from typing import List, NamedTuple, Sequence, Tuple

from rqt_mrta_py.hooks import BodySight
from rqt_mrta_py.model import Pose
from rqt_mrta_py.render.canvas import Canvas, Point
from rqt_mrta_py.render.floor import ArenaMap, somewhere
from rqt_mrta_py.render.palette import BODY_COLOURS, INK, Colour

__all__ = ["PlacedBody", "draw_bodies", "place_bodies"]

_SMALLEST = 3.5
"""Half the width of the smallest box drawn [pixels]."""


class PlacedBody(NamedTuple):
    """A box to be drawn: its centre from the map's upper left corner, half its width [pixels], its colour."""

    centre: Point
    half: float
    colour: Colour


def place_bodies(bodies: Sequence[BodySight], place: ArenaMap) -> Tuple[Sequence[PlacedBody], Sequence[PlacedBody]]:
    """Say where boxes are drawn, one for each body that is anywhere near.

    Args:
        bodies: all of them; kinds have their colours by the order of their names.
        place: from metres to pixels.

    Returns:
        Those that lie about, then those that are held.
    """
    kinds = {kind: number for number, kind in enumerate(sorted({body.kind for body in bodies}))}
    lying: List[PlacedBody] = []
    held: List[PlacedBody] = []
    for body in bodies:
        pose = somewhere(Pose(body.x, body.y))
        if pose is not None:
            half = max(body.width * place.scale / 2.0, _SMALLEST)
            colour = BODY_COLOURS[kinds[body.kind] % len(BODY_COLOURS)]
            (held if body.held else lying).append(PlacedBody(place.inside(pose), half, colour))
    return lying, held


def draw_bodies(canvas: Canvas, bodies: Sequence[PlacedBody]) -> None:
    """Draw boxes.

    Args:
        canvas: of the map.
        bodies: to be drawn.
    """
    for (x, y), half, colour in bodies:
        corners = [(x - half, y - half), (x + half, y - half), (x + half, y + half), (x - half, y + half)]
        canvas.polygon(corners, colour)
        canvas.line(corners, INK, closed=True)
