"""From where a block is placed: headings along the axes, across the block's longer side."""

from __future__ import annotations

import math
from typing import NamedTuple, Tuple

from block_construction.diagram.diagram import PlacedBlock
from block_construction.execution.arena import Arena, Point, Site
from rqt_mrta_py.hooks import Structure

__all__ = ["SIDES", "Approach", "Side", "approach_from", "sides_of"]


class Side(NamedTuple):
    """A direction along one of the axes, in which a robot stands as seen from the block."""

    x: int
    y: int

    @property
    def opposite(self) -> Side:
        """The other side."""
        return Side(-self.x, -self.y)

    @property
    def heading_deg(self) -> int:
        """Heading of a robot that stands there and faces the block: 0, 90, 180 or 270 [degrees]."""
        return {(-1, 0): 0, (0, -1): 90, (1, 0): 180, (0, 1): 270}[(self.x, self.y)]


SIDES = (Side(0, -1), Side(0, 1), Side(-1, 0), Side(1, 0))
"""Below, above, left and right, as seen on a map."""

_BELOW, _ABOVE, _LEFT, _RIGHT = SIDES


class Approach(NamedTuple):
    """Where a robot stands to place a block.

    Attributes:
        point: where [m].
        side: on which side of the block.
    """

    point: Point
    side: Side

    @property
    def heading(self) -> float:
        """Of the robot [rad]."""
        return math.radians(self.side.heading_deg)


def sides_of(block: PlacedBlock, structure: Structure) -> Tuple[Side, ...]:
    """List the sides from which a block can be placed, those that face out of the structure first.

    The magnet holds a block by its longer side, so a block along x is placed from below or above, one along y from
    left or right, and one of a single unit from everywhere. Sides that face out are those of the concentric layer
    that the block lies on.

    Args:
        block: of the structure's diagram.
        structure: whose bounds say what is out.
    """
    cell, layer = block.placement, block.layer
    faces = (
        (_BELOW, cell.y == layer),
        (_ABOVE, cell.y == structure.rows - layer + 1),
        (_LEFT, cell.x == layer),
        (_RIGHT, cell.x == structure.columns - layer + 1),
    )
    across = faces if block.units == 1 else (faces[:2] if cell.length > 0 else faces[2:])
    return tuple(side for wanted in (True, False) for side, out in across if out is wanted)


def approach_from(block: PlacedBlock, side: Side, arena: Arena, site: Site) -> Approach:
    """Give where a robot stands to place a block from one of its sides.

    Args:
        block: in its structure's own coordinates.
        side: as seen from the block.
        arena: says how far off.
        site: where the structure stands.
    """
    x, y = site.left + block.x, site.bottom + block.y
    return Approach(Point(x + side.x * arena.stand_off, y + side.y * arena.stand_off), side)
